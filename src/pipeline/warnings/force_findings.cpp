#include "pipeline/warnings/force_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>

#include "core/io/counted_words.hpp"
#include "core/math/complex.hpp"
#include "core/math/statistics.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kLinesPerBand = 6;  // lines per band of the pulse's spectrum
constexpr double kMinAtNyquist = 0.1;     // of the pulse's level at low frequencies: below it nothing is excited there
constexpr double kMaxFilterFall = 0.7;    // from 0.42 to 0.495 of the sampling rate; a filter falls further
constexpr double kMinFolded = 0.02;  // of the largest response: level of the highest frequencies just after the hit
// A contact that excites frequencies near half the sampling rate ends within kContact samples of its peak. A steep
// filter still rings outside these samples, near half the sampling rate. A linear-phase filter rings on both sides,
// with 7 to 15 % of the pulse's level at these frequencies; a recursive filter rings after the pulse, with 12 %. A
// fourth-order filter rings with 3 %, and a first-order filter not at all. A hammer without a filter may ring after the
// pulse, but not before it.
constexpr std::size_t kContact = 3, kRingingReach = 16;              // samples on either side
constexpr double kRingingFrom = 0.35;                                // of the sampling rate
constexpr double kMinRingingBefore = 0.02, kMinRingingAfter = 0.08;  // of the pulse's level
constexpr double kSureOfRinging = 2;                                 // standard deviations of the noise
constexpr double kSpreadOfNoise = 0.65;   // relative, of the power of kRingingReach samples of noise above kRingingFrom
constexpr std::size_t kMinSameLevel = 4;  // hits of a point
constexpr double kMaxLevelSpread = 0.04;  // of the logarithm of the extremes
constexpr double kMinForceSpread = 0.05;  // of the logarithm of the forces
constexpr double kMinLevel = 6;           // of the noise, whose own extremes are about as equal
constexpr double kEqualLevels = 0.05;     // chance that two levels agree
constexpr double kMaxLevelChance = 1e-3;
constexpr double kMinCouplingPhase_rad = 0.02;  // moves a mode there by a hundredth of its bandwidth
constexpr double kMaxCornerSpread = 0.2;        // relative, of most hits around their median
constexpr std::size_t kMinPulse = 6;            // samples that are compared
constexpr std::size_t kComparedResponse = 4096;

// rms magnitude of the spectrum of a pulse between two frequencies, in shares of the sampling rate.
double pulse_level(const std::vector<double>& pulse, double from, double to) {
  double square = 0;
  for (std::size_t k = 0; k < kLinesPerBand; ++k) {
    const double turns = from + (to - from) * (static_cast<double>(k) + 0.5) / static_cast<double>(kLinesPerBand);
    Complex sum, turned = 1;
    const Complex step = std::polar(1.0, -kTwoPi * turns);
    for (const double x : pulse) {
      sum += x * turned;
      turned = times(turned, step);
    }
    square += std::norm(sum);
  }
  return std::sqrt(square / static_cast<double>(kLinesPerBand));
}

// Power near half the sampling rate, summed over hits: of the pulses, and of the samples on either side of them without
// the noise.
struct RingingPower {
  double pulse = 0, before = 0, after = 0;
  double variance = 0;  // of `before` and of `after`, by the noise
  bool of_a_filter() const {
    const auto exceeds = [&](double power, double least) {
      return power > least * least * pulse + kSureOfRinging * std::sqrt(variance);
    };
    return exceeds(before, kMinRingingBefore) || exceeds(after, kMinRingingAfter);
  }
};

