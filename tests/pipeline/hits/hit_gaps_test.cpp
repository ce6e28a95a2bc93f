#include "pipeline/hits/hit_gaps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/analysis.hpp"
#include "pipeline/response/response_test.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "support/record_samples.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::hit_gaps_test {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

acquire::Record bat(std::size_t hits = 3) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.hits = hits;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return synth::synthesise(spec).record;
}

// The record as a text file with lost lines gives it: straight lines in the place of the lost samples.
acquire::Record with_gaps(const acquire::Record& record, const std::vector<acquire::SampleGap>& gaps) {
  std::vector<std::vector<double>> force;
  std::vector<std::vector<std::vector<double>>> accel;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    force.push_back(test::force_N(record, row));
    accel.emplace_back();
    for (std::size_t c = 0; c < record.accel.size(); ++c) accel.back().push_back(test::accel_mps2(record, c, row));
  }
  const auto close = [](std::vector<double>& x, const acquire::SampleGap& gap) {
    const double before = x[gap.first - 1],
                 step = (x[gap.first + gap.count] - before) / static_cast<double>(gap.count + 1);
    for (std::size_t i = 0; i < gap.count; ++i) x[gap.first + i] = before + static_cast<double>(i + 1) * step;
  };
  for (const acquire::SampleGap& gap : gaps) {
    close(force[gap.row], gap);
    for (auto& x : accel[gap.row]) close(x, gap);
  }
  acquire::Record out = acquire::record_in_memory(record.fs_Hz, force, accel);
  for (std::size_t c = 0; c < out.accel.size(); ++c) out.accel[c].angle_rad = record.accel[c].angle_rad;
  for (const acquire::SampleGap& gap : gaps) out.faults.push_back(acquire::fault_of(gap, out.fs_Hz));
  return out;
}

Analysis analysis_of(acquire::Record record, AnalysisOptions options = {}) {
  options.band_Hz = std::pair{60.0, 3200.0};
  options.threads = 1;
  return {std::move(record), std::move(options)};
}

// Expects the modes of the record without gaps, at 200 Hz and 1900 Hz.
void expect_modes_as(const Analysis& analysis, const Analysis& whole) {
  ASSERT_EQ(analysis.modes().size(), whole.modes().size());
  for (std::size_t m = 0; m < whole.modes().size(); ++m) {
    const identify::Mode &one = analysis.modes()[m], &other = whole.modes()[m];
    EXPECT_NEAR(one.pole.freq_Hz, other.pole.freq_Hz, other.freq_std_Hz) << m;
    EXPECT_NEAR(one.pole.damping_ratio, other.pole.damping_ratio, other.damping_std) << m;
    EXPECT_LT(one.freq_std_Hz, 1.2 * other.freq_std_Hz) << m;
  }
}

std::size_t peak_of(const acquire::Record& record, std::size_t row) { return acquire::find_hits(record).at(row).peak; }

class HitGaps : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Lost, HitGaps, testing::Values(1, 4, 30));

// Samples lost early, in the middle and late in the decays, and before a blow.
TEST_P(HitGaps, DoNotChangeTheModes) {
  const acquire::Record record = bat();
  const std::size_t count = GetParam(), end = record.rows[0].samples;
  const Analysis whole = analysis_of(record);
  for (const std::size_t after : {std::size_t{80}, std::size_t{700}, end / 2}) {
    const std::size_t first = peak_of(record, 1) + after;
    const Analysis analysis = analysis_of(with_gaps(record, {{.row = 1, .first = first, .count = count}}));
    expect_modes_as(analysis, whole);
    EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
                Contains(StartsWith("lost_samples: the times in the file show that samples are missing in hit 2 (")));
    EXPECT_TRUE(analysis.hits()[1].accepted);
  }
  const Analysis before = analysis_of(with_gaps(record, {{.row = 1, .first = 10, .count = count}}));
  expect_modes_as(before, whole);
  EXPECT_THAT(test::codes_of(before.warnings()), Not(Contains("lost_samples")));
}

