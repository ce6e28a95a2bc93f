#include "report/survey_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "core/units.hpp"
#include "report/svg/plot_geometry.hpp"

namespace percuss::report {
namespace {

void write_numbers(acquire::hdf5::OutputHdf5& out, const std::string& name, const std::vector<double>& values,
                   acquire::hdf5::Stored type = acquire::hdf5::Stored::float64) {
  out.create_set(name, std::array{values.size()}, type);
  if (!values.empty()) out.write(name, {}, 0, std::span<const double>(values));
}

void write_shapes(acquire::hdf5::OutputHdf5& out, const pipeline::Survey& survey) {
  const auto& shapes = survey.shapes();
  const auto& places = shapes.front().places;
  const std::array size{shapes.size(), places.size()};
  out.create_set("shape", size, acquire::hdf5::Stored::complex128);
  out.create_set("shape_std", size);
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    std::vector<Complex> value;
    std::vector<double> std;
    for (const identify::ShapePlace& place : shapes[m].places) {
      value.push_back(place.value);
      std.push_back(place.std);
    }
    out.write("shape", std::array{m}, 0, std::span<const Complex>(value));
    out.write("shape_std", std::array{m}, 0, std::span<const double>(std));
  }
  std::vector<double> scale_std;
  for (const identify::ModeShape& shape : shapes) scale_std.push_back(shape.scale_std);
  write_numbers(out, "scale_std", scale_std);
  std::vector<double> point, channel;
  out.create_set("xyz_m", std::array<std::size_t, 2>{places.size(), 3});
  for (std::size_t i = 0; i < places.size(); ++i) {
    point.push_back(static_cast<double>(places[i].point));
    channel.push_back(static_cast<double>(places[i].channel));
    constexpr double kNoPlace = std::numeric_limits<double>::quiet_NaN();
    const auto xyz = plot_position(survey, places[i].point).value_or(std::array{kNoPlace, kNoPlace, kNoPlace});
    out.write("xyz_m", std::array{i}, 0, std::span<const double>(xyz));
  }
  write_numbers(out, "point", point, acquire::hdf5::Stored::int32);
  write_numbers(out, "channel", channel, acquire::hdf5::Stored::int32);
}

void write_macs(acquire::hdf5::OutputHdf5& out, const pipeline::Survey& survey) {
  const auto& macs = survey.macs();
  for (const char* name : {"auto_mac", "auto_mac_std"}) out.create_set(name, std::array{macs.size(), macs.size()});
  for (std::size_t m = 0; m < macs.size(); ++m) {
    std::vector<double> value, std;
    for (const identify::Mac& mac : macs[m]) {
      value.push_back(mac.value);
      std.push_back(mac.std);
    }
    out.write("auto_mac", std::array{m}, 0, std::span<const double>(value));
    out.write("auto_mac_std", std::array{m}, 0, std::span<const double>(std));
  }
}

void write_cmif(acquire::hdf5::OutputHdf5& out, const pipeline::Survey& survey) {
  const Eigen::MatrixXd& values = survey.indicator();
  const acquire::LineRange band = survey.band();
  write_numbers(out, "cmif_frequency_hz", acquire::frequencies_Hz(band));
  out.create_set("cmif", std::array{band.count, static_cast<std::size_t>(values.cols())});
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    const Eigen::VectorXd line = values.row(k);
    out.write("cmif", std::array{static_cast<std::size_t>(k)}, 0,
              std::span<const double>(line.data(), static_cast<std::size_t>(line.size())));
  }
}

}  // namespace

std::string shapes_csv(const pipeline::Survey& survey) {
  std::string out =
      "mode,frequency_hz,damping_ratio,family,order,point,channel,position_m,angle_deg,x_m,y_m,z_m,re,im,std,scale_"
      "std\n";
  auto end = std::back_inserter(out);
  const auto& modes = survey.modes();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const identify::ModeClassification& classification = survey.classifications()[m];
    for (const identify::ShapePlace& place : survey.shapes()[m].places) {
      fmt::format_to(end, "{},{},{},{},{},{},{},", m, modes[m].pole.freq_Hz, modes[m].pole.damping_ratio,
                     name_of(classification.type),
                     classification.order > 0 ? fmt::format("{}", classification.order) : "", place.point,
                     place.channel);
      const acquire::GeometryPoint* at = survey.geometry_point(place.point);
      const bool tube = at != nullptr && survey.geometry()->tube;
      out += tube ? fmt::format("{},{},", at->position_m, at->angle_rad * kRadian_deg) : ",,";
      const auto xyz = plot_position(survey, place.point);
      out += xyz ? fmt::format("{},{},{},", (*xyz)[0], (*xyz)[1], (*xyz)[2]) : ",,,";
      fmt::format_to(end, "{},{},{},{}\n", place.value.real(), place.value.imag(), place.std,
                     survey.shapes()[m].scale_std);
    }
  }
  return out;
}

std::string cmif_csv(const pipeline::Survey& survey) {
  const Eigen::MatrixXd& values = survey.indicator();
  const acquire::LineRange band = survey.band();
  std::string out = "frequency_hz";
  for (Eigen::Index v = 0; v < values.cols(); ++v) out += fmt::format(",singular_value_{}", v + 1);
  out += '\n';
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    out += fmt::format("{}", band.freq_Hz(static_cast<std::size_t>(k)));
    for (Eigen::Index v = 0; v < values.cols(); ++v) out += fmt::format(",{}", values(k, v));
    out += '\n';
  }
  return out;
}

void write_survey_hdf5(const std::string& path, const pipeline::Survey& survey, bool force) {
  const auto& modes = survey.modes();
  std::vector<double> freq_Hz, damping;
  for (const identify::Mode& mode : modes) {
    freq_Hz.push_back(mode.pole.freq_Hz);
    damping.push_back(mode.pole.damping_ratio);
  }
  acquire::hdf5::OutputHdf5 out(path, force);
  write_numbers(out, "frequency_hz", freq_Hz);
  write_numbers(out, "damping_ratio", damping);
  if (!modes.empty()) {
    write_shapes(out, survey);
    write_macs(out, survey);
    out.set_text("", "normalisation", name_of(survey.shapes().front().normalisation));
  }
  write_cmif(out, survey);
  out.commit();
}

}  // namespace percuss::report