void add_ringing(const acquire::Record& record, const acquire::Hit& hit, RingingPower& sum) {
  const auto power_of = [&](std::size_t first, std::size_t end) {
    std::vector<double> x(end - first);
    record.read_force_N(hit.row, first, x);
    for (double& value : x) value -= hit.baseline_N;
    const double noise = static_cast<double>(x.size()) * hit.noise_N * hit.noise_N;
    return std::pow(pulse_level(x, kRingingFrom, 0.5), 2) - noise;
  };
  const std::size_t rise = hit.peak - std::min(hit.peak, kContact), fall = hit.peak + kContact + 1;
  const std::size_t end = std::min(fall + kRingingReach, record.rows[hit.row].samples);
  sum.before += power_of(rise - std::min(rise, kRingingReach), rise);
  if (fall < end) sum.after += power_of(fall, end);
  sum.pulse += std::pow(pulse_level(hit.gated_N, kRingingFrom, 0.5), 2);
  sum.variance += std::pow(kSpreadOfNoise * static_cast<double>(kRingingReach) * hit.noise_N * hit.noise_N, 2);
}

double spread_of_logs(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (const double value : values) mean += std::log(value) / static_cast<double>(values.size());
  for (const double value : values) square += (std::log(value) - mean) * (std::log(value) - mean);
  return std::sqrt(square / static_cast<double>(values.size() - 1));
}

// A positive or negative side of a channel at one point: the chance that its extremes are that equal.
struct LevelSide {
  std::size_t channel = 0;
  double chance = 1, level = 0, spread = 0;
  double least_peak_N = 0, largest_peak_N = 0;  // of the forces
};

LevelSide side_of(std::size_t channel, const std::vector<double>& extremes, const std::vector<double>& forces,
                  double min_force_spread) {
  LevelSide side{.channel = channel, .level = median(extremes)};
  side.spread = spread_of_logs(extremes);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < forces.size(); ++i) ratios.push_back(extremes[i] / forces[i]);
  const double of_ratio = spread_of_logs(ratios);
  if (side.spread < kMaxLevelSpread && spread_of_logs(forces) > min_force_spread && of_ratio > side.spread)
    side.chance = std::pow(side.spread / of_ratio, static_cast<double>(extremes.size() - 1));
  return side;
}

constexpr std::size_t kPeak = 0;  // index of the peak among the measures of a blow

// [measures] The size of a blow: its peak and its impulse. A harder blow may be shorter: where the impulses are equal,
// so may be the responses.
std::vector<double> sizes_of(const acquire::Hit& hit) {
  const double sum = std::accumulate(hit.gated_N.begin(), hit.gated_N.end(), 0.0);
  return {std::abs(hit.peak_N), std::abs(sum)};
}

// The side, judged by the measure of the blows (peak or impulse) that gives the greatest chance.
LevelSide likeliest_side_of(std::size_t channel, const std::vector<double>& extremes,
                            const std::vector<std::vector<double>>& sizes) {
  std::optional<LevelSide> likeliest;
  for (std::size_t measure = 0; measure < sizes.front().size(); ++measure) {
    std::vector<double> forces;
    for (const std::vector<double>& of_hit : sizes) forces.push_back(of_hit[measure]);
    if (std::any_of(forces.begin(), forces.end(), [](double value) { return !(value > 0); })) continue;
    const LevelSide side = side_of(channel, extremes, forces, measure == kPeak ? kMinForceSpread : 0);
    if (!likeliest || side.chance > likeliest->chance) likeliest = side;
  }
  return likeliest.value_or(LevelSide{.channel = channel});
}

std::vector<LevelSide> sides_of(const std::vector<AnalysedHit>& hits, const HitResponses& responses,
                                std::size_t channels) {
  std::map<int, std::vector<std::size_t>> points;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].responses.size() == channels && responses.of[h].size() == channels) points[hits[h].point].push_back(h);
  }
  const auto peak_of = [](const std::vector<double>& measures) { return measures[kPeak]; };
  std::vector<LevelSide> sides;
  for (const auto& [point, members] : points) {
    if (members.size() < kMinSameLevel) continue;
    std::vector<std::vector<double>> sizes;
    for (const std::size_t h : members) sizes.push_back(sizes_of(hits[h].hit));
    for (std::size_t s = 0; s < 2 * channels; ++s) {
      std::vector<double> extremes;
      bool clear = true;
      for (const std::size_t h : members) {
        const HitResponse& response = responses.of[h][s / 2];
        const double rest = response.rest.before.value_or(0);
        extremes.push_back(s % 2 == 0 ? response.grade.extremes.high - rest : rest - response.grade.extremes.low);
        clear = clear && extremes.back() > kMinLevel * response.rest.noise;
      }
      if (!clear) continue;
      LevelSide side = likeliest_side_of(s / 2, extremes, sizes);
      side.least_peak_N = std::ranges::min(sizes, {}, peak_of)[kPeak];
      side.largest_peak_N = std::ranges::max(sizes, {}, peak_of)[kPeak];
      sides.push_back(side);
    }
  }
  return sides;
}

