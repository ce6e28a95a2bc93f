#include "identify/model/modal_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::modal_model_test {

using test::largest;
using test::vector_of;

TEST(ModeColumn, IsTheClosedFormOfAModeThatHasDecayed) {
  constexpr double kTolerance = 1e-12;  // rounding of a resonance of height 50; the mode decays to e^−301
  const FrfDataset set = test::empty_set(4096, 65536, 100, 600, 1);
  const Pole pole{.freq_Hz = 300, .damping_ratio = 0.01};
  ASSERT_TRUE(decays_within_record(pole, set.points[0], set.lines));
  const ModeColumn column = mode_column(pole, set.points[0], set.lines, 0, set.lines.count);
  double error = 0;
  for (std::size_t k = 0; k < set.lines.count; ++k) {
    const Complex h = test::mode_accelerance(pole, {0, kTwoPi * set.lines.freq_Hz(k)});
    error = std::max(error, std::abs(column.value(static_cast<Eigen::Index>(k)) - h));
  }
  EXPECT_LE(error, kTolerance * largest(column.value));
}

// Compares the modes' columns plus the mass line with the H1 of the record.
double error_of_the_sum(double decay_per_s) {
  const synth::SyntheticTest made = synth::synthesise(test::truncated_bat_spec());
  const FrfDataset set = test::frf_set_of(made.record, 40, 2000, decay_per_s);
  double worst = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    Eigen::VectorXcd h = vector_of(set.channels[c].frf);
    const double size = largest(h);
    h.array() -= made.truth.rigid_per_kg[0][c];
    for (std::size_t m = 0; m < made.truth.spec.modes.size(); ++m) {
      const synth::SynthMode& mode = made.truth.spec.modes[m];
      h -= made.truth.residue_per_kg[0][c][m] *
           mode_column({mode.freq_Hz, mode.damping_ratio}, set.points[0], set.lines, 0, set.lines.count).value;
    }
    worst = std::max(worst, largest(h) / size);
  }
  return worst;
}

TEST(ModeColumn, TimesResiduePlusMassLineIsTheH1OfATruncatedRecord) {
  constexpr double kTolerance = 1e-9;  // the force's own filter ringing at the row's ends, aliases and rounding
  EXPECT_LE(error_of_the_sum(0), kTolerance);
}

TEST(ModeColumn, HoldsUnderAnExponentialWindow) {
  constexpr double kTolerance = 1e-9;  // as without a window
  EXPECT_LE(error_of_the_sum(6), kTolerance);
}

TEST(ModeColumn, DiffersFromTheClosedFormWhereTheRecordIsTruncated) {
  // The closed form lacks the sum in (3.3) of docs/theory/theory.md and is wrong by at least 5 %. The test of the
  // truncated record above would therefore fail without this sum.
  const synth::SyntheticTest made = synth::synthesise(test::truncated_bat_spec());
  const FrfDataset set = test::frf_set_of(made.record, 40, 2000);
  const Pole pole{.freq_Hz = 120, .damping_ratio = 0.004};
  const ModeColumn column = mode_column(pole, set.points[0], set.lines, 0, set.lines.count);
  EXPECT_FALSE(decays_within_record(pole, set.points[0], set.lines));
  const auto line = static_cast<Eigen::Index>(120 / set.lines.df_Hz()) - static_cast<Eigen::Index>(set.lines.first);
  const Complex h = test::mode_accelerance(pole, {0, kTwoPi * set.lines.freq_Hz(static_cast<std::size_t>(line))});
  EXPECT_GE(std::abs(column.value(line) - h), 0.05 * std::abs(h));
}

struct Setting {
  double duration_s, decay_per_s;
};
class ModeColumnSlope : public testing::TestWithParam<Setting> {};

