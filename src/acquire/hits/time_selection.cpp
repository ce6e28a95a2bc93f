#include "acquire/hits/time_selection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kPretriggerSamples = 128;
constexpr double kPretrigger_s = 0.005;
constexpr double kMaxSamples = 1e15;  // of any record

std::size_t samples_in(double seconds, double fs_Hz) {
  return static_cast<std::size_t>(std::clamp(seconds * fs_Hz, 0.0, kMaxSamples));
}

}  // namespace

SampleRange select_time_range(const Record& record, std::size_t row, const HitOptions& options) {
  const std::size_t samples = record.rows[row].samples;
  const auto index = [&](double t) {
    return static_cast<std::size_t>(std::clamp(t * record.fs_Hz, 0.0, static_cast<double>(samples)));
  };
  const SampleRange part{index(options.from_s), options.to_s ? index(*options.to_s) : samples};
  if (part.first < part.last) return part;
  throw InputError(fmt::format("no samples between {} s and {}: the row is {:.6g} s long", options.from_s,
                               options.to_s ? fmt::format("{} s", *options.to_s) : "the end",
                               static_cast<double>(samples) / record.fs_Hz),
                   record.files.empty() ? "record" : record.files[record.rows[row].file].path,
                   "choose an earlier start or a later end", {"from", "to"});
}

std::size_t pretrigger_samples(const Record& record, const HitOptions& options, std::size_t rise) {
  if (options.pretrigger_s) return samples_in(*options.pretrigger_s, record.fs_Hz);
  return std::max({kPretriggerSamples, static_cast<std::size_t>(kPretrigger_s * record.fs_Hz), 2 * rise});
}

std::optional<std::size_t> selected_length(const Record& record, const HitOptions& options) {
  if (!options.length_s) return std::nullopt;
  const std::size_t samples = samples_in(*options.length_s, record.fs_Hz);
  if (samples > 1) return samples;
  throw InputError(
      fmt::format("a length of {} s holds fewer than two samples at {:.6g} Hz", *options.length_s, record.fs_Hz),
      record.source(), "choose a longer one", {"length"});
}

}  // namespace percuss::acquire