// A channel whose extremes are a limit, and this limit.
struct ClippedChannel {
  std::size_t channel = 0;
  double level_mps2 = 0;
};

// The channels that the recorder clips: samples at the limit follow each other, unlike those of a clipped signal that a
// filter has rounded.
std::vector<ClippedChannel> flat_channels(const std::vector<AnalysedHit>& hits, std::size_t channels) {
  std::vector<ClippedChannel> out;
  for (std::size_t c = 0; c < channels; ++c) {
    double level = 0;
    for (const AnalysedHit& hit : hits) {
      if (hit.responses.size() == channels && hit.responses[c].clipped_samples > 0)
        level = std::max(level, hit.responses[c].extremes.max_distance_from(0));
    }
    if (level > 0) out.push_back({c, level});
  }
  return out;
}

// Whether the samples show clipping of these sides' channels in most hits.
bool flat_in_most_hits(const std::vector<AnalysedHit>& hits, const std::vector<LevelSide>& sides) {
  std::size_t graded = 0, flat = 0;
  for (const AnalysedHit& hit : hits) {
    if (hit.responses.empty()) continue;
    ++graded;
    if (std::any_of(sides.begin(), sides.end(),
                    [&](const LevelSide& side) { return hit.responses[side.channel].clipped_samples > 0; }))
      ++flat;
  }
  return 2 * flat > graded;
}

// The channels of these sides, ascending, each with the level of its clearest side.
std::vector<ClippedChannel> channels_of(const std::vector<LevelSide>& sides) {
  std::map<std::size_t, double> levels;
  for (const LevelSide& side : sides) levels.emplace(side.channel, side.level);
  std::vector<ClippedChannel> out;
  for (const auto& [channel, level] : levels) out.push_back({channel, level});
  return out;
}

// "accel 1 (1500 m/s²), accel 2 (1500 m/s²)"
std::string list_of_clipped(const std::vector<ClippedChannel>& clipped, const acquire::Record& record) {
  constexpr std::size_t kMaxListed = 8;
  return limited_list(clipped.size(), kMaxListed, [&](std::size_t i) {
    return fmt::format("{} ({:.4g} m/s²)", one_line(record.accel[clipped[i].channel].name, kMaxNameBytes),
                       clipped[i].level_mps2);
  });
}

Warning flat_top_warning(const std::vector<ClippedChannel>& clipped, const std::vector<AnalysedHit>& hits,
                         const acquire::Record& record) {
  const auto concerned = std::count_if(hits.begin(), hits.end(), [](const AnalysedHit& hit) {
    return std::any_of(hit.responses.begin(), hit.responses.end(),
                       [](const acquire::ResponseGrade& response) { return response.clipped_samples > 0; });
  });
  return with_remedy({"response_clipped",
                      fmt::format("the recorder clips {} in {} of {} hits: samples lie at its limit. Residues, damping "
                                  "and frequencies of these hits are off by more than their ±",
                                  list_of_clipped(clipped, record), concerned, hits.size())},
                     "raise the input range, or strike more softly");
}

bool equal_pulses(const acquire::Hit& a, const acquire::Hit& b) {
  return a.gated_N.size() >= kMinPulse && a.noise_N > 0 && a.noise_N == b.noise_N && a.peak_N == b.peak_N &&
         a.gated_N == b.gated_N;
}

