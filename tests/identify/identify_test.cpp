#include "identify/identify.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/analysis.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::identify_test {

synth::SynthSpec structure(const std::vector<Pole>& modes, std::uint64_t seed, double noise, double duration_s = 1.28) {
  synth::SynthSpec spec;
  spec.fs_Hz = 12800;
  spec.samples = static_cast<std::size_t>(duration_s * spec.fs_Hz);
  spec.seed = seed;
  for (const Pole& mode : modes) {
    spec.modes.push_back({.freq_Hz = mode.freq_Hz, .damping_ratio = mode.damping_ratio, .residue_per_kg = {0.9, 0.5}});
  }
  spec.noise = {.force = 0.1 * noise, .accel = noise};
  return spec;
}

std::vector<Mode> modes_of(const synth::SynthSpec& spec, double low_Hz = 60, double high_Hz = 3200) {
  const pipeline::Analysis analysis(synth::synthesise(spec).record,
                                    {.band_Hz = std::pair{low_Hz, high_Hz}, .threads = 1});
  return analysis.modes();
}

TEST(IdentifyModes, FindsSeparateModesWithinTheirStandardDeviations) {
  const std::vector<Pole> truth{{180, 0.01}, {600, 0.006}, {1200, 0.004}, {2000, 0.003}};
  for (std::uint64_t seed = 0; seed < 8; ++seed) test::expect_modes_near(modes_of(structure(truth, seed, 1e-3)), truth);
}

TEST(IdentifyModes, FindsBothModesOfAClosePair) {
  const std::vector<Pole> truth{{600, 0.006}, {1900, 0.003}, {1912, 0.0033}};
  for (std::uint64_t seed = 0; seed < 4; ++seed) test::expect_modes_near(modes_of(structure(truth, seed, 1e-3)), truth);
}

TEST(IdentifyModes, SeparatesTwoModesTwoHertzApartAt170Hz) {
  const std::vector<Pole> truth{{170, 0.002}, {172, 0.002}};
  test::expect_modes_near(modes_of(structure(truth, 1, 1e-4, 2.56)), truth);
}

TEST(IdentifyModes, FindsNoSecondModeInASingleOne) {
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    EXPECT_EQ(modes_of(structure({{900, 0.004}}, seed, 1e-2)).size(), 1U) << seed;
}

TEST(IdentifyModes, DoesNotOverestimateDampingFromATruncatedRecord) {
  // A third of the first mode's amplitude is left at the end: the half-power bandwidth would give far too much damping.
  const std::vector<Pole> truth{{200, 0.002}, {800, 0.002}};
  const auto found = modes_of(structure(truth, 2, 1e-3, 0.45));
  test::expect_modes_near(found, truth);
  for (std::size_t m = 0; m < found.size(); ++m)
    EXPECT_LE(std::abs(found[m].pole.damping_ratio / 0.002 - 1), 0.01) << m;
}

TEST(IdentifyModes, IsExactOnNoiseFreeRecordsTruncatedOrNot) {
  constexpr double kRounding = 1e-10;
  for (const double duration_s : {0.45, 2.56}) {
    const auto found = modes_of(structure({{200.3, 0.002}, {800.7, 0.002}}, 0, 0, duration_s));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_LE(std::abs(found[0].pole.freq_Hz / 200.3 - 1), kRounding);  // between two lines
    EXPECT_LE(std::abs(found[1].pole.freq_Hz / 800.7 - 1), kRounding);
  }
}

TEST(IdentifyModes, DoesNotDependOnTheStartOfTheBand) {
  const synth::SynthSpec spec = structure({{100, 0.01}}, 5, 1e-3);
  const auto a = modes_of(spec, 60, 1000);
  const auto b = modes_of(spec, 90, 1000);
  ASSERT_EQ(a.size(), 1U);
  ASSERT_EQ(b.size(), 1U);
  EXPECT_LE(std::abs(a[0].pole.freq_Hz - b[0].pole.freq_Hz), a[0].freq_std_Hz);
  EXPECT_LE(std::abs(a[0].pole.damping_ratio - b[0].pole.damping_ratio), a[0].damping_std);
}

