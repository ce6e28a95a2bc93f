#include "pipeline/impact_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/impacts.hpp"
#include "pipeline/warnings/deflection_warnings.hpp"
#include "support/changed_record.hpp"
#include "support/force_row.hpp"
#include "support/magnitude.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "support/record_samples.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::impact_test_test {

ImpactTest deflect_with(std::optional<double> pretrigger_s) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 205, .damping_ratio = 0.008, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 1.5);
  spec.layout = synth::SynthLayout::continuous;
  spec.hit_times_s = {0.5};
  spec.hits = 1;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return deflect(Analysis(synth::synthesise(spec).record,
                          {.band_Hz = std::pair{60.0, 1000.0}, .hits = {.pretrigger_s = pretrigger_s}, .threads = 1}),
                 {.deflection = {.method = metrics::DeflectionMethod::drift_free, .free_body = true}});
}

// A longer rest before the hit determines bias and drift better. The rest of a pre-trigger of 5 ms would leave an
// uncertainty of about 1 m after a second. Here half a second of rest is recorded.
TEST(ImpactTest, TakesTheBiasFromALongRest) {
  const ImpactTest test = deflect_with({});
  ASSERT_FALSE(test.hits.empty());
  EXPECT_NEAR(test.hits[0].first_s, 0.4, 5e-3);  // 0.1 s of rest before the gate, which begins some ms before 0.5 s
  EXPECT_LT(test.hits[0].deflection.drift_m, deflect_with(0.01).hits.at(0).deflection.drift_m / 20);
}

TEST(ImpactTest, KeepsAStatedPretrigger) { EXPECT_NEAR(deflect_with(0.01).hits.at(0).first_s, 0.49, 1e-3); }

// Three blows on a held structure, of which the second exceeds the range of the accelerometer.
acquire::Record record_with_a_clipped_blow(double limit_mps2) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 40, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.5}}, 1.5);
  spec.pretrigger_s = 0.1;
  spec.hits = 3;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return test::with_changed_accel(synth::synthesise(spec).record,
                                  [=](std::size_t row, std::size_t, std::vector<double>& x) {
                                    if (row != 1) return;
                                    for (double& value : x) value = std::clamp(value, -limit_mps2, limit_mps2);
                                  });
}

// The first motion, during the pulse, is 40 times larger than the ringing after it.
double largest_of_the_second_blow() {
  return test::largest_magnitude(test::accel_mps2(record_with_a_clipped_blow(1e9), 0, 1));
}

std::vector<std::size_t> deflected_hits(const ImpactTest& test) {
  std::vector<std::size_t> out;
  for (const DeflectedHit& hit : test.hits) {
    if (hit.channel == 0) out.push_back(hit.hit);
  }
  return out;
}

ImpactTest deflection_of_clipped(double limit_mps2, std::vector<std::size_t> accepted, bool force = true,
                                 metrics::DeflectionMethod method = metrics::DeflectionMethod::automatic) {
  acquire::Record record = record_with_a_clipped_blow(limit_mps2);
  if (!force) {
    record.has_force = false;
    record.read_force_N = acquire::no_force();
  }
  const Analysis analysis(std::move(record),
                          {.band_Hz = std::pair{20.0, 1000.0}, .accept_hits = std::move(accepted), .threads = 1});
  return deflect(analysis, {.deflection = {.method = method}});
}

const auto kClipped =
    testing::Contains(testing::AllOf(testing::StartsWith("response_clipped: an acceleration is clipped in hit 2 ("),
                                     testing::HasSubstr("raise the input range")));

TEST(ImpactTest, LeavesOutAClippedImpact) {
  const double limit_mps2 = largest_of_the_second_blow() / 100;
  for (const bool force : {true, false}) {
    const ImpactTest whole = deflection_of_clipped(1e9, {}, force);
    EXPECT_THAT(deflected_hits(whole), testing::ElementsAre(0, 1, 2)) << force;
    EXPECT_THAT(test::lines_of_messages(whole.warnings), testing::Not(kClipped)) << force;
    const ImpactTest clipped = deflection_of_clipped(limit_mps2, {}, force);
    EXPECT_THAT(deflected_hits(clipped), testing::ElementsAre(0, 2)) << force;
    EXPECT_THAT(test::lines_of_messages(clipped.warnings), kClipped) << force;
    ASSERT_FALSE(clipped.points.empty());
    EXPECT_EQ(clipped.points[0].hits, 2U);
  }
}

