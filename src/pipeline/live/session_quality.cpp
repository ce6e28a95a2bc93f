#include "pipeline/live/session_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/warnings/ranking.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMaxFurther = 9999;
// Warnings about the set-up, which further blows repeat.
constexpr std::array<std::string_view, 6> kOfSetUp = {"same_motion", "duplicate",   "dropout",
                                                      "skew",        "ac_coupling", "assumed_tube"};

bool makes_results_wrong(const Warning& warning) {
  return warning.severity == acquire::Severity::reject ||
         std::find(kOfSetUp.begin(), kOfSetUp.end(), warning.code) != kOfSetUp.end();
}

std::optional<double> lowest_coherence(const Analysis& analysis) {
  std::optional<double> lowest;
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    if (frf.frf.coherence.empty()) continue;
    const double typical = median(frf.frf.coherence);
    lowest = std::min(lowest.value_or(1), typical);
  }
  return lowest;
}

LiveMode live_mode(const identify::Mode& mode, const identify::ModeClassification& classification) {
  const double noise = mode.freq_std_parts_Hz.noise, hits = mode.freq_std_parts_Hz.hits;
  return {.type = classification.type,
          .order = classification.order,
          .freq_Hz = mode.pole.freq_Hz,
          .freq_std_Hz = mode.freq_std_Hz,
          .damping_ratio = mode.pole.damping_ratio,
          .damping_std = mode.damping_std,
          .falling_std_Hz = std::hypot(noise, hits)};
}

}  // namespace

std::string name_of(const LiveMode& mode, std::size_t index) {
  if (mode.type == identify::ModeType::unknown || mode.order == 0) return fmt::format("mode {}", index + 1);
  return fmt::format("{} {}", identify::name_of(mode.type), mode.order);
}

SessionQuality quality_of(const Analysis& analysis, std::size_t blows) {
  SessionQuality out{.blows = blows};
  try {
    if (!analysis.possible()) return out;
    analysis.compute_modes_and_frfs();
    const auto& types = analysis.classifications();
    for (std::size_t m = 0; m < analysis.modes().size(); ++m)
      out.modes.push_back(live_mode(analysis.modes()[m], types[m]));
    out.coherence = lowest_coherence(analysis);
    for (const Warning& warning : ranked(analysis.warnings())) {
      if (makes_results_wrong(warning)) out.problems.push_back({.code = warning.code, .text = warning.message});
    }
  } catch (const InputError&) {  // too few blows for these options: the next blow may suffice
    out.modes.clear();
  }
  return out;
}

SessionQuality session_quality(acquire::Record record, const AnalysisOptions& options) {
  const auto blows = static_cast<std::size_t>(std::count_if(
      record.rows.begin(), record.rows.end(), [](const auto& row) { return row.mark == acquire::RowMark::none; }));
  if (blows == 0) return {};
  std::vector<acquire::Record> records;
  records.push_back(std::move(record));
  const auto runs = analyses_of_runs(std::move(records), options);
  return quality_of(*runs.front().analysis, blows);
}

std::optional<std::size_t> further_blows(const LiveMode& mode, std::size_t blows, double target_Hz) {
  if (mode.freq_std_Hz <= target_Hz) return 0;
  const double falling = mode.falling_std_Hz * mode.falling_std_Hz;
  const double constant = std::max(0.0, mode.freq_std_Hz * mode.freq_std_Hz - falling);
  const double left = target_Hz * target_Hz - constant;
  if (!(left > 0) || !(falling > 0)) return {};
  const double needed = std::ceil(static_cast<double>(blows) * falling / left - 1e-9) - static_cast<double>(blows);
  if (needed > kMaxFurther) return {};
  return static_cast<std::size_t>(std::max(needed, 1.0));
}

}  // namespace percuss::pipeline
