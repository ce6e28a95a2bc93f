#include "pipeline/shapes_in_hits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace percuss::pipeline {
namespace {

constexpr double kMinStdOfResidue =
    1e-12;  // of the largest residue: exact residues have equal weights, as in shape_of()

bool has_points_with_several_hits(const Analysis& analysis) {
  if (analysis.given_frfs() != nullptr) return false;
  std::map<int, std::size_t> hits;
  for (const std::size_t h : accepted_hits(analysis.hits())) {
    if (++hits[analysis.hits()[h].point] > 1) return true;
  }
  return false;
}

std::size_t place_index(const identify::ModeShape& shape, std::size_t point, std::size_t channel) {
  const auto at = std::find_if(shape.places.begin(), shape.places.end(), [&](const identify::ShapePlace& place) {
    return place.point == point && place.channel == channel;
  });
  return static_cast<std::size_t>(at - shape.places.begin());
}

// φ_p of one hit, from its residues and φ_c of the test with the weights of the test; rank-one, (5.1).
identify::ValueInHit value_of_hit(const identify::Mode& mode, const std::vector<Complex>& of_channel, double least,
                                  const ModeInHit& hit) {
  identify::ValueInHit out{.hit = hit.hit, .power = hit.power};
  double power = 0, noise2 = 0;
  Complex sum;
  for (const identify::HitResidue& one : hit.residues) {
    const identify::Residue& residue = mode.residues[one.residue];
    const Complex factor = of_channel[residue.channel];
    const double std = std::max(residue.std, least), weight = std > 0 ? 1 / (std * std) : 1;
    sum += weight * std::conj(factor) * one.value;
    power += weight * std::norm(factor);
    noise2 += weight * weight * std::norm(factor) * one.std * one.std;
  }
  if (!(power > 0)) return out;
  out.value = sum / power;
  out.std = std::hypot(std::sqrt(noise2) / power, hit.relative_std * std::abs(out.value));
  return out;
}

identify::ShapeInHits of_roving_hammer(const identify::Mode& mode, const identify::ModeShape& shape,
                                       const std::vector<ModeInHit>& hits, const std::vector<int>& points) {
  std::vector<Complex> of_channel;
  for (const identify::ShapePlace& sensor : shape.sensors) {
    of_channel.resize(std::max(of_channel.size(), sensor.channel + 1));
    of_channel[sensor.channel] = sensor.value;
  }
  double largest = 0;
  for (const identify::Residue& residue : mode.residues) largest = std::max(largest, std::abs(residue.value));
  identify::ShapeInHits out(shape.places.size());
  for (const ModeInHit& hit : hits) {
    const std::size_t place = place_index(shape, static_cast<std::size_t>(points[hit.point]), 0);
    if (place < out.size()) out[place].push_back(value_of_hit(mode, of_channel, kMinStdOfResidue * largest, hit));
  }
  return out;
}

// Every residue is a place; the scale of the shape is common to all.
identify::ShapeInHits of_roving_sensor(const identify::Mode& mode, const identify::ModeShape& shape,
                                       const std::vector<ModeInHit>& hits) {
  identify::ShapeInHits out(shape.places.size());
  const auto most = std::max_element(mode.residues.begin(), mode.residues.end(), [](const auto& a, const auto& b) {
    return std::norm(a.value) < std::norm(b.value);
  });
  const std::size_t at = most == mode.residues.end() ? out.size() : place_index(shape, most->point, most->channel);
  if (at == out.size() || !(std::abs(most->value) > 0)) return out;
  const Complex scale = shape.places[at].value / most->value;
  for (const ModeInHit& hit : hits) {
    for (const identify::HitResidue& one : hit.residues) {
      const identify::Residue& residue = mode.residues[one.residue];
      const std::size_t place = place_index(shape, residue.point, residue.channel);
      const Complex value = scale * one.value;
      if (place == out.size()) continue;
      const double std = std::hypot(std::abs(scale) * one.std, hit.relative_std * std::abs(value));
      out[place].push_back({.hit = hit.hit, .power = hit.power, .value = value, .std = std});
    }
  }
  return out;
}

}  // namespace

std::vector<identify::ShapeInHits> shapes_in_hits(const Analysis& analysis, const SurveyModes& survey,
                                                  const std::vector<identify::ModeShape>& shapes,
                                                  identify::Roving roving) {
  if (!has_points_with_several_hits(analysis)) return {};
  const std::vector<std::vector<ModeInHit>> hits = analysis.residues_per_hit();
  if (hits.empty()) return {};
  const std::vector<int> points = analysis.frf_points();
  std::vector<identify::ShapeInHits> out(shapes.size());
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    const bool of_pair = std::any_of(survey.pairs.begin(), survey.pairs.end(),
                                     [&](const auto& pair) { return m == pair.first || m == pair.first + 1; });
    const std::size_t of_analysis = survey.of_analysis[m];
    if (of_pair || of_analysis >= hits.size()) continue;
    out[m] = roving == identify::Roving::hammer
                 ? of_roving_hammer(survey.modes[m], shapes[m], hits[of_analysis], points)
                 : of_roving_sensor(survey.modes[m], shapes[m], hits[of_analysis]);
  }
  return out;
}

}  // namespace percuss::pipeline