// Whether all channels of two hits are equal from the peak of the force on. Sensors at several points share the force
// of one blow, each point perhaps in a file of its own: then the pulses are equal, but the responses are not.
bool equal_responses(const acquire::Record& record, const acquire::Hit& a, const acquire::Hit& b) {
  const auto left = [](const acquire::Hit& hit) { return hit.first + hit.samples - hit.peak; };
  const std::size_t count = std::min({left(a), left(b), kComparedResponse});
  std::vector<double> of_a(count), of_b(count);
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    record.read_accel_mps2(a.row, c, a.peak, of_a);
    record.read_accel_mps2(b.row, c, b.peak, of_b);
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    if (!std::equal(of_a.begin(), of_a.end(), of_b.begin(), same)) return false;
  }
  return true;
}

}  // namespace

std::vector<Warning> aliasing_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       const HitResponses& responses) {
  std::vector<double> nyquist, fall, folded;
  std::vector<std::size_t> used;
  for (const std::size_t h : accepted_hits(hits)) {
    const std::vector<double>& pulse = hits[h].hit.gated_N;
    const double low = pulse_level(pulse, 0, 0.05);
    if (!(low > 0)) continue;
    nyquist.push_back(pulse_level(pulse, 0.49, 0.5) / low);
    used.push_back(h);
  }
  // The folded spectrum adds to the pulse's own spectrum or cancels it. This depends on the time of the pulse between
  // two samples.
  const double most = nyquist.empty() ? 0 : *std::max_element(nyquist.begin(), nyquist.end());
  if (most < kMinAtNyquist) return {};
  RingingPower ringing;
  for (const std::size_t h : used) {
    const std::vector<double>& pulse = hits[h].hit.gated_N;
    add_ringing(record, hits[h].hit, ringing);
    fall.push_back(pulse_level(pulse, 0.49, 0.5) / pulse_level(pulse, 0.41, 0.43));
    for (const HitResponse& response : responses.of[h]) {
      const double largest = response.grade.extremes.max_distance_from(0);
      if (!response.noise.after.rms.empty() && largest > 0)
        folded.push_back(response.noise.after.rms.front() / largest);
    }
  }
  if (folded.empty() || *std::max_element(fall.begin(), fall.end()) < kMaxFilterFall) return {};
  // The folded spectrum of a filter that stops only from 0.55 of the sampling rate on also reaches half the rate.
  if (median(folded) < kMinFolded || ringing.of_a_filter()) return {};
  return {with_remedy(
      {"aliasing",
       fmt::format("no steep anti-alias filter acts before sampling at {:.6g} Hz: at half the sampling rate the force "
                   "still has {:.0f} % of its level at low frequencies, its pulses lack the ringing of such a filter, "
                   "and the responses still hold their highest frequencies. "
                   "Modes above {:.6g} Hz are folded into the band: their frequencies are false, and modes near them "
                   "are biased",
                   record.fs_Hz, 100 * most, record.fs_Hz / 2)},
      "record with an anti-alias filter or a higher sampling rate")};
}

std::vector<Warning> analogue_clipping_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                                const HitResponses& responses) {
  std::vector<LevelSide> sides = sides_of(hits, responses, record.accel.size());
  std::sort(sides.begin(), sides.end(), [](const LevelSide& a, const LevelSide& b) { return a.chance < b.chance; });
  double chance = 1, least = 1;
  std::size_t clipped = 0;
  for (std::size_t k = 0; k < sides.size() && sides[k].chance < 0.1; ++k) {
    // The chance that k + 1 of all sides are so equal.
    chance *= sides[k].chance * static_cast<double>(sides.size() - k) / static_cast<double>(k + 1);
    // Amplifiers clip both signs, and often all channels, at one level; levels of a structure differ by tens of
    // percent.
    const double level_ratio = sides[k].level / sides.front().level;
    chance *= std::min(1.0, kEqualLevels + 2 * std::abs(std::log(level_ratio)) + (k == 0 ? 1 : 0));
    if (chance >= least) continue;
    least = chance;
    clipped = k + 1;
  }
  if (clipped == 0 || least > kMaxLevelChance) return {};
  sides.resize(clipped);
  const std::vector<ClippedChannel> flat = flat_channels(hits, record.accel.size());
  if (flat_in_most_hits(hits, sides)) return {flat_top_warning(flat, hits, record)};
  const std::vector<ClippedChannel> rounded = channels_of(sides);
  const bool one = rounded.size() == 1;
  const LevelSide& widest = *std::max_element(
      sides.begin(), sides.end(), [](const LevelSide& a, const LevelSide& b) { return a.spread < b.spread; });
  return {with_remedy(
      {"response_clipped",
       fmt::format("{} reach{} nearly the same largest value{} in every hit of a point, within {:.2g} %, although the "
                   "forces range from {:.4g} to {:.4g} N: {} clip{} before the recorder's filter, which rounds the "
                   "tops. Residues, damping and frequencies are off by more than their ±",
                   list_of_clipped(rounded, record), one ? "es" : "", one ? "" : "s", 100 * widest.spread,
                   widest.least_peak_N, widest.largest_peak_N, one ? "its amplifier" : "their amplifiers",
                   one ? "s" : "")},
      "lower the gain, use a sensor of larger range, or strike more softly")};
}

