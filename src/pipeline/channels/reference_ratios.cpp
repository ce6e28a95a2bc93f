#include "pipeline/channels/reference_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "core/math/statistics.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinShowingModes = 3;
constexpr std::size_t kMinReferencePoints = 6;
constexpr double kClearSensor = 10;        // standard deviations of a residue, or of the residue that is expected
constexpr double kMaxFactorScatter = 0.2;  // of one mode's factor about the point's factor; close modes cause more
constexpr double kMinContradiction = 0.5;  // of the factor from 1: a mounting that slips changes it less
constexpr double kMinAgreeing = 0.8;       // share of the clear modes at a point
constexpr double kNoResponse = 0.1;        // factor below which a channel shows crosstalk or noise alone

using Points = std::vector<std::size_t>;

// The residues of two channels, of all modes.
class SensorPair {
 public:
  SensorPair(const std::vector<identify::Mode>& modes, std::size_t first, std::size_t second)
      : modes_(modes), first_(first), second_(second) {}

  // The ratio of the channels in mode m at a point where both are clear.
  std::optional<Complex> ratio(std::size_t m, std::size_t point) const {
    const identify::Residue* a = clear(m, point, first_);
    const identify::Residue* b = clear(m, point, second_);
    if (a == nullptr || b == nullptr) return std::nullopt;
    return b->value / a->value;
  }

  // The ratio at the point over the ratio `usual`, where the first channel is clear and the second should be.
  std::optional<Complex> factor(std::size_t m, std::size_t point, Complex usual) const {
    const identify::Residue* a = clear(m, point, first_);
    const identify::Residue* b = identify::find_residue(modes_[m], point, second_);
    if (a == nullptr || b == nullptr) return std::nullopt;
    const Complex expected = a->value * usual;
    if (!(std::abs(expected) > kClearSensor * b->std)) return std::nullopt;
    return b->value / expected;
  }

  // The usual ratio of each mode: the median over these points. Nothing for modes that are clear at too few of them.
  std::vector<std::optional<Complex>> usual_ratios(const Points& points, std::size_t min_points) const {
    std::vector<std::optional<Complex>> out(modes_.size());
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      std::vector<double> real, imaginary;
      for (const std::size_t p : points) {
        if (const auto here = ratio(m, p)) {
          real.push_back(here->real());
          imaginary.push_back(here->imag());
        }
      }
      if (real.size() >= min_points) out[m] = Complex{median(real), median(imaginary)};
    }
    return out;
  }

  // The common factor of the modes at a point, if there is one.
  std::optional<ReferenceContradiction> common_factor(std::size_t point,
                                                      const std::vector<std::optional<Complex>>& usual) const {
    std::vector<Complex> factors;
    std::vector<double> real;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const auto here = usual[m] ? factor(m, point, *usual[m]) : std::nullopt;
      if (!here) continue;
      factors.push_back(*here);
      real.push_back(here->real());
    }
    if (factors.size() < kMinShowingModes) return std::nullopt;
    const double middle = median(real);
    const double tolerance = kMaxFactorScatter * std::max(1.0, std::abs(middle));
    const auto agreeing = static_cast<std::size_t>(
        std::count_if(factors.begin(), factors.end(), [&](Complex f) { return std::abs(f - middle) < tolerance; }));
    if (static_cast<double>(agreeing) < kMinAgreeing * static_cast<double>(factors.size())) return std::nullopt;
    return ReferenceContradiction{
        .point = point, .first = first_, .second = second_, .factor = middle, .modes = agreeing};
  }

 private:
  const identify::Residue* clear(std::size_t m, std::size_t point, std::size_t channel) const {
    const identify::Residue* residue = identify::find_residue(modes_[m], point, channel);
    if (residue == nullptr || residue->value == Complex{}) return nullptr;
    return std::abs(residue->value) > kClearSensor * residue->std ? residue : nullptr;
  }

  const std::vector<identify::Mode>& modes_;
  std::size_t first_, second_;
};

// The point with most modes at which both channels are clear.
std::size_t clearest_point(const SensorPair& pair, const Points& points, std::size_t modes) {
  const auto clear_modes = [&](std::size_t point) {
    std::size_t count = 0;
    for (std::size_t m = 0; m < modes; ++m) count += pair.ratio(m, point) ? 1U : 0U;
    return count;
  };
  return *std::max_element(points.begin(), points.end(),
                           [&](std::size_t a, std::size_t b) { return clear_modes(a) < clear_modes(b); });
}

bool contradicts(const ReferenceContradiction& at) { return std::abs(at.factor - 1) >= kMinContradiction; }

// The points that agree with the reference point, or a larger group of points that agree with each other against it.
Points largest_group(const SensorPair& pair, const Points& points, std::size_t modes) {
  const auto of_reference = pair.usual_ratios({clearest_point(pair, points, modes)}, 1);
  Points same;
  std::map<double, Points> others;  // by factor, to one digit
  for (const std::size_t p : points) {
    const auto at = pair.common_factor(p, of_reference);
    if (!at) continue;
    Points& group = contradicts(*at) ? others[std::round(10 * at->factor) / 10] : same;
    group.push_back(p);
  }
  for (const auto& [factor, group] : others) {
    if (group.size() > same.size()) same = group;
  }
  return same;
}

std::vector<ReferenceContradiction> contradictions_of_pair(const std::vector<identify::Mode>& modes,
                                                           const Points& points, std::size_t first,
                                                           std::size_t second) {
  const SensorPair pair(modes, first, second);
  const auto usual = pair.usual_ratios(largest_group(pair, points, modes.size()), kMinReferencePoints / 2);
  std::vector<ReferenceContradiction> out;
  for (const std::size_t p : points) {
    if (const auto at = pair.common_factor(p, usual); at && contradicts(*at)) out.push_back(*at);
  }
  return out;
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
  if (modes.size() < kMinShowingModes || points.size() < kMinReferencePoints || channels.size() < 2) return {};
  const Points all(points.begin(), points.end());
  std::vector<ReferenceContradiction> out;
  const std::size_t first = *channels.begin();
  for (auto second = std::next(channels.begin()); second != channels.end(); ++second) {
    const auto found = contradictions_of_pair(modes, all, first, *second);
    out.insert(out.end(), found.begin(), found.end());
    // Where the first channel does not respond, it cannot be compared with; the second one can.
    for (const ReferenceContradiction& at : contradictions_of_pair(modes, all, *second, first)) {
      if (std::abs(at.factor) < kNoResponse) out.push_back(at);
    }
  }
  return out;
}

}  // namespace percuss::pipeline
