#include "report/gltf/shapes_glb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.hpp"
#include "core/units.hpp"
#include "report/gltf/glb_buffer.hpp"
#include "report/text/number_format.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = GlbBuffer::Json;
using Colour = std::array<std::uint8_t, 4>;

constexpr int kPoints = 0, kLines = 1, kTriangles = 4;      // glTF's modes of primitives
constexpr std::size_t kColoured = 0, kDark = 1, kGrey = 2;  // materials
constexpr std::size_t kSteps = 24;                          // of a cycle
constexpr double kCycle_s = 2;
constexpr double kDrawnAmplitude = 0.15;  // of the structure's size
constexpr double kSpacing = 1.4;          // from mode to mode, of the structure's size

// Accessors that all modes share.
struct SharedParts {
  std::size_t positions = 0, times = 0, weights = 0;
  std::optional<std::size_t> lines, triangles;
};

double size_of(const std::vector<std::array<double, 3>>& points) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [&](const auto& a, const auto& b) { return a.at(i) < b.at(i); });
    size = std::max(size, high->at(i) - low->at(i));
  }
  return size > 0 ? size : 1;
}

SharedParts add_shared_parts(const PlotMesh& mesh, GlbBuffer& buffer) {
  std::vector<std::size_t> lines, triangles;
  for (const auto& line : mesh.lines) lines.insert(lines.end(), line.begin(), line.end());
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) triangles.insert(triangles.end(), {face[0], face[i - 1], face[i]});
  }
  std::vector<double> times, weights;
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double cycle = static_cast<double>(i) / kSteps;
    times.push_back(kCycle_s * cycle);
    weights.push_back(std::cos(kTwoPi * cycle));
    weights.push_back(std::sin(kTwoPi * cycle));
  }
  SharedParts parts{.positions = buffer.add_vectors(mesh.points), .lines = {}, .triangles = {}};
  parts.times = buffer.add_scalars(times);
  parts.weights = buffer.add_scalars(weights);
  if (!lines.empty()) parts.lines = buffer.add_indices(lines);
  if (!triangles.empty()) parts.triangles = buffer.add_indices(triangles);
  return parts;
}

// Blue for a deflection along the normal, vermilion against it, nearly white at rest: the colours of the page.
std::vector<Colour> colours_of(const WireframeMode& mode, const PlotMesh& mesh) {
  constexpr std::array<double, 3> kRest{240, 240, 240}, kPlus{0, 114, 178}, kMinus{213, 94, 0};
  std::vector<Colour> out;
  for (std::size_t i = 0; i < mode.moves.size(); ++i) {
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) along += mode.moves[i].at(k).real() * mesh.normals[i].at(k);
    const auto& strong = along < 0 ? kMinus : kPlus;
    Colour colour{0, 0, 0, 255};
    for (std::size_t k = 0; k < 3; ++k) {
      colour.at(k) = static_cast<std::uint8_t>(
          std::lround(kRest.at(k) + std::min(1.0, std::abs(along)) * (strong.at(k) - kRest.at(k))));
    }
    out.push_back(colour);
  }
  return out;
}

Json primitive(const Json& attributes, int mode, std::optional<std::size_t> indices, std::size_t material) {
  Json out{{"attributes", attributes}, {"mode", mode}, {"material", material}};
  if (indices) out["indices"] = *indices;
  return out;
}

Json mesh_json(const WireframeMode& mode, const PlotMesh& mesh, const SharedParts& parts, double scale,
               GlbBuffer& buffer) {
  std::vector<std::array<double, 3>> cosine, sine;
  for (const auto& move : mode.moves) {
    cosine.push_back({scale * move[0].real(), scale * move[1].real(), scale * move[2].real()});
    sine.push_back({-scale * move[0].imag(), -scale * move[1].imag(), -scale * move[2].imag()});
  }
  const Json targets =
      Json::array({Json{{"POSITION", buffer.add_vectors(cosine)}}, Json{{"POSITION", buffer.add_vectors(sine)}}});
  const Json plain{{"POSITION", parts.positions}};
  Json coloured = plain, primitives = Json::array();
  coloured["COLOR_0"] = buffer.add_colours(colours_of(mode, mesh));
  if (parts.triangles) primitives.push_back(primitive(coloured, kTriangles, parts.triangles, kColoured));
  if (parts.lines) {
    primitives.push_back(parts.triangles ? primitive(plain, kLines, parts.lines, kDark)
                                         : primitive(coloured, kLines, parts.lines, kColoured));
  }
  if (primitives.empty()) primitives.push_back(primitive(coloured, kPoints, std::nullopt, kColoured));
  for (Json& each : primitives) each["targets"] = targets;
  return {{"name", mode.name}, {"primitives", std::move(primitives)}, {"weights", {1, 0}}};
}

