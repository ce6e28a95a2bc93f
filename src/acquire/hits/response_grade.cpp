#include "acquire/hits/response_grade.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "acquire/hits/clipping.hpp"
#include "acquire/hits/pulse_shape.hpp"
#include "core/io/counted_words.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kDecayed_dB = -52;         // six time constants: truncation changes an FRF by less than 0.5 %, [12]
constexpr double kAboveNoise = 2;           // times the rms of the pre-trigger; the end rings if it is louder
constexpr std::size_t kMinQuiet = 12;       // samples of the pre-trigger that give a noise level
constexpr std::size_t kQuietSamples = 256;  // give a standard deviation to 7 %, enough for thresholds
constexpr double kOnsetNoise = 6;           // standard deviations
constexpr double kOnsetFraction = 0.02;     // of the largest response
constexpr std::size_t kMinPush = 4;         // samples of the first motion
constexpr double kMinOnsetVelocity = 0.25;  // of the largest velocity during two pulses
// Of the largest velocity, in the opposite direction and earlier. Above this limit the modes cancel at first, and noise
// decides the sign.
constexpr double kMaxOppositeVelocity = 0.05;
// Of the largest smoothed acceleration during two pulses, in the opposite direction and earlier.
constexpr double kMaxOppositeMotion = 0.03;
constexpr double kRingingBefore = 4;    // times the level at the end
constexpr double kNegligible = 0.0025;  // of the response: the same −52 dB
constexpr std::size_t kEnvelopeWindows = 64;
constexpr double kSteady = 1.5;          // ratio of the levels of successive quarters; backgrounds vary
constexpr double kBackgroundFactor = 2;  // times the final level
constexpr double kStillFalling = 0.9;    // of the rms one window earlier
constexpr double kCoarseStep = 1e-5;  // of the largest response; steps of 5e-5 (16 bits) or more cause spurious modes
constexpr std::size_t kStepSamples = 512;    // samples, of which some differ by one step
constexpr std::size_t kMinConstantEnd = 64;  // samples without change; noise of a third of a step would change them
// The last two quarters of the record do not distinguish a background from a decay that falls by less than this factor
// over the record.
constexpr double kMinDecay = kSteady * kSteady * kSteady * kSteady;

// The pre-trigger up to the ringing of the anti-alias filter.
std::size_t quiet_samples(const Hit& hit, std::size_t samples) {
  return std::min(hit.gate_first > hit.first ? hit.gate_first - hit.first : 0, samples);
}

std::span<const double> quiet_part(const Hit& hit, std::span<const double> accel) {
  return accel.first(quiet_samples(hit, accel.size()));
}

double level_at_end(std::span<const double> accel) {
  const auto end = accel.last(std::max<std::size_t>(1, accel.size() / 20));
  return median({end.begin(), end.end()});
}

void grade_end(ResponseGrade& grade, const Hit& hit, std::span<const double> accel) {
  const std::size_t after = std::min(accel.size(), hit.gate_first - hit.first + hit.gated_N.size());
  const std::size_t window = std::max<std::size_t>(8, (accel.size() - after) / 20);
  if (after + 3 * window > accel.size()) return;
  const double start = rms_about_mean(accel.subspan(after, window));
  const double end = rms_about_mean(accel.last(window));
  const double before_end = rms_about_mean(accel.subspan(accel.size() - 2 * window, window));
  if (!(start > 0)) return;
  grade.end_level_dB = 20 * std::log10(std::max(end, 1e-300) / start);
  const auto quiet = quiet_part(hit, accel);
  const bool above_noise = quiet.size() >= kMinQuiet && !grade.rings_before ? end > kAboveNoise * rms_about_mean(quiet)
                                                                            : end < kStillFalling * before_end;
  grade.truncated = grade.end_level_dB > kDecayed_dB && above_noise;
}

// The level before the impact, or at the end where no sample precedes it.
double resting_level(std::span<const double> quiet, std::span<const double> accel) {
  return quiet.empty() ? level_at_end(accel) : spread_of(subsampled(quiet, kQuietSamples)).median;
}

// White noise with these second differences has this rms. Motion well below half the sampling rate adds little to it.
double rms_of_white_noise(std::span<const double> x) {
  double sum = 0;
  for (std::size_t i = 2; i < x.size(); ++i) {
    const double difference = x[i] - 2 * x[i - 1] + x[i - 2];
    sum += difference * difference;
  }
  return x.size() > 2 ? std::sqrt(sum / (6 * static_cast<double>(x.size() - 2))) : 0;
}