TEST(IdentifyModes, KeepsTheRequestedNumberOfModes) {
  const acquire::Record record =
      synth::synthesise(structure({{180, 0.01}, {600, 0.006}, {1200, 0.004}}, 0, 1e-3)).record;
  const pipeline::Analysis two(record, {.band_Hz = std::pair{60.0, 3200.0}, .modes = {.modes = 2}});
  EXPECT_EQ(two.modes().size(), 2U);
  const pipeline::Analysis started(record, {.band_Hz = std::pair{60.0, 3200.0}, .modes = {.start_Hz = {601}}});
  ASSERT_EQ(started.modes().size(), 1U);
  EXPECT_LE(std::abs(started.modes()[0].pole.freq_Hz - 600), 0.01);
}

TEST(IdentifyModes, ReportsTheResidues) {
  const std::vector<Mode> found = modes_of(structure({{180, 0.01}, {600, 0.006}}, 4, 1e-3));
  ASSERT_EQ(found.size(), 2U);
  for (const Mode& mode : found) {
    ASSERT_EQ(mode.residues.size(), 2U);
    for (std::size_t c = 0; c < 2; ++c) {
      const Residue& residue = mode.residues[c];
      const double exact = c == 0 ? 0.9 : 0.5;
      EXPECT_LE(std::abs(residue.value - exact),
                test::kModeDeviations * std::hypot(residue.std, exact * residue.relative_std));
    }
  }
}

std::vector<Mode> modes_by(Effort effort, const synth::SynthSpec& spec) {
  const pipeline::Analysis analysis(synth::synthesise(spec).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .modes = {.effort = effort}, .threads = 1});
  return analysis.modes();
}

TEST(IdentifyModes, EveryEffortSeparatesAClosePair) {
  const synth::SynthSpec spec = structure({{600, 0.006}, {1900, 0.003}, {1903, 0.003}}, 2, 1e-3);
  EXPECT_EQ(modes_by(Effort::quick, spec).size(), 3U);
  EXPECT_EQ(modes_by(Effort::standard, spec).size(), 3U);
  EXPECT_EQ(modes_by(Effort::best, spec).size(), 3U);
}

TEST(IdentifyModes, BestEffortReducesTheStandardDeviationOfTheFrequency) {
  // The force is known and the residues are real. A free phase would raise the frequency's standard deviation by a
  // factor of √2 to 2.
  synth::SynthSpec spec = structure({{180, 0.01}, {600, 0.006}}, 3, 1e-2);
  spec.noise.force = 0;
  const auto standard = modes_by(Effort::standard, spec);
  const auto best = modes_by(Effort::best, spec);
  ASSERT_EQ(standard.size(), best.size());
  for (std::size_t m = 0; m < best.size(); ++m) {
    EXPECT_LE(1.3 * best[m].freq_std_Hz, standard[m].freq_std_Hz);
    for (const Residue& residue : best[m].residues) EXPECT_EQ(residue.value.imag(), 0);
  }
}

TEST(IdentifyModes, BestEffortKeepsTheLocalFitWhereTheModelFails) {
  // The model cannot describe a mode whose frequency changes during the decay: its joint fit must be rejected.
  const FrfDataset set = test::frfs_of_changing_mode();
  const auto standard = identify_modes(set, {.effort = Effort::standard, .start_Hz = {320, 502}});
  const auto best = identify_modes(set, {.effort = Effort::best, .start_Hz = {320, 502}});
  ASSERT_EQ(best.size(), 2U);
  EXPECT_EQ(best[1].pole.freq_Hz, standard[1].pole.freq_Hz);
  EXPECT_LE(std::abs(best[0].pole.freq_Hz - 320), test::kModeDeviations * best[0].freq_std_Hz);
}

}  // namespace percuss::identify::identify_test