// A straight line through an oscillation is far from it: without the prediction, the modes would be off.
TEST(HitGapsOfARecord, AreFilledWithPredictedSamples) {
  const acquire::Record record = bat();
  const std::size_t first = peak_of(record, 0) + 600;
  const acquire::Record damaged = with_gaps(record, {{.row = 0, .first = first, .count = 20}});
  const acquire::Record closed = analysis_of(damaged).closed_gaps().record;
  std::vector<double> truth(20), line(20), predicted(20);
  record.read_accel_mps2(0, 0, first, truth);
  damaged.read_accel_mps2(0, 0, first, line);
  closed.read_accel_mps2(0, 0, first, predicted);
  double of_line = 0, of_prediction = 0, level = 0;
  for (std::size_t n = 0; n < truth.size(); ++n) {
    of_line += std::pow(line[n] - truth[n], 2);
    of_prediction += std::pow(predicted[n] - truth[n], 2);
    level += truth[n] * truth[n];
  }
  EXPECT_GT(of_line, 0.1 * level);
  EXPECT_LT(of_prediction, 1e-3 * level);
}

TEST(HitGapsOfARecord, WithinThePulseRejectTheHit) {
  const acquire::Record record = bat();
  const Analysis analysis = analysis_of(with_gaps(record, {{.row = 2, .first = peak_of(record, 2) + 2, .count = 1}}));
  const AnalysedHit& hit = analysis.hits()[2];
  EXPECT_FALSE(hit.accepted);
  ASSERT_TRUE(acquire::has_finding(hit.hit.findings, acquire::FindingCode::lost_samples));
  EXPECT_EQ(hit.hit.findings.front().message, "1 sample is missing within the pulse or just beside it; repeat the hit");
  const Analysis accepted =
      analysis_of(with_gaps(record, {{.row = 2, .first = peak_of(record, 2) + 2, .count = 1}}), {.accept_hits = {2}});
  EXPECT_TRUE(accepted.hits()[2].accepted);
  accepted.modes();
  EXPECT_THAT(test::lines_of_messages(accepted.warnings()),
              Contains(HasSubstr("a straight line takes their place, and results may be off by more than their ±")));
  EXPECT_FALSE(can_accept_more(analysis.hits())) << "the option would give results that do not hold";
}

TEST(HitGapsOfARecord, TooLongToPredictEndTheHit) {
  const acquire::Record record = bat();
  const std::size_t peak = peak_of(record, 1), end = record.rows[1].samples;
  const auto hit_of = [&](std::size_t first) {
    return analysis_of(with_gaps(record, {{.row = 1, .first = first, .count = 200}})).hits()[1];
  };
  EXPECT_FALSE(hit_of(peak + 1000).accepted) << "a short hit would shorten the others";
  const AnalysedHit late = hit_of(end - 1000);
  EXPECT_TRUE(late.accepted);
  EXPECT_EQ(late.hit.first + late.hit.samples, end - 1000);
  EXPECT_THAT(late.hit.findings.front().message, HasSubstr("cannot be predicted; the hit ends before them"));
  // A single hit may be used up to the gap, and its truncated decay is accounted for.
  const Analysis single =
      analysis_of(with_gaps(bat(1), {{.row = 0, .first = peak + 5000, .count = 200}}), {.accept_hits = {0}});
  ASSERT_EQ(single.modes().size(), 2U);
  EXPECT_NEAR(single.modes()[0].pole.freq_Hz, 200, 5 * single.modes()[0].freq_std_Hz);
  EXPECT_NEAR(single.modes()[1].pole.freq_Hz, 1900, 5 * single.modes()[1].freq_std_Hz);
}

TEST(HitGapsOfARecord, AreClosedWithoutAForce) {
  acquire::Record record = bat();
  const std::size_t first = peak_of(record, 1) + 3000;
  acquire::Record damaged = with_gaps(record, {{.row = 1, .first = first, .count = 5}});
  for (acquire::Record* one : {&record, &damaged}) {
    one->has_force = false;
    one->read_force_N = acquire::no_force();
  }
  const AnalysisOptions options{.band_Hz = std::pair{60.0, 3200.0}, .threads = 1};
  const ResponseTest whole = analyse_responses(record, options), test = analyse_responses(damaged, options);
  ASSERT_EQ(test.found.modes.size(), whole.found.modes.size());
  for (std::size_t m = 0; m < whole.found.modes.size(); ++m) {
    EXPECT_NEAR(test.found.modes[m].mode.pole.freq_Hz, whole.found.modes[m].mode.pole.freq_Hz,
                whole.found.modes[m].mode.freq_std_Hz);
  }
  EXPECT_THAT(test::codes_of(test.warnings), Contains("lost_samples"));
  EXPECT_THAT(test::codes_of(whole.warnings), Not(Contains("lost_samples")));
}

}  // namespace percuss::pipeline::hit_gaps_test
