#include "report/text/coherence_summary.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::coherence_summary_test {

pipeline::Analysis analysis_of(std::size_t hits) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 0.5);
  spec.hits = hits;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return {synth::synthesise(spec).record, {.band_Hz = std::pair{100.0, 400.0}, .threads = 1}};
}

TEST(CoherenceSummary, CountsOnlyTheLinesOfTheBand) {
  const pipeline::Analysis analysis = analysis_of(2);
  acquire::PointFrf frf = analysis.frfs().front();
  std::size_t inside = 0;
  for (std::size_t k = 0; k < frf.frf.coherence.size(); ++k) {
    const double freq_Hz = analysis.lines().freq_Hz(k);
    const bool in_band = freq_Hz >= 100 && freq_Hz <= 400;
    frf.frf.coherence[k] = !in_band ? 0 : ++inside % 4 == 0 ? 0.5 : 1;
  }
  ASSERT_GT(analysis.lines().count, inside);  // the lines extend beyond the band
  const auto summary = summary_of_coherence(analysis, frf);
  ASSERT_TRUE(summary);
  const std::size_t quarter = inside / 4;
  const double below = static_cast<double>(quarter) / static_cast<double>(inside);
  EXPECT_NEAR(summary->below, below, 1e-12);
  EXPECT_NEAR(summary->mean, 1 - below / 2, 1e-12);
}

TEST(CoherenceSummary, IsEmptyForASingleHit) {
  const pipeline::Analysis analysis = analysis_of(1);
  EXPECT_FALSE(summary_of_coherence(analysis, analysis.frfs().front()));
}

}  // namespace percuss::report::coherence_summary_test