double coupling_corner_Hz(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& chosen) {
  std::vector<double> corners;
  for (const std::size_t h : chosen) corners.push_back(hits[h].hit.coupling_Hz);
  if (corners.empty()) return 0;
  const double corner_Hz = median(corners);
  const auto agrees = [&](double hz) { return std::abs(hz - corner_Hz) < kMaxCornerSpread * corner_Hz; };
  const bool most =
      2 * std::count_if(corners.begin(), corners.end(), agrees) > static_cast<std::ptrdiff_t>(corners.size());
  return most ? corner_Hz : 0;
}

std::vector<Warning> coupling_warnings(const std::vector<AnalysedHit>& hits, double low_Hz) {
  if (!(low_Hz > 0)) return {};
  const double corner_Hz = coupling_corner_Hz(hits, accepted_hits(hits));
  const double phase_rad = std::atan(corner_Hz / low_Hz);
  if (phase_rad < kMinCouplingPhase_rad) return {};
  return {with_remedy(
      {"ac_coupling",
       fmt::format("the force undershoots after each pulse: its channel is AC-coupled, with a corner of {:.2g} Hz. The "
                   "FRFs use the pulses alone, which turns their phase by {:.2g} rad at {:.4g} Hz, less above. Low "
                   "modes can be off by more than their ±",
                   corner_Hz, phase_rad, low_Hz),
       {"force_window"}},
      "couple the channels by DC; or, if the accelerometers are coupled alike, use the force of all samples, whose "
      "noise makes every ± several times larger")};
}

std::vector<Warning> duplicate_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits) {
  std::map<double, std::vector<std::size_t>> by_peak;
  for (const std::size_t h : accepted_hits(hits)) by_peak[hits[h].hit.peak_N].push_back(h);
  std::string pairs;
  for (const auto& [peak_N, members] : by_peak) {
    for (auto member = members.begin(); member != members.end(); ++member) {
      const acquire::Hit& b = hits[*member].hit;
      const auto original = std::find_if(members.begin(), member, [&](std::size_t h) {
        return equal_pulses(hits[h].hit, b) && equal_responses(record, hits[h].hit, b);
      });
      if (original == member) continue;
      const std::size_t file_a = record.rows[hits[*original].hit.row].file, file_b = record.rows[b.row].file;
      pairs += fmt::format("{}hits {} and {}", pairs.empty() ? "" : ", ", *original + 1, *member + 1);
      if (file_a != file_b && file_b < record.files.size())
        pairs += " (" + one_line(record.files[file_a].path) + ", " + one_line(record.files[file_b].path) + ")";
    }
  }
  if (pairs.empty()) return {};
  return {with_remedy({"duplicate",
                       "the same data twice: the pulses and responses of " + pairs +
                           " are equal in every sample, the noise included. Each ± is too small, because a copy adds "
                           "no information",
                       {"reject_hit"}},
                      "leave the copies out")};
}

}  // namespace percuss::pipeline
