#include "pipeline/channels/reference_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/math/statistics.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinModes = 3;
constexpr std::size_t kMinReferencePoints = 6;  // whose median ratio one or two wrong points do not move
constexpr double kClear = 10;                   // standard deviations of a residue, or of the residue that is expected
constexpr double kMaxScatter = 0.2;        // of one mode's factor about the point's factor: more than close modes cause
constexpr double kMinContradiction = 0.5;  // of the factor from 1: a mounting that slips changes it less
constexpr double kMinAgreeing = 0.8;       // share of the clear modes at a point
constexpr double kMaxNamed = 0.25;         // share of the points

struct Factor {
  std::size_t mode = 0;
  double value = 0;
  double off = 0;  // imaginary part
};

// The ratio of the channels `second` and `first` of one mode: the median over the points.
std::optional<Complex> usual_ratio(const identify::Mode& mode, const std::vector<std::size_t>& points,
                                   std::size_t first, std::size_t second) {
  std::vector<double> real, imaginary;
  for (const std::size_t p : points) {
    const identify::Residue* a = identify::find_residue(mode, p, first);
    const identify::Residue* b = identify::find_residue(mode, p, second);
    if (a == nullptr || b == nullptr || std::abs(a->value) < kClear * a->std || std::abs(b->value) < kClear * b->std)
      continue;
    if (a->value == Complex{}) continue;
    const Complex ratio = b->value / a->value;
    real.push_back(ratio.real());
    imaginary.push_back(ratio.imag());
  }
  if (real.size() < kMinReferencePoints) return std::nullopt;
  return Complex{median(real), median(imaginary)};
}

void add_contradictions(std::vector<ReferenceContradiction>& out, const std::vector<identify::Mode>& modes,
                        const std::vector<std::size_t>& points, std::size_t first, std::size_t second) {
  std::map<std::size_t, std::vector<Factor>> factors;  // by point
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto usual = usual_ratio(modes[m], points, first, second);
    if (!usual) continue;
    for (const std::size_t p : points) {
      const identify::Residue* a = identify::find_residue(modes[m], p, first);
      const identify::Residue* b = identify::find_residue(modes[m], p, second);
      if (a == nullptr || b == nullptr || std::abs(a->value) < kClear * a->std) continue;
      const Complex expected = a->value * *usual;
      if (std::abs(expected) < kClear * b->std || expected == Complex{}) continue;
      const Complex factor = b->value / expected;
      factors[p].push_back({.mode = m, .value = factor.real(), .off = factor.imag()});
    }
  }
  for (const auto& [point, of_modes] : factors) {
    if (of_modes.size() < kMinModes) continue;
    std::vector<double> values;
    for (const Factor& factor : of_modes) values.push_back(factor.value);
    const double middle = median(values);
    if (std::abs(middle - 1) < kMinContradiction) continue;
    const double tolerance = kMaxScatter * std::max(1.0, std::abs(middle));
    const auto agreeing =
        static_cast<std::size_t>(std::count_if(of_modes.begin(), of_modes.end(), [&](const Factor& factor) {
          return std::hypot(factor.value - middle, factor.off) < tolerance;
        }));
    if (static_cast<double>(agreeing) < kMinAgreeing * static_cast<double>(of_modes.size())) continue;
    out.push_back({.point = point, .first = first, .second = second, .factor = middle, .modes = agreeing});
  }
}

}  // namespace

std::vector<ReferenceContradiction> reference_contradictions(const std::vector<identify::Mode>& modes) {
  std::set<std::size_t> points, channels;
  for (const identify::Mode& mode : modes) {
    for (const identify::Residue& residue : mode.residues) {
      points.insert(residue.point);
      channels.insert(residue.channel);
    }
  }
  if (modes.size() < kMinModes || points.size() < kMinReferencePoints || channels.size() < 2) return {};
  const std::vector<std::size_t> list(points.begin(), points.end());
  std::vector<ReferenceContradiction> out;
  for (auto second = std::next(channels.begin()); second != channels.end(); ++second) {
    std::vector<ReferenceContradiction> of_pair;
    add_contradictions(of_pair, modes, list, *channels.begin(), *second);
    if (static_cast<double>(of_pair.size()) <= kMaxNamed * static_cast<double>(list.size()))
      out.insert(out.end(), of_pair.begin(), of_pair.end());
  }
  return out;
}

}  // namespace percuss::pipeline