// The pre-trigger rings when it is well above the end (noise does not decay) and not negligible beside the response.
// The end of a decay that was cut off does not show the noise; there, a pre-trigger that is smoother than white noise
// may ring.
void grade_before(ResponseGrade& grade, const Hit& hit, std::span<const double> accel) {
  const auto pretrigger = quiet_part(hit, accel);
  const auto quiet = pretrigger.first(pretrigger.size() / 2);  // a filter of linear phase rings before the hit
  const std::size_t window = std::max<std::size_t>(8, accel.size() / 20);
  if (quiet.size() < kMinQuiet || accel.size() < std::max(pretrigger.size() + window, 4 * window)) return;
  const double before = rms_about_mean(quiet);
  const double start = rms_about_mean(accel.subspan(pretrigger.size(), window));
  if (!(before > kNegligible * start)) return;
  const double end = rms_about_mean(accel.last(window));
  grade.rings_before = before > kRingingBefore * end;
  const double before_end = rms_about_mean(accel.subspan(accel.size() - 2 * window, window));
  const bool cut_off = end > kNegligible * start && end < kStillFalling * before_end;
  grade.may_ring_before = grade.rings_before || (cut_off && before > kRingingBefore * rms_of_white_noise(quiet));
}

// The longer of these two times limits the delay of the first motion: a recorder that reads its channels in blocks
// delays some of them by tens of milliseconds.
constexpr double kMaxTravelPulses = 5, kMaxTravel_s = 0.05;

// Sample n without ringing of the anti-alias filter, which is near half the sampling rate.
double smoothed(std::span<const double> accel, std::size_t n, double rest) {
  if (n == 0 || n + 1 >= accel.size()) return 0;
  return 0.25 * (accel[n - 1] + 2 * accel[n] + accel[n + 1]) - rest;
}

struct InitialMotion {
  int sign = 0;            // 0: unknown
  std::size_t sample = 0;  // at which the velocity shows the sign
};

// The sign of the velocity once it reaches kMinOnsetVelocity of its largest value. The acceleration itself may be
// ringing of the anti-alias filter, which has both signs and leaves no velocity.
InitialMotion initial_motion(std::span<const double> accel, double rest, double noise) {
  std::vector<double> velocity(accel.size());
  double sum = 0, largest = 0;
  for (std::size_t n = 0; n < accel.size(); ++n) {
    velocity[n] = sum += accel[n] - rest;
    largest = std::max(largest, std::abs(sum));
  }
  if (largest < kOnsetNoise * noise * std::sqrt(static_cast<double>(accel.size()))) return {};
  if (!(largest > 0)) return {};
  const auto first = std::find_if(velocity.begin(), velocity.end(),
                                  [&](double v) { return std::abs(v) >= kMinOnsetVelocity * largest; });
  const int sign = *first > 0 ? 1 : -1;
  const bool other_way =
      std::any_of(velocity.begin(), first, [&](double v) { return -sign * v > kMaxOppositeVelocity * largest; });
  return {.sign = other_way ? 0 : sign, .sample = static_cast<std::size_t>(first - velocity.begin())};
}

// Whether samples first … end − 1 clearly move in the direction −sign before the motion of this sign, which is larger.
bool moves_other_way(std::span<const double> accel, std::size_t first, std::size_t end, int sign, double limit,
                     double rest) {
  for (std::size_t n = first; n < end; ++n) {
    if (-sign * smoothed(accel, n, rest) > limit) return true;
  }
  return false;
}

void grade_onset(ResponseGrade& grade, const Hit& hit, std::span<const double> accel, const Extremes& extremes,
                 const Spread& before, double fs_Hz) {
  const auto [rest, noise] = before;
  const double largest = extremes.max_distance_from(rest);
  const double level = std::max(kOnsetNoise * noise, kOnsetFraction * largest);
  if (!(level > 0)) return;
  const double onset = hit.onset_s * fs_Hz - static_cast<double>(hit.first);
  const auto start = static_cast<std::size_t>(std::max(0.0, std::floor(onset) - 2));
  auto i = start;
  while (i < accel.size() && std::abs(accel[i] - rest) < level) ++i;
  // A later motion is noise, or belongs to another event.
  const double latest = onset + std::max(kMaxTravelPulses * hit.pulse_s, kMaxTravel_s) * fs_Hz;
  if (static_cast<double>(i) > latest + static_cast<double>(kMinPush)) return;
  const auto push = static_cast<std::size_t>(std::ceil(2 * hit.pulse_s * fs_Hz));
  const std::size_t end = std::min(accel.size(), i + std::max(kMinPush, push));
  const InitialMotion motion = initial_motion(accel.subspan(i, end - i), rest, noise);
  double in_push = 0;
  for (std::size_t n = i; n < end; ++n) in_push = std::max(in_push, std::abs(smoothed(accel, n, rest)));
  const std::size_t earliest = std::max(start, i - std::min(i, kMinPush));  // the first motion may begin below `level`
  const double limit = std::max(kOnsetNoise * noise, kMaxOppositeMotion * in_push);
  if (motion.sign == 0 || moves_other_way(accel, earliest, i + motion.sample, motion.sign, limit, rest)) return;
  grade.polarity = motion.sign;
  while (i < end && grade.polarity * (accel[i] - rest) < level) ++i;  // skips ringing of the other sign
  grade.delay_s = std::max(0.0, (static_cast<double>(i) - onset) / fs_Hz);
}

// The resolution over the largest response, where noise does not hide it: the decay ends in a constant.
double coarse_step(std::span<const double> accel, double largest) {
  std::size_t changes = accel.size();
  while (changes > 1 && accel[changes - 1] == accel[changes - 2]) --changes;
  if (accel.size() - changes < kMinConstantEnd) return 0;
  const std::size_t first = changes > kStepSamples ? changes - kStepSamples : 0;
  const double step = resolution_of(accel.subspan(first, changes - first));
  return step > kCoarseStep * largest ? step / largest : 0;
}

