#include "pipeline/hits/response_clipping.hpp"

#include <gtest/gtest.h>

namespace percuss::pipeline::response_clipping_test {

AnalysedHit hit_of(Extremes extremes, double resolution) {
  AnalysedHit hit;
  hit.responses = {{.extremes = extremes, .resolution = resolution}};
  return hit;
}

std::vector<std::size_t> clipped_samples_of(std::vector<AnalysedHit> hits) {
  grade_repeated_clipping(hits);
  std::vector<std::size_t> out;
  out.reserve(hits.size());
  for (const AnalysedHit& hit : hits) out.push_back(hit.responses.empty() ? 0 : hit.responses.front().clipped_samples);
  return out;
}

using Counts = std::vector<std::size_t>;

TEST(RepeatedClipping, IsFoundWhereDifferentHitsHaveOneExtreme) {
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1e-6), hit_of({-87, 100}, 1e-6), hit_of({-84, 99}, 1e-6)}),
            (Counts{1, 1, 0}));
  EXPECT_EQ(clipped_samples_of({hit_of({-100, 91}, 1e-6), hit_of({-100, 87}, 1e-6), hit_of({-99, 84}, 1e-6)}),
            (Counts{1, 1, 0}));
}

TEST(RepeatedClipping, IgnoresEqualPeaksBelowTheLargest) {
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 90}, 1e-6), hit_of({-87, 90}, 1e-6), hit_of({-84, 99}, 1e-6)}),
            (Counts{0, 0, 0}));
}

// At eight bits, two of five peaks agree by chance in every second test. Hits of an automatic hammer agree entirely.
TEST(RepeatedClipping, IgnoresChanceAndEqualHits) {
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1), hit_of({-87, 100}, 1), hit_of({-84, 99}, 1)}),
            (Counts{0, 0, 0}));
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 0.01), hit_of({-91, 100}, 0.01), hit_of({-91, 100}, 0.01)}),
            (Counts{0, 0, 0}));
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1), hit_of({-90, 100}, 1), hit_of({-91, 100}, 1)}),
            (Counts{0, 0, 0}));
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1e-6)}), (Counts{0}));
  EXPECT_EQ(clipped_samples_of({AnalysedHit{}, hit_of({-91, 100}, 1e-6)}), (Counts{0, 0}));
}

TEST(RepeatedClipping, IgnoresAHitThatWasRecordedTwice) {
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1e-6), hit_of({-87, 96}, 1e-6), hit_of({-91, 100}, 1e-6)}),
            (Counts{0, 0, 0}));
}

TEST(RepeatedClipping, IsFoundAtEqualExtremesOnBothSides) {
  EXPECT_EQ(clipped_samples_of({hit_of({-100, 100}, 1e-6), hit_of({-87, 95}, 1e-6), hit_of({-100, 93}, 1e-6)}),
            (Counts{1, 0, 1}));
  EXPECT_EQ(clipped_samples_of({hit_of({-91, 100}, 1e-6), hit_of({-87, 100}, 1e-6), hit_of({-100, 93}, 1e-6)}),
            (Counts{1, 1, 1}));
  EXPECT_EQ(clipped_samples_of({hit_of({-100, 100}, 1), hit_of({-87, 95}, 1)}), (Counts{0, 0}));
}

}  // namespace percuss::pipeline::response_clipping_test
