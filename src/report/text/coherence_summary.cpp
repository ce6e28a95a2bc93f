#include "report/text/coherence_summary.hpp"

#include <Eigen/Core>

#include "core/parallel/parallel.hpp"

namespace percuss::report {

namespace {

constexpr double kGood = 0.9;

}  // namespace

std::optional<CoherenceSummary> summary_of_coherence(const pipeline::Analysis& analysis, const acquire::PointFrf& frf) {
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  const acquire::LineRange& all = analysis.lines();
  const auto& coherence = frf.frf.coherence;
  std::size_t first = 0, end = coherence.size();
  while (first < end && all.freq_Hz(first) < low_Hz) ++first;
  while (end > first && all.freq_Hz(end - 1) > high_Hz) --end;
  const Eigen::Map<const Eigen::ArrayXd> inside(coherence.data() + first, static_cast<Eigen::Index>(end - first));
  if (inside.size() == 0) return std::nullopt;
  return CoherenceSummary{.mean = inside.mean(), .below = (inside < kGood).cast<double>().mean()};
}

std::vector<std::optional<CoherenceSummary>> coherence_summaries(const pipeline::Analysis& analysis) {
  const std::vector<acquire::PointFrf>& frfs = analysis.frfs();
  std::vector<std::optional<CoherenceSummary>> summaries(frfs.size());
  const ThreadLimit limit(analysis.options().threads);
  parallel_for_cost(frfs.size(), analysis.lines().count,
                    [&](std::size_t i) { summaries[i] = summary_of_coherence(analysis, frfs[i]); });
  return summaries;
}

}  // namespace percuss::report
