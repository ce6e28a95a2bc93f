#include "report/svg/wireframe.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "report/text/analysis_tables.hpp"

namespace percuss::report {
namespace {

// The deflection Re(φ e^{jα}) has its largest sum of squares at α = −arg(Σφ²)/2.
void turn_to_largest(std::vector<std::array<Complex, 3>>& moves, const PlotMesh& mesh) {
  Complex squares = 0;
  double largest = 0;
  for (const auto& move : moves) {
    double square = 0;
    for (const Complex& component : move) {
      squares += component * component;
      square += std::norm(component);
    }
    largest = std::max(largest, square);
  }
  if (!(largest > 0)) return;
  Complex factor = std::polar(1 / std::sqrt(largest), -std::arg(squares) / 2);
  double strongest = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) along += (factor * moves[i].at(k)).real() * mesh.normals[i].at(k);
    if (std::abs(along) > std::abs(strongest)) strongest = along;
  }
  if (strongest < 0) factor = -factor;
  for (auto& move : moves) {
    for (Complex& component : move) component *= factor;
  }
}

std::vector<std::array<Complex, 3>> movement(const pipeline::Survey& survey, const identify::ModeShape& shape,
                                             const PlotMesh& mesh) {
  std::vector<std::array<Complex, 3>> moves(mesh.points.size());
  const bool sensors = survey.roving() == identify::Roving::sensor;
  for (const identify::ShapePlace& place : shape.places) {
    const auto at = mesh.index.find(static_cast<int>(place.point));
    if (at == mesh.index.end()) continue;
    const auto along = response_direction(&mesh, &survey, survey.analysis(), place.point, place.channel, sensors);
    for (std::size_t i = 0; i < 3; ++i) moves[at->second].at(i) += place.value * along.at(i);
  }
  turn_to_largest(moves, mesh);
  return moves;
}

// The direction of positive values of a fixed sensor: its stated angle, or its axis. The blows of a roving hammer may
// be directed against it, so the direction of the point counts only where nothing states the sensor's.
std::array<double, 3> sensor_direction(const pipeline::Survey& survey, const PlotMesh& mesh,
                                       const identify::DrivingPoint& at) {
  const pipeline::Analysis& analysis = survey.analysis();
  const auto& accel = analysis.record().accel;
  if (at.channel < accel.size()) {
    const auto& sensor = accel[at.channel];
    if (sensor.angle_rad && !analysis.options().classes.angles_assumed)
      return {0.0, std::cos(*sensor.angle_rad), std::sin(*sensor.angle_rad)};
    if (sensor.axis) return *sensor.axis;
  }
  return response_direction(&mesh, &survey, analysis, at.point, at.channel, false);
}

std::vector<WireframeSensor> sensors_of(const pipeline::Survey& survey, const PlotMesh& mesh) {
  std::vector<WireframeSensor> out;
  const bool roving = survey.roving() == identify::Roving::sensor;
  const auto add = [&](std::size_t point, std::size_t channel) {
    const auto at = mesh.index.find(static_cast<int>(point));
    if (at == mesh.index.end()) return;
    const auto direction = roving ? response_direction(&mesh, &survey, survey.analysis(), point, channel, true)
                                  : sensor_direction(survey, mesh, {.point = point, .channel = channel});
    out.push_back({at->second, direction});
  };
  if (roving) {
    for (const identify::ShapePlace& place : survey.shapes().front().places) add(place.point, place.channel);
  } else {
    for (const identify::DrivingPoint& at : survey.driving_points()) add(at.point, at.channel);
  }
  return out;
}

}  // namespace

Wireframe wireframe(const pipeline::Survey& survey) {
  Wireframe frame{.mesh = plot_mesh(survey), .sensors = {}, .modes = {}};
  frame.sensors = sensors_of(survey, frame.mesh);
  for (std::size_t m = 0; m < survey.shapes().size(); ++m) {
    const identify::Pole& pole = survey.modes()[m].pole;
    frame.modes.push_back({.name = mode_name(survey.classifications()[m], m),
                           .freq_Hz = pole.freq_Hz,
                           .damping_ratio = pole.damping_ratio,
                           .mpc = survey.shapes()[m].mpc,
                           .moves = movement(survey, survey.shapes()[m], frame.mesh)});
  }
  return frame;
}

}  // namespace percuss::report
