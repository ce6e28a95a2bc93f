#include "report/modes_uff.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "acquire/formats/uff/uff_trace_lines.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "report/svg/plot_geometry.hpp"

namespace percuss::report {
namespace {

using Vector = std::array<Complex, 3>;
using Nodes = std::map<int, Vector>;  // by label

constexpr int kComplexSingle = 5, kNodeColour = 11, kTranslations = 2, kComplexModes = 3, kDisplacement = 8;

Nodes nodes_of(const identify::ModeShape& shape, const PlotMesh* mesh, const pipeline::Survey* survey,
               const pipeline::Analysis& analysis, bool at_sensors, int offset) {
  Nodes out;
  for (const identify::ShapePlace& place : shape.places) {
    const auto normal = response_direction(mesh, survey, analysis, place.point, place.channel, at_sensors);
    Vector& value = out[acquire::place_of_point(analysis.record().motions, static_cast<int>(place.point)) + offset];
    for (std::size_t i = 0; i < 3; ++i) value[i] += place.value * normal[i];
  }
  return out;
}

std::string values_text(const Nodes& nodes) {
  std::string out;
  for (const auto& [node, value] : nodes) {
    out += fmt::format("{:10}\n", node);
    for (const Complex& component : value)
      out += acquire::uff_e13(component.real()) + acquire::uff_e13(component.imag());
    out += '\n';
  }
  return out;
}

struct UffMode {
  std::size_t number;  // from 1
  identify::Pole pole;
  double modal_mass_kg;
};

// λ = −ζω + jω√(1 − ζ²)                                                                              (1)
Complex eigenvalue(const identify::Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  return {-zeta * omega, omega * std::sqrt(std::max(0.0, 1 - zeta * zeta))};
}

// Modal A of a shape with modal mass m: 2jω√(1 − ζ²)·m                                               (2)
Complex modal_a(const UffMode& mode) { return Complex(0, 2 * eigenvalue(mode.pole).imag()) * mode.modal_mass_kg; }

std::string numbers_text(std::initializer_list<double> values) {
  std::string out;
  for (const double value : values) out += acquire::uff_e13(value);
  return out + '\n';
}

std::string mode_title(const UffMode& mode) {
  return fmt::format("Mode {}: {:.6g} Hz, {:.4g} %", mode.number, mode.pole.freq_Hz, 100 * mode.pole.damping_ratio);
}

std::string set55(const UffMode& mode, const Nodes& nodes) {
  const Complex lambda = eigenvalue(mode.pole), a = modal_a(mode);
  std::string out = mode_title(mode) + "\nNONE\nNONE\nNONE\nNONE\n";
  out += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, kComplexModes, kTranslations, kDisplacement, kComplexSingle,
                     3);
  out += fmt::format("{:10}{:10}{:10}{:10}\n", 2, 6, 1, mode.number);
  out += numbers_text({lambda.real(), lambda.imag(), a.real(), a.imag(), 0, 0});
  return out + values_text(nodes);
}

std::string set2414(const UffMode& mode, const Nodes& nodes) {
  const Complex lambda = eigenvalue(mode.pole), a = modal_a(mode);
  std::string out = fmt::format("{:10}\n{}\n{:10}\n", mode.number, mode_title(mode), 1);
  out += mode_title(mode) + "\nNONE\nNONE\nNONE\nNONE\n";
  out += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, kComplexModes, kTranslations, kDisplacement, kComplexSingle,
                     3);
  out += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}{:10}{:10}\n", 0, 0, 0, 0, 1, mode.number, 0, 0);
  out += fmt::format("{:10}{:10}\n", 0, 0);
  const double omega = kTwoPi * mode.pole.freq_Hz;
  out += numbers_text({0, mode.pole.freq_Hz, omega * omega, mode.modal_mass_kg, mode.pole.damping_ratio, 0});
  out += numbers_text({lambda.real(), lambda.imag(), a.real(), a.imag(), 0, 0});
  return out + values_text(nodes);
}

// Writes the positions of the points, their lines and faces, or nothing if one position is not known.
void write_places(acquire::UffOutput& out, const PlotMesh& mesh, const Nodes& nodes, int offset) {
  if (mesh.points.size() != nodes.size()) return;
  std::string set15, set2411;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const int node = mesh.number[i] + offset;
    const auto& at = mesh.points[i];
    set15 += fmt::format("{:10}{:10}{:10}{:10}{}{}{}\n", node, 0, 0, kNodeColour, acquire::uff_e13(at[0]),
                         acquire::uff_e13(at[1]), acquire::uff_e13(at[2]));
    set2411 += fmt::format("{:10}{:10}{:10}{:10}\n{}{}{}\n", node, 0, 0, kNodeColour, acquire::uff_d25(at[0]),
                           acquire::uff_d25(at[1]), acquire::uff_d25(at[2]));
  }
  out.set(15, set15);
  out.set(2411, set2411);
  std::vector<acquire::TraceLine> lines;
  for (const auto& [from, to] : mesh.lines) lines.push_back({mesh.number[from], mesh.number[to]});
  for (const std::string& line : acquire::uff_trace_line_sets(lines, offset)) out.set(82, line);
  std::vector<acquire::TraceFace> faces;
  for (const auto& face : mesh.faces) {
    faces.emplace_back();
    for (const std::size_t corner : face) faces.back().push_back(mesh.number[corner]);
  }
  const std::string elements = acquire::uff_element_lines(faces, offset);
  if (!elements.empty()) out.set(2412, elements);
}

void write_shapes(const std::string& path, const pipeline::Survey* survey, const pipeline::Analysis& analysis,
                  const std::vector<identify::ModeShape>& shapes, bool sensors, bool force) {
  const auto& modes = survey == nullptr ? analysis.modes() : survey->modes();
  if (modes.empty()) throw InputError("no modes to write", path, "widen the band, or write .json", {"band"});
  const int offset = acquire::uff_node_offset(analysis.frf_points().front());
  const PlotMesh mesh = survey == nullptr ? PlotMesh{} : plot_mesh(*survey);
  const PlotMesh* const places = survey == nullptr ? nullptr : &mesh;
  acquire::UffOutput out(path, force);
  out.header();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Nodes nodes = nodes_of(shapes[m], places, survey, analysis, sensors, offset);
    if (m == 0 && survey != nullptr) write_places(out, mesh, nodes, offset);
    const UffMode mode{m + 1, modes[m].pole,
                       shapes[m].normalisation == identify::Normalisation::unit_modal_mass ? 1.0 : 0.0};
    out.set(55, set55(mode, nodes));
    out.set(2414, set2414(mode, nodes));
  }
  out.commit();
}

}  // namespace

void write_modes_uff(const std::string& path, const pipeline::Survey& survey, bool force) {
  const bool sensors = survey.roving() == identify::Roving::sensor;
  write_shapes(path, &survey, survey.analysis(), survey.shapes(), sensors, force);
}

void write_modes_uff(const std::string& path, const pipeline::Analysis& analysis, bool force) {
  const bool sensors = analysis.frf_points().size() == 1 || analysis.record().sensor_roves;
  std::vector<identify::ModeShape> shapes;
  for (const identify::Mode& mode : analysis.modes()) {
    shapes.push_back(
        identify::shape_of(mode, {.roving = sensors ? identify::Roving::sensor : identify::Roving::hammer}));
  }
  write_shapes(path, nullptr, analysis, shapes, sensors, force);
}

}  // namespace percuss::report
