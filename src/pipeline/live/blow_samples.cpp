#include "pipeline/live/blow_samples.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "acquire/hits/hits.hpp"
#include "acquire/hits/response_grade.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinSamples = 256;
constexpr double kSpare = 1.5;  // a harder blow rings longer
// Of the samples: enough steady background follows a decay of at most this length to know its end.
constexpr double kSettled = 0.75;

// By the finding `truncated_decay` of the analysis.
bool has_ended(const acquire::Hit& hit, std::span<const double> accel, double fs_Hz) {
  return !acquire::grade_response(hit, accel, fs_Hz).truncated;
}

std::vector<double> channel(const SampleHistory& history, std::size_t index, double to_SI, std::uint64_t first,
                            std::size_t samples) {
  std::vector<double> x(samples);
  history.read(index, first, x);
  for (double& value : x) value *= to_SI;
  return x;
}

}  // namespace

BlowSamples read_blow(const SampleHistory& history, const LiveChannels& channels, std::uint64_t first,
                      std::size_t samples) {
  BlowSamples out{channel(history, channels.force, channels.force_to_N, first, samples)};
  for (std::size_t c = 0; c < channels.accel.size(); ++c)
    out.push_back(channel(history, channels.accel[c], channels.accel_to_mps2[c], first, samples));
  return out;
}

acquire::Record record_of_blow(const acquire::Record& description, const BlowSamples& samples) {
  acquire::Record record = description;
  record.rows = {{.samples = samples.front().size()}};
  record.read_force_N = [&samples](std::size_t /*row*/, std::size_t first, std::span<double> out) {
    std::copy_n(samples[0].begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  record.read_accel_mps2 = [&samples](std::size_t /*row*/, std::size_t c, std::size_t first, std::span<double> out) {
    std::copy_n(samples[c + 1].begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  return record;
}

acquire::Hit largest_hit(const acquire::Record& record, std::size_t pretrigger) {
  const auto hits =
      acquire::find_hits(record, {.pretrigger_s = static_cast<double>(pretrigger) / record.fs_Hz, .gate_force = true});
  return *std::max_element(hits.begin(), hits.end(), [](const acquire::Hit& a, const acquire::Hit& b) {
    return std::abs(a.peak_N) < std::abs(b.peak_N);
  });
}

std::optional<std::size_t> decayed_samples(const acquire::Record& description, const BlowSamples& samples,
                                           std::size_t pretrigger) {
  const acquire::Record record = record_of_blow(description, samples);
  const acquire::Hit hit = largest_hit(record, pretrigger);
  const std::size_t all = samples.front().size();
  if (hit.gated_N.empty() || hit.first >= all) return {};
  const auto ended_in = [&](std::size_t length) {
    return std::all_of(samples.begin() + 1, samples.end(), [&](const std::vector<double>& accel) {
      return has_ended(hit, std::span(accel).first(length).subspan(hit.first), record.fs_Hz);
    });
  };
  const auto with_spare = [&](std::size_t length) {
    return std::min(all, static_cast<std::size_t>(kSpare * static_cast<double>(length)));
  };
  if (!ended_in(all)) {  // a steady background may hide the end
    std::size_t longest = 0;
    for (std::size_t c = 1; c < samples.size(); ++c) {
      const auto accel = std::span(samples[c]).subspan(hit.first);
      const auto window = [&](std::size_t first, std::size_t count) { return accel.subspan(first, count); };
      longest = std::max(longest, hit.first + acquire::decayed_length(hit, accel.size(), window));
    }
    if (static_cast<double>(longest) > kSettled * static_cast<double>(all)) return {};
    return with_spare(longest);
  }
  for (const std::size_t eighths : {4U, 5U, 6U, 7U}) {
    const std::size_t shorter = all * eighths / 8;
    if (shorter >= kMinSamples && shorter > hit.peak && ended_in(shorter)) return with_spare(shorter);
  }
  return all;
}

}  // namespace percuss::pipeline
