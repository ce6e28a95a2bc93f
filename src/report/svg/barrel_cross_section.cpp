#include "report/svg/barrel_cross_section.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/text/analysis_tables.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

constexpr int kSides = 90;
constexpr double kExaggeration = 0.25;  // of the radius

// The point at which the mode has its largest residue.
std::size_t strongest_point(const identify::Mode& mode) {
  const auto stronger = [](const identify::Residue& a, const identify::Residue& b) {
    return std::norm(a.value) < std::norm(b.value);
  };
  const auto best = std::max_element(mode.residues.begin(), mode.residues.end(), stronger);
  return best == mode.residues.end() ? 0 : best->point;
}

// The smallest displacement c cos nθ + s sin nθ that both sensors agree with, scaled to 1 at its largest.
Eigen::Vector2d pattern_of(const std::vector<BarrelSensor>& sensors, double n) {
  constexpr double kBlind = 1e-9;  // regularisation: both sensors may sit on nodes of one of the two patterns
  const auto strongest = std::max_element(sensors.begin(), sensors.end(), [](const auto& a, const auto& b) {
    return std::norm(a.residue) < std::norm(b.residue);
  });
  const Complex turn = std::polar(1.0, -std::arg(strongest->residue));
  Eigen::Matrix2d gram = kBlind * Eigen::Matrix2d::Identity();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const BarrelSensor& sensor : sensors) {
    const Eigen::Vector2d seen(std::cos(n * sensor.angle_rad), std::sin(n * sensor.angle_rad));
    gram += seen * seen.transpose();
    sum += seen * (sensor.residue * turn).real();
  }
  const Eigen::Vector2d pattern = gram.ldlt().solve(sum);
  return pattern / std::max(pattern.norm(), 1e-300);
}

// Radial, and tangential so that the ring keeps its length.
Polyline ring(const Eigen::Vector2d& pattern, double n, double amount) {
  Polyline line;
  for (int k = 0; k <= kSides; ++k) {
    const double t = 2 * std::numbers::pi * k / kSides, c = std::cos(n * t), s = std::sin(n * t);
    const double out = 1 + amount * (pattern[0] * c + pattern[1] * s);
    const double along = amount * (pattern[1] * c - pattern[0] * s) / n;
    line.push_back({out * std::cos(t) - along * std::sin(t), out * std::sin(t) + along * std::cos(t)});
  }
  return line;
}

}  // namespace

std::vector<BarrelSensor> barrel_sensors(const pipeline::Analysis& analysis, const identify::Mode& mode) {
  const std::size_t point = strongest_point(mode);
  std::vector<BarrelSensor> sensors;
  for (const identify::Residue& residue : mode.residues) {
    const auto& angle_rad = analysis.record().accel[residue.channel].angle_rad;
    if (residue.point == point && angle_rad) sensors.push_back({*angle_rad, residue.value});
  }
  return sensors;
}

std::vector<DeformedShape> barrel_cross_sections(const pipeline::Analysis& analysis,
                                                 const std::vector<identify::Mode>& modes,
                                                 const std::vector<identify::ModeClassification>& classifications) {
  std::vector<DeformedShape> drawings;
  for (std::size_t m = 0; m < classifications.size(); ++m) {
    const identify::Mode& mode = modes[m];
    const auto sensors = barrel_sensors(analysis, mode);
    if (sensors.size() != 2 || classifications[m].type == identify::ModeType::unknown) continue;
    const double n = classifications[m].type == identify::ModeType::hoop ? 2 : 1;
    const Eigen::Vector2d pattern = pattern_of(sensors, n);
    drawings.push_back(
        {.name = fmt::format("{}, {} Hz", mode_name(classifications[m], m), hertz_text(mode.pole.freq_Hz)),
         .rest = {ring(pattern, n, 0)},
         .moved = {ring(pattern, n, kExaggeration), ring(pattern, n, -kExaggeration)}});
  }
  return drawings;
}

}  // namespace percuss::report