Json materials_json() {
  const auto material = [](const char* name, const std::array<double, 4>& colour) {
    return Json{{"name", name},
                {"doubleSided", true},
                {"pbrMetallicRoughness", {{"baseColorFactor", colour}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
                {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
  };
  return Json::array({material("deflection", {1, 1, 1, 1}), material("lines", {0.05, 0.05, 0.05, 1}),
                      material("at rest", {0.5, 0.5, 0.5, 1})});
}

Json animation_json(const std::string& name, std::size_t node, const SharedParts& parts) {
  return {
      {"name", name},
      {"samplers", Json::array({Json{{"input", parts.times}, {"interpolation", "LINEAR"}, {"output", parts.weights}}})},
      {"channels", Json::array({Json{{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}}})}};
}

}  // namespace

std::string frame_glb(const Wireframe& frame) {
  GlbBuffer buffer;
  const SharedParts parts = add_shared_parts(frame.mesh, buffer);
  const double size = size_of(frame.mesh.points), scale = kDrawnAmplitude * size;
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(frame.modes.size()))));
  Json meshes = Json::array(), nodes = Json::array(), children = Json::array(), animations = Json::array();
  meshes.push_back({{"name", "at rest"},
                    {"primitives", Json::array({primitive({{"POSITION", parts.positions}},
                                                          parts.lines ? kLines : kPoints, parts.lines, kGrey)})}});
  nodes.push_back(nullptr);  // the root, completed below
  for (std::size_t m = 0; m < frame.modes.size(); ++m) {
    const WireframeMode& mode = frame.modes[m];
    const std::string name = fmt::format("{}, {} Hz", mode.name, hertz_text(mode.freq_Hz));
    const std::size_t row = m / columns, column = m % columns;
    const Json place{static_cast<double>(column) * kSpacing * size, -static_cast<double>(row) * kSpacing * size, 0};
    meshes.push_back(mesh_json(mode, frame.mesh, parts, scale, buffer));
    children.push_back(nodes.size());
    animations.push_back(animation_json(name, nodes.size(), parts));
    nodes.push_back(
        {{"name", name},
         {"mesh", meshes.size() - 1},
         {"translation", place},
         {"extras",
          {{"frequency_hz", mode.freq_Hz}, {"damping_ratio", mode.damping_ratio}, {"displacement_scale", scale}}}});
    children.push_back(nodes.size());
    nodes.push_back({{"name", name + ", at rest"}, {"mesh", 0}, {"translation", place}});
  }
  const double half = std::sqrt(0.5);
  nodes[0] = {
      {"name", "mode shapes"}, {"rotation", {-half, 0, 0, half}}, {"children", std::move(children)}};  // z is up
  return buffer.file({{"asset", {{"version", "2.0"}, {"generator", fmt::format("percuss {}", version())}}},
                      {"extensionsUsed", {"KHR_materials_unlit"}},
                      {"scene", 0},
                      {"scenes", Json::array({Json{{"nodes", {0}}}})},
                      {"nodes", std::move(nodes)},
                      {"meshes", std::move(meshes)},
                      {"materials", materials_json()},
                      {"animations", std::move(animations)}});
}

std::string shapes_glb(const pipeline::Survey& survey) {
  if (survey.shapes().empty())
    throw InputError("no modes to write", survey.analysis().record().source(), "widen the band", {"band"});
  const Wireframe frame = wireframe(survey);
  if (frame.mesh.points.size() < 2) {
    throw InputError("the coordinates of the points are not known, so that no shapes can be drawn",
                     survey.analysis().record().source(), "state the geometry", {"geometry"});
  }
  return frame_glb(frame);
}

}  // namespace percuss::report
