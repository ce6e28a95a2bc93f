#include "report/svg/wireframe.hpp"

#include <map>

#include "report/svg/plot_geometry.hpp"
#include "report/text/analysis_tables.hpp"

namespace percuss::report {
namespace {

// Maps the number of each point with known coordinates to its index in the drawing.
std::map<int, std::size_t> drawn_points(const pipeline::Survey& survey) {
  std::map<int, std::size_t> out;
  for (const identify::ShapePlace& place : survey.shapes().front().places) {
    if (plot_position(survey, place.point)) out.emplace(static_cast<int>(place.point), 0);
  }
  std::size_t next = 0;
  for (auto& [number, index] : out) index = next++;
  return out;
}

std::vector<std::array<Complex, 3>> movement(const pipeline::Survey& survey, const identify::ModeShape& shape,
                                             const std::map<int, std::size_t>& points) {
  std::vector<std::array<Complex, 3>> moves(points.size());
  const bool sensors = survey.options().roving == identify::Roving::sensor;
  for (const identify::ShapePlace& place : shape.places) {
    const auto at = points.find(static_cast<int>(place.point));
    if (at == points.end()) continue;
    const auto normal = outward_normal(&survey, survey.analysis(), place.point, place.channel, sensors);
    for (std::size_t i = 0; i < 3; ++i) moves[at->second].at(i) += place.value * normal.at(i);
  }
  return moves;
}

}  // namespace

Wireframe wireframe(const pipeline::Survey& survey) {
  const auto points = drawn_points(survey);
  std::set<int> numbers;
  for (const auto& [number, index] : points) numbers.insert(number);
  Wireframe frame;
  for (const int number : numbers) frame.points.push_back(*plot_position(survey, static_cast<std::size_t>(number)));
  for (const auto& [from, to] : plot_lines(survey, numbers)) frame.lines.push_back({points.at(from), points.at(to)});
  for (std::size_t m = 0; m < survey.shapes().size(); ++m) {
    frame.modes.push_back({.name = mode_name(survey.classifications()[m], m),
                           .freq_Hz = survey.analysis().modes()[m].pole.freq_Hz,
                           .moves = movement(survey, survey.shapes()[m], points)});
  }
  return frame;
}

}  // namespace percuss::report
