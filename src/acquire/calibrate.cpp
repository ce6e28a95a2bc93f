#include "acquire/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kBefore = 8;    // samples before the pulse that give the offsets
constexpr double kCompared = 0.5;     // of the peak: smaller forces are not compared
constexpr double kMinForce = 0.2;     // of the largest hit
constexpr double kMaxRinging = 0.05;  // rms of the acceleration after the pulse, over its peak

double mean(const std::vector<double>& x, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += x[i];
  return last > first ? sum / static_cast<double>(last - first) : 0;
}

// Of the first `count` values; 0 for fewer than two.
double variance(const std::vector<double>& x, std::size_t count) {
  if (count < 2) return 0;
  const double middle = mean(x, 0, count);
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i) squares += (x[i] - middle) * (x[i] - middle);
  return squares / static_cast<double>(count - 1);
}

// Root mean square of the acceleration after the pulse, over its peak: a free mass moves on without acceleration.
double ringing_after(const Record& record, const Hit& hit, std::size_t pulse, double rest_mps2, double peak_mps2) {
  constexpr std::size_t kFilter = 16, kMinWindow = 64, kPulses = 8;  // samples, samples, lengths of the pulse
  const std::size_t end = record.rows[hit.row].samples, first = hit.peak + pulse + kFilter;
  if (first >= end || !(std::abs(peak_mps2) > 0)) return 0;
  std::vector<double> accel(std::min(end - first, std::max(kMinWindow, kPulses * pulse)));
  record.read_accel_mps2(hit.row, 0, first, accel);
  double squares = 0;
  for (const double a : accel) squares += (a - rest_mps2) * (a - rest_mps2);
  return std::sqrt(squares / static_cast<double>(accel.size())) / std::abs(peak_mps2);
}

// The standard deviation of a hit's scale, from the residuals of the fit. It includes the noise of the offsets.
double scale_std(double residual_squares, double sum_f, double power, std::size_t samples) {
  if (!(power > 0)) return 0;
  const double noise = residual_squares / static_cast<double>(std::max<std::size_t>(samples, 2) - 1);
  return std::sqrt(noise * (1 / power + sum_f * sum_f / (kBefore * power * power)));
}

CalibrationHit compare(const Record& record, const Hit& hit, double mass_kg) {
  const auto pulse = static_cast<std::size_t>(std::ceil(hit.pulse_s * record.fs_Hz)) + 2;
  const auto onset = static_cast<std::size_t>(hit.onset_s * record.fs_Hz);  // the last sample before the rise
  const std::size_t first = onset > kBefore ? onset - kBefore : 0;
  const std::size_t last = std::min(record.rows[hit.row].samples, hit.peak + pulse);
  std::vector<double> force(last - first), accel(last - first);
  record.read_force_N(hit.row, first, force);
  record.read_accel_mps2(hit.row, 0, first, accel);
  const double force_rest = mean(force, 0, onset - first);
  const double accel_rest = mean(accel, 0, onset - first);
  CalibrationHit out{.time_s = hit.onset_s, .peak_force = hit.peak_N};
  double cross = 0, power = 0, sum_f = 0;
  std::vector<std::pair<double, double>> compared;  // force and magnitude of the acceleration
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double f = force[i] - force_rest;
    const double a = accel[i] - accel_rest;
    if (f * hit.peak_N < kCompared * hit.peak_N * hit.peak_N) continue;
    compared.emplace_back(f, std::abs(a));
    cross += f * std::abs(a);
    power += f * f;
    sum_f += f;
    if (std::abs(a) > std::abs(out.peak_accel_mps2)) out.peak_accel_mps2 = a;
  }
  out.samples = compared.size();
  out.scale = power > 0 ? mass_kg * cross / power : 0;
  double residual = 0;
  for (const auto& [f, a] : compared) residual += std::pow(mass_kg * a - out.scale * f, 2);
  if (out.samples == 1) {  // no residual: the noise before the hit
    residual =
        mass_kg * mass_kg * variance(accel, onset - first) + out.scale * out.scale * variance(force, onset - first);
  }
  out.scale_std = scale_std(residual, sum_f, power, out.samples);
  out.ringing = ringing_after(record, hit, pulse, accel_rest, out.peak_accel_mps2);
  return out;
}

void require_free_mass(double ringing, const std::string& where) {
  if (ringing <= kMaxRinging) return;
  throw InputError(
      fmt::format("the mass is not free: after the pulses, the acceleration is still {:.0f} % of its peak (rms), "
                  "like the ringing of a structure",
                  100 * ringing),
      where, "hit a compact mass that hangs freely");
}

}  // namespace

Calibration calibrate(const Record& record, double mass_kg, const HitOptions& options) {
  const std::string where = record.source();
  if (record.accel.size() != 1) {
    throw InputError("calibration takes one acceleration channel, not " + std::to_string(record.accel.size()), where,
                     "name the one on the free mass", {"accel_channel"});
  }
  Calibration out;
  double largest = 0;
  const std::vector<Hit> hits = find_hits(record, options);
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const Hit& hit = hits[h];
    if (hit.gated_N.empty()) continue;  // no pulse
    out.hits.push_back(compare(record, hit, mass_kg));
    out.hits.back().index = h;
    largest = std::max(largest, std::abs(hit.peak_N));
  }
  double weights = 0, sum = 0, squares = 0;
  std::size_t used = 0;
  for (CalibrationHit& hit : out.hits) {
    hit.used = std::abs(hit.peak_force) >= kMinForce * largest && hit.samples > 0;
    if (!hit.used) continue;
    weights += hit.peak_force * hit.peak_force;
    sum += hit.peak_force * hit.peak_force * hit.scale;
    ++used;
  }
  if (used == 0) {
    throw NoHitError("no hit on the free mass", where, "check the force channel, or lower the trigger level",
                     {"trigger"});
  }
  out.scale = sum / weights;
  double noise = 0;
  std::vector<double> ringing;
  for (const CalibrationHit& hit : out.hits) {
    if (!hit.used) continue;
    squares += std::pow(hit.peak_force * (hit.scale - out.scale), 2);
    noise += std::pow(hit.peak_force * hit.peak_force * hit.scale_std, 2);
    ringing.push_back(hit.ringing);
  }
  out.scale_std = std::sqrt(noise) / weights;
  if (used > 1) out.scale_std = std::max(out.scale_std, std::sqrt(squares / weights / static_cast<double>(used - 1)));
  require_free_mass(median(ringing), where);
  return out;
}

}  // namespace percuss::acquire