std::size_t decayed_within(const Hit& hit, std::size_t samples, const SampleWindow& accel_mps2) {
  const std::size_t after = std::min(samples, hit.gate_first - hit.first + hit.gated_N.size());
  const std::size_t window = (samples - after) / kEnvelopeWindows;
  if (window < 8) return samples;
  std::vector<double> level;
  for (std::size_t w = 0; w < kEnvelopeWindows; ++w)
    level.push_back(rms_about_mean(accel_mps2(after + w * window, window)));
  const std::size_t quarter = kEnvelopeWindows / 4;
  const double final_level = median({level.end() - static_cast<std::ptrdiff_t>(quarter), level.end()});
  const double earlier = median(
      {level.end() - static_cast<std::ptrdiff_t>(2 * quarter), level.end() - static_cast<std::ptrdiff_t>(quarter)});
  if (!(final_level > 0) || earlier > kSteady * final_level) return samples;
  const std::size_t quiet = quiet_samples(hit, samples);
  const bool background_before =
      quiet >= kMinQuiet && kBackgroundFactor * rms_about_mean(accel_mps2(0, quiet)) > final_level;
  if (!background_before && *std::max_element(level.begin(), level.end()) < kMinDecay * final_level) return samples;
  std::size_t settled = kEnvelopeWindows;
  while (settled > 0 && level[settled - 1] < kBackgroundFactor * final_level) --settled;
  return std::min(samples, after + 2 * std::max<std::size_t>(settled, 1) * window);
}

// The resolution from the end, where changes are single steps, or from all samples when the end is constant.
double finest_change(std::span<const double> accel) {
  const double at_end = resolution_of(accel.last(std::min(kStepSamples, accel.size())));
  return at_end > 0 ? at_end : resolution_of(accel);
}

}  // namespace

ResponseGrade grade_clipping(std::span<const double> accel_mps2, std::size_t quiet) {
  ResponseGrade grade;
  if (accel_mps2.empty()) return grade;
  const std::vector<Extremes> blocks = block_extremes(accel_mps2, kClippingBlock);
  grade.extremes = extremes_of(blocks);
  grade.resolution = finest_change(accel_mps2);
  grade.dead = grade.extremes.low == grade.extremes.high;
  if (grade.dead) return grade;
  const auto before = accel_mps2.first(std::min(quiet, accel_mps2.size()));
  grade.clipped_samples = count_clipped_samples(accel_mps2, blocks, accel_mps2, resting_level(before, accel_mps2));
  return grade;
}

ResponseGrade grade_response(const Hit& hit, std::span<const double> accel_mps2, double fs_Hz) {
  if (hit.gated_N.empty() || accel_mps2.size() <= hit.peak - hit.first) return {};
  ResponseGrade grade = grade_clipping(accel_mps2, quiet_samples(hit, accel_mps2.size()));
  if (grade.dead) return grade;
  const auto quiet = quiet_part(hit, accel_mps2);
  const Spread before = spread_of(subsampled(quiet, kQuietSamples));
  grade_before(grade, hit, accel_mps2);
  grade_end(grade, hit, accel_mps2);
  const Extremes extremes = grade.extremes;
  grade_onset(grade, hit, accel_mps2, extremes, before, fs_Hz);
  grade.coarse_step = coarse_step(accel_mps2, extremes.max_distance_from(resting_level(quiet, accel_mps2)));
  return grade;
}

std::size_t decayed_length(const Hit& hit, std::size_t samples, const SampleWindow& accel_mps2) {
  while (samples > 0) {
    const std::size_t shorter = decayed_within(hit, samples, accel_mps2);
    if (2 * shorter > samples) return std::min(shorter, samples);
    samples = shorter;  // again, with windows that suit the shorter length
  }
  return 0;
}

void add_response_findings(Hit& hit, const std::vector<ResponseGrade>& channels) {
  const ResponseGrade* worst = nullptr;
  std::size_t clipped = 0;
  for (const ResponseGrade& grade : channels) {
    clipped = std::max(clipped, grade.clipped_samples);
    if (grade.truncated && (worst == nullptr || grade.end_level_dB > worst->end_level_dB)) worst = &grade;
  }
  if (clipped > 0) {
    hit.findings.push_back({.code = FindingCode::overload,
                            .severity = Severity::reject,
                            .value = static_cast<double>(clipped),
                            .message = fmt::format("acceleration clipped in {} sample{}; raise the input range",
                                                   clipped, plural(clipped))});
  }
  if (worst != nullptr) {
    hit.findings.push_back(
        {.code = FindingCode::truncated_decay,
         .severity = Severity::warn,
         .value = worst->end_level_dB,
         .message = fmt::format("still ringing at the end, {:.0f} dB below the start; record longer, or rely on the "
                                "fitted damping, which allows for the missing decay",
                                -worst->end_level_dB)});
  }
}

}  // namespace percuss::acquire