TEST(ImpactTest, WarnsOfAClippedImpactThatTheUserAccepts) {
  const double limit_mps2 = largest_of_the_second_blow() / 100;
  const ImpactTest test = deflection_of_clipped(limit_mps2, {1});
  EXPECT_THAT(deflected_hits(test), testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(test::lines_of_messages(test.warnings), testing::Contains(testing::HasSubstr("accepted by the user")));
}

// The modes come from the other hits, and the force of this one is whole.
TEST(ImpactTest, KeepsTheModalDeflectionOfAClippedImpact) {
  const double limit_mps2 = largest_of_the_second_blow() / 100;
  const ImpactTest test = deflection_of_clipped(limit_mps2, {}, true, metrics::DeflectionMethod::modal);
  EXPECT_THAT(deflected_hits(test), testing::ElementsAre(0, 1, 2));
}

// A sound card couples its channels by AC. 2 Hz change a deflection of 5 mm after 0.1 s by far more than 0.04 mm.
TEST(ImpactTest, WarnsOfAnAcCoupledForceWhereItsCornerMatters) {
  const auto warnings = [](double coupling_Hz, double peak_std_m) {
    metrics::Deflection deflection;
    deflection.peak = 4800;
    deflection.peak_m = 0.005;
    deflection.peak_std_m = peak_std_m;
    return deflection_warnings(
        {.rest_recorded = true, .coupling_Hz = coupling_Hz, .deflections = {{0, &deflection, 0.0, 48000.0}}});
  };
  const auto coupled = testing::Contains(testing::Field(&Warning::code, "ac_coupling"));
  EXPECT_THAT(warnings(2, 4e-5), coupled);
  EXPECT_THAT(test::lines_of_messages(warnings(2, 4e-5)), testing::Contains(testing::HasSubstr("a corner of 2 Hz")));
  EXPECT_THAT(warnings(0, 4e-5), testing::Not(coupled));
  EXPECT_THAT(warnings(1e-4, 4e-5), testing::Not(coupled));
}

// A ball strikes, and the hammer's channel holds noise: the deflections are the ones without a force.
TEST(ImpactTest, TakesAnIdleForceForNone) {
  const auto with_force = [](double noise_N) {
    acquire::Record record = record_with_a_clipped_blow(1e9);
    record.contiguous.clear();
    record.read_force_N = [noise_N](std::size_t row, std::size_t first, std::span<double> out) {
      std::vector<double> x(first + out.size());
      test::add_noise(x, noise_N, row + 1);
      std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
    };
    return record;
  };
  const AnalysisOptions options{.band_Hz = std::pair{20.0, 1000.0}, .threads = 1};
  const ImpactTest expected = deflection_of_clipped(1e9, {}, false);
  for (const double noise_N : {0.0, 0.2}) {
    const auto without = record_without_idle_force(Analysis(with_force(noise_N), options));
    ASSERT_TRUE(without) << noise_N;
    const ImpactTest test = deflect(Analysis(*without, options));
    ASSERT_EQ(test.hits.size(), expected.hits.size());
    for (std::size_t i = 0; i < test.hits.size(); ++i)
      EXPECT_EQ(test.hits[i].deflection.peak_m, expected.hits[i].deflection.peak_m);
    EXPECT_THAT(test::lines_of_messages(test.warnings),
                testing::Contains(testing::StartsWith("input: force stays in its noise, while accel 1 responds")));
  }
  AnalysisOptions triggered = options;
  triggered.hits.trigger_N = 5;
  EXPECT_FALSE(record_without_idle_force(Analysis(with_force(0.2), triggered)));
  EXPECT_FALSE(record_without_idle_force(Analysis(record_with_a_clipped_blow(1e9), options)));
}

// Without a motion, nothing shows an impact: a hammer that lost its cable is the likelier fault.
TEST(ImpactTest, KeepsAnIdleForceWhereNothingMoves) {
  acquire::Record record = test::with_changed_accel(record_with_a_clipped_blow(1e9),
                                                    [](std::size_t row, std::size_t, std::vector<double>& x) {
                                                      std::fill(x.begin(), x.end(), 0);
                                                      test::add_noise(x, 0.1, row);
                                                    });
  record.read_force_N = acquire::no_force();
  EXPECT_FALSE(record_without_idle_force(Analysis(std::move(record), {.threads = 1})));
}

// The mean of three hits on a held structure; hits in `reversed` move the other way.
PointDeflection mean_with_reversed(const std::vector<std::size_t>& reversed) {
  acquire::Record record = test::with_changed_accel(
      record_with_a_clipped_blow(1e9), [reversed](std::size_t row, std::size_t, std::vector<double>& x) {
        if (std::find(reversed.begin(), reversed.end(), row) == reversed.end()) return;
        for (double& value : x) value = -value;
      });
  return deflect(Analysis(std::move(record), {.band_Hz = std::pair{20.0, 1000.0}, .threads = 1})).points.at(0);
}

TEST(ImpactTest, AveragesTheLargestDeflectionsWithTheirSign) {
  const PointDeflection mean = mean_with_reversed({}), reversed = mean_with_reversed({0, 1, 2});
  EXPECT_NE(mean.peak_m, 0);
  EXPECT_FALSE(mean.directions_differ || reversed.directions_differ);
  EXPECT_NEAR(reversed.peak_m, -mean.peak_m, 1e-9 * std::abs(mean.peak_m));
  EXPECT_NEAR(reversed.std_m, mean.std_m, 1e-9 * std::abs(mean.peak_m));
  EXPECT_GT(reversed.forward_m, 0) << "a magnitude, along the first motion";
}

// Swings to opposite sides have no mean that describes a motion.
TEST(ImpactTest, StatesNoMeanOfOppositeDirections) {
  const PointDeflection mixed = mean_with_reversed({1});
  EXPECT_TRUE(mixed.directions_differ);
  EXPECT_EQ(mixed.hits, 3U);
  EXPECT_TRUE(std::isnan(mixed.peak_m) && std::isnan(mixed.std_m));
  EXPECT_NEAR(mixed.forward_m, mean_with_reversed({}).forward_m, 1e-9);
}

}  // namespace percuss::pipeline::impact_test_test