TEST_P(ModeColumnSlope, AgreesWithCentralDifferences) {
  constexpr double kStep = 1e-5;       // of the parameter's scale: truncation 1e-10, rounding 1e-11
  constexpr double kTolerance = 1e-7;  // of the largest: both, amplified by up to 100 near the resonance
  synth::SynthSpec spec = test::truncated_bat_spec();
  spec.samples = static_cast<std::size_t>(GetParam().duration_s * spec.fs_Hz);
  const FrfDataset set = test::frf_set_of(synth::synthesise(spec).record, 40, 2000, GetParam().decay_per_s);
  for (const Pole& pole : {Pole{120.3, 0.004}, Pole{640.1, 0.03}}) {
    const auto at = [&](double freq_Hz, double damping) {
      return mode_column({freq_Hz, damping}, set.points[0], set.lines, 0, set.lines.count).value;
    };
    const ModeColumn column = mode_column(pole, set.points[0], set.lines, 0, set.lines.count);
    const double df = kStep * pole.half_power_Hz(), dz = kStep * pole.damping_ratio;
    const Eigen::VectorXcd by_freq =
        (at(pole.freq_Hz + df, pole.damping_ratio) - at(pole.freq_Hz - df, pole.damping_ratio)) / (2 * df);
    const Eigen::VectorXcd by_damping =
        (at(pole.freq_Hz, pole.damping_ratio + dz) - at(pole.freq_Hz, pole.damping_ratio - dz)) / (2 * dz);
    EXPECT_LE(largest(by_freq - column.by_freq), kTolerance * largest(by_freq)) << pole.freq_Hz;
    EXPECT_LE(largest(by_damping - column.by_damping), kTolerance * largest(by_damping)) << pole.freq_Hz;
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutTruncationAndWindow, ModeColumnSlope,
                         testing::Values(Setting{0.35, 0}, Setting{0.35, 8}, Setting{8, 0}, Setting{2, 3}));

TEST(ModeColumn, DoesNotDependOnTheForcesUnitOrTheOrderOfHits) {
  constexpr double kTolerance = 1e-13;  // order of summation
  const synth::SyntheticTest made = synth::synthesise(test::truncated_bat_spec());
  const FrfDataset set = test::frf_set_of(made.record, 40, 2000);
  std::vector<frf::ForceBlock> blocks(set.points[0].blocks.rbegin(), set.points[0].blocks.rend());
  std::vector<frf::Spectrum> spectra;
  for (frf::ForceBlock& block : blocks) {
    for (double& f : block.force_N) f *= -1e3;
    spectra.push_back(test::make_spectrum(frf::force_spectrum(block, set.lines)));
  }
  const PointForce other = point_force(blocks, spectra, set.lines, 0);
  const Pole pole{.freq_Hz = 120, .damping_ratio = 0.004};
  const auto a = mode_column(pole, set.points[0], set.lines, 0, set.lines.count).value;
  const auto b = mode_column(pole, other, set.lines, 0, set.lines.count).value;
  EXPECT_LE(largest(a - b), kTolerance * largest(a));
}

TEST(ModeColumn, OfAWindowIsPartOfTheFullColumn) {
  const FrfDataset set = test::frf_set_of(synth::synthesise(test::truncated_bat_spec()).record, 40, 2000);
  const Pole pole{.freq_Hz = 640, .damping_ratio = 0.004};
  constexpr double kTolerance = 1e-12;  // the phase is stepped from line to line
  const auto all = mode_column(pole, set.points[0], set.lines, 0, set.lines.count);
  const auto part = mode_column(pole, set.points[0], set.lines, 150, 80);
  EXPECT_LE(largest(all.value.segment(150, 80) - part.value), kTolerance * largest(all.value));
}

constexpr acquire::LineRange kTwoLines{.fs_Hz = 8, .samples = 8, .first = 1, .count = 2};

TEST(PointForce, WeightsEachHitByItsEnergy) {
  const std::vector<Complex> a{{3, 4}, {0, 1}}, b{{0, 5}, {2, 0}};
  const PointForce force = point_force({{}, {}}, {test::make_spectrum(a), test::make_spectrum(b)}, kTwoLines, 0.5);
  EXPECT_DOUBLE_EQ(force.ff[0], 50);
  EXPECT_DOUBLE_EQ(force.ff[1], 5);
  EXPECT_EQ(force.noise_N, 0.5);
  // A response equal to the force has H1 = 1.
  for (const Complex& line : h1_at(force, std::array<std::span<const Complex>, 2>{a, b}))
    EXPECT_NEAR(std::abs(line - 1.0), 0, 1e-15);
}

TEST(PointForce, RejectsALineWithoutForceEnergy) {
  const std::vector<Complex> force{{3, 4}, {0, 0}};
  try {
    point_force({{}}, {test::make_spectrum(force)}, kTwoLines, 0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no energy at 2 Hz"));
  }
}

}  // namespace percuss::identify::modal_model_test
