#include "pipeline/stages/earlier_ringing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/analysis.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::earlier_ringing_test {

using testing::Contains;
using testing::Each;
using testing::Not;

// Two modes whose time constants are 0.5 and 0.2 s, struck in one long record.
synth::SyntheticTest struck_at(const std::vector<double>& times_s, std::uint64_t seed) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 98, .damping_ratio = 0.0031, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                      {.freq_Hz = 530, .damping_ratio = 0.0017, .order = 2, .amplitude_per_sqrt_kg = 1.4}},
                     times_s.back() + 1.5);
  spec.layout = synth::SynthLayout::continuous;
  spec.hit_times_s = times_s;
  spec.hits = times_s.size();
  spec.seed = seed;
  spec.noise = {.force = 1e-5, .accel = 1e-3};
  return synth::synthesise(spec);
}

Analysis analysis_of(const acquire::Record& record) {
  return {record, {.band_Hz = std::pair{60.0, 1000.0}, .threads = 1}};
}

// Deviations of the residues' real and imaginary parts over their standard deviations.
std::vector<double> deviates_of(const Analysis& analysis, const synth::Truth& truth) {
  std::vector<double> out;
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    for (const identify::Residue& residue : analysis.modes()[m].residues) {
      const double std = std::hypot(residue.std, residue.relative_std * std::abs(residue.value));
      const Complex error = residue.value - truth.residue_per_kg[residue.point][residue.channel][m];
      out.push_back(error.real() / std);
      out.push_back(error.imag() / std);
    }
  }
  return out;
}

// Blows 0.3 s apart: the first mode rings with half of its amplitude when the next blow comes. If the ringing were
// extrapolated with the poles of the first fit, the errors would be 6.9 standard deviations rms. The remaining errors
// are two to three standard deviations, in the frequency of the first mode.
TEST(EarlierRinging, ChangesPolesOfDenseBlowsByFewStandardDeviations) {
  std::vector<double> times_s;
  for (int i = 0; i < 8; ++i) times_s.push_back(0.1 + 0.3 * i);
  double squares = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto test = struck_at(times_s, seed);
    const Analysis analysis = analysis_of(test.record);
    ASSERT_EQ(analysis.modes().size(), 2U) << seed;
    for (const identify::Mode& mode : analysis.modes()) {
      const bool first = mode.pole.freq_Hz < 300;
      squares += std::pow((mode.pole.freq_Hz - (first ? 98 : 530)) / mode.freq_std_Hz, 2);
      squares += std::pow((mode.pole.damping_ratio - (first ? 0.0031 : 0.0017)) / mode.damping_std, 2);
      count += 2;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 3.5);
}

// Blows 0.7 s apart: the first mode still rings with 26 % of its amplitude, hundreds of standard deviations.
TEST(EarlierRinging, ChangesNoResidue) {
  double squares = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto test = struck_at({0.2, 0.9, 1.6}, seed);
    const Analysis analysis = analysis_of(test.record);
    ASSERT_EQ(analysis.modes().size(), 2U);
    const std::vector<double> deviates = deviates_of(analysis, test.truth);
    EXPECT_THAT(deviates, Each(testing::AllOf(testing::Gt(-4.5), testing::Lt(4.5)))) << seed;
    for (const double deviate : deviates) squares += deviate * deviate;
    count += static_cast<double>(deviates.size());
  }
  EXPECT_LT(std::sqrt(squares / count), 1.4);  // 48 deviates: 1 ± 0.1 if the ± are true
}

TEST(EarlierRinging, IsStatedWhereItWasSubtracted) {
  const auto test = struck_at({0.2, 0.9, 1.6}, 1);
  const Analysis analysis = analysis_of(test.record);
  analysis.modes();
  EXPECT_THAT(test::codes_of(analysis.warnings()), Contains("earlier_ringing"));
  EXPECT_THAT(test::codes_of(analysis.warnings()), Not(Contains("not_at_rest")));
}

// A rejected blow also excites the structure.
TEST(EarlierRinging, ComesFromRejectedBlowsToo) {
  const auto test = struck_at({0.2, 0.9, 1.6}, 2);
  const Analysis analysis(test.record, {.band_Hz = std::pair{60.0, 1000.0}, .reject_hits = {0}, .threads = 1});
  ASSERT_EQ(analysis.modes().size(), 2U);
  EXPECT_THAT(deviates_of(analysis, test.truth), Each(testing::AllOf(testing::Gt(-4.5), testing::Lt(4.5))));
}

TEST(EarlierRinging, IsNotFoundAfterALongWait) {
  const auto test = struck_at({0.2, 8}, 3);
  const Analysis analysis = analysis_of(test.record);
  ASSERT_EQ(analysis.modes().size(), 2U);
  EXPECT_THAT(test::codes_of(analysis.warnings()), Not(Contains("earlier_ringing")));
}

TEST(EarlierRinging, IsPossibleWhereAResponseMovesBeforeTheHit) {
  std::vector<AnalysedHit> hits(1);
  hits[0].accepted = true;
  EXPECT_FALSE(may_ring_at_hits(hits));
  hits[0].responses = {{.may_ring_before = true}};
  EXPECT_TRUE(may_ring_at_hits(hits));
}

}  // namespace percuss::pipeline::earlier_ringing_test
