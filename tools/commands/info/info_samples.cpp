#include "commands/info/info_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "acquire/channels/role_guess.hpp"
#include "acquire/hits/hits.hpp"
#include "acquire/record/sample_gap.hpp"
#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxSamples = std::size_t{1} << 22U;  // of one channel
constexpr std::size_t kMaxInAll = std::size_t{1} << 26U;    // of all channels together
constexpr std::size_t kColumns = 48;                        // of the picture

std::size_t max_samples(const acquire::Record& record) {
  return std::min(kMaxSamples, kMaxInAll / (record.accel.size() + 1));
}

// The samples of a channel, row after row: at most max_samples().
template <class Read>
std::vector<double> first_samples(const acquire::Record& record, const Read& read) {
  std::vector<double> samples;
  const std::size_t max = max_samples(record);
  for (std::size_t row = 0; row < record.rows.size() && samples.size() < max; ++row) {
    const std::size_t count = std::min(record.rows[row].samples, max - samples.size());
    samples.resize(samples.size() + count);
    read(row, std::span(samples).last(count));
  }
  return samples;
}

ChannelSamples summary_of(const std::vector<double>& samples) {
  ChannelSamples out{.envelope = std::vector<double>(std::min(kColumns, samples.size()))};
  double squares = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    squares += samples[i] * samples[i];
    if (std::abs(samples[i]) > std::abs(out.peak)) out.peak = samples[i];
    double& largest = out.envelope[i * out.envelope.size() / samples.size()];
    largest = std::max(largest, std::abs(samples[i]));
  }
  out.rms = samples.empty() ? 0 : std::sqrt(squares / static_cast<double>(samples.size()));
  out.hammer_dissimilarity = acquire::hammer_dissimilarity(samples);
  return out;
}

// A light structure moves like the force during the pulse. So a response counts as a hammer only if the force does not
// look like one, and if the response's dissimilarity is at most kMaxDissimilarityRatio times the smallest.
void find_hammers(const acquire::Record& record, std::vector<Channel>& channels) {
  double smallest = 1;
  for (const Channel& channel : channels) smallest = std::min(smallest, channel.samples->hammer_dissimilarity);
  for (Channel& channel : channels) {
    const double dissimilarity = channel.samples->hammer_dissimilarity;
    channel.samples->hammer =
        dissimilarity < acquire::kMaxHammerDissimilarity && dissimilarity <= acquire::kMaxDissimilarityRatio * smallest;
  }
  if (!record.has_force || !channels.front().samples->hammer) return;
  for (std::size_t c = 1; c < channels.size(); ++c) channels[c].samples->hammer = false;
}

std::size_t pulses_in(const acquire::Record& record) {
  const std::vector<acquire::Hit> hits = acquire::find_hits(record);
  return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [](const acquire::Hit& hit) {
    return std::none_of(hit.findings.begin(), hit.findings.end(),
                        [](const auto& finding) { return finding.code == acquire::FindingCode::no_pulse; });
  }));
}

std::vector<Channel> channels_of(const acquire::Record& record) {
  std::vector<Channel> channels;
  if (record.has_force) channels.push_back({.signal = &record.force, .role = "force", .si_unit = "N"});
  for (const acquire::SignalInfo& signal : record.accel) {
    const bool pressure = signal.measures == Quantity::pressure;
    channels.push_back(
        {.signal = &signal, .role = pressure ? "pressure" : "acceleration", .si_unit = pressure ? "Pa" : "m/s^2"});
  }
  return channels;
}

}  // namespace

RecordSamples samples_of(const acquire::Record& record) {
  RecordSamples out;
  std::size_t total = 0;
  for (const acquire::RowInfo& row : record.rows) total += row.samples;
  out.partial = total > max_samples(record);
  out.channels = channels_of(record);
  const std::size_t first_accel = out.channels.size() - record.accel.size();
  try {
    if (record.has_force) {
      out.channels.front().samples = summary_of(
          first_samples(record, [&](std::size_t row, std::span<double> to) { record.read_force_N(row, 0, to); }));
    }
    for (std::size_t c = 0; c < record.accel.size(); ++c) {
      out.channels[first_accel + c].samples = summary_of(
          first_samples(record, [&](std::size_t row, std::span<double> to) { record.read_accel_mps2(row, c, 0, to); }));
    }
    find_hammers(record, out.channels);
    if (record.has_force && !out.partial) out.hits = pulses_in(record);
  } catch (const InputError& error) {
    out.problem = error;
  }
  return out;
}

std::vector<Message> notes_of(const acquire::Record& record, const RecordSamples& samples) {
  std::vector<Message> notes = record.notes;
  constexpr std::size_t kMaxGaps = 5;  // in a note
  if (const auto gaps = acquire::gaps_of(record); !gaps.empty()) {
    const std::string list = limited_list(gaps.size(), kMaxGaps, [&](std::size_t g) {
      const acquire::SampleGap& gap = gaps[g];
      return fmt::format("{} at {:.6g} s of row {}", gap.count, static_cast<double>(gap.first) / record.fs_Hz,
                         gap.row + 1);
    });
    notes.emplace_back("the times show that samples are missing: " + list);
  }
  if (samples.problem) return notes;  // the channels were not compared
  if (samples.partial) notes.emplace_back("a long record: rms, peak and picture are those of its beginning");
  for (const Channel& channel : samples.channels) {
    if (!channel.samples) continue;
    const bool force = channel.signal == &record.force;
    if (force && !channel.samples->hammer)
      notes.emplace_back("the force does not look like a hammer's pulses", std::vector<OptionId>{"force_channel"});
    if (!force && channel.samples->hammer) {
      notes.emplace_back(one_line(channel.signal->name, 40) + " looks like a hammer's pulses",
                         std::vector<OptionId>{"force_channel", "accel_channel"});
    }
  }
  return notes;
}

std::string picture_of(std::span<const double> envelope) {
  constexpr std::array<const char*, 8> kBlocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const double largest = envelope.empty() ? 0 : *std::max_element(envelope.begin(), envelope.end());
  std::string out;
  for (const double value : envelope) {
    const double level = largest > 0 ? value / largest * static_cast<double>(kBlocks.size()) : 0;
    out += kBlocks.at(std::min(static_cast<std::size_t>(level), kBlocks.size() - 1));
  }
  return out;
}

}  // namespace percuss::tools
