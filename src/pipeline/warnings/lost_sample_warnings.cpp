#include "pipeline/warnings/lost_sample_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/io/counted_words.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxGaps = 8;  // in one message

std::string list_of(const std::vector<LostSamples>& lost) {
  return limited_list(lost.size(), kMaxGaps, [&](std::size_t i) {
    const std::string place = lost[i].after_s > 0 ? fmt::format("{:.4g} ms after the blow", lost[i].after_s * 1e3)
                                                  : std::string("within the pulse or just beside it");
    return fmt::format("hit {} ({}, {})", lost[i].hit + 1, samples_text(lost[i].count), place);
  });
}

}  // namespace

std::vector<Warning> lost_samples_warning(const std::vector<LostSamples>& lost, const std::string& rest) {
  if (lost.empty()) return {};
  std::vector<LostSamples> predicted, others;
  std::partition_copy(lost.begin(), lost.end(), std::back_inserter(predicted), std::back_inserter(others),
                      [](const LostSamples& one) { return one.predicted; });
  std::string text = "the times in the file show that samples are missing";
  if (!predicted.empty()) {
    text += " in " + list_of(predicted) +
            ". Samples predicted from both sides take their place, so the modes describe the whole decay";
  }
  if (!others.empty())
    text += (predicted.empty() ? " in " : ". In ") + list_of(others) + ", where they cannot be predicted: " + rest;
  return {with_remedy({"lost_samples", text},
                      "restore the lost lines, or record again with a lower sampling rate, fewer channels or a faster "
                      "disk")};
}

std::vector<Warning> closed_gap_warnings(const ClosedGaps& closed, const std::vector<AnalysedHit>& hits) {
  std::vector<LostSamples> lost;
  for (std::size_t g = 0; g < closed.gaps.size(); ++g) {
    const auto& [h, at] = closed.gaps[g];
    if (!hits[h].accepted) continue;
    const bool failed = std::find(closed.failed.begin(), closed.failed.end(), g) != closed.failed.end();
    lost.push_back({.hit = h,
                    .count = at.gap.count,
                    .after_s = static_cast<double>(at.gap.first - hits[h].hit.peak) / closed.record.fs_Hz,
                    .predicted = !failed});
  }
  // A hit with a gap in its pulse is accepted only if the user accepts it.
  for (const std::size_t h : accepted_hits(hits)) {
    for (const acquire::Finding& finding : hits[h].hit.findings) {
      if (finding.code == acquire::FindingCode::lost_samples && !finding.delay_s)
        lost.push_back({.hit = h, .count = static_cast<std::size_t>(finding.value)});
    }
  }
  return lost_samples_warning(lost, "a straight line takes their place, and results may be off by more than their ±");
}

}  // namespace percuss::pipeline
