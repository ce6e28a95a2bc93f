#include "identify/select/sequential_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::sequential_fit_test {

struct TestMode {
  Pole pole;
  double residue[2];
};

// Seven modes in the lines from 30 to 744 Hz, and one beyond them. The modes at 253 to 442 Hz are each within four
// half-power bandwidths of the next. With one pole too many, they fill two groups.
std::vector<TestMode> chain_of_modes() {
  return {{{122.01, 0.0138}, {0.677, -0.922}}, {{186.69, 0.0082}, {0.824, 0.748}},
          {{253.04, 0.0264}, {0.250, -0.942}}, {{317.51, 0.0269}, {-0.402, -0.514}},
          {{370.87, 0.0140}, {0.830, 0.650}},  {{441.74, 0.0267}, {-0.249, 0.662}},
          {{586.23, 0.0180}, {0.221, 0.769}},  {{1205.85, 0.0197}, {0.687, -0.862}}};
}

// Two groups must not share the resonance at 317.5 Hz between them: a false mode at 316 Hz in the group below would
// take 3 % of its residue.
TEST(SequentialFit, FitsPolesTogetherThatHaveMovedCloseToEachOther) {
  const std::vector<TestMode> truth = chain_of_modes();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    FrfDataset set = test::empty_set(10240, 10240, 30, 744, 2);
    for (const TestMode& mode : truth) {
      for (std::size_t c = 0; c < 2; ++c) test::add_mode(set, c, mode.pole, mode.residue[c]);
    }
    test::add_frf_noise(set, 0.02, seed);
    const std::vector<FittedMode> found = fit_sequentially(set);
    ASSERT_EQ(found.size(), truth.size() - 1) << seed;
    for (std::size_t m = 0; m < found.size(); ++m)
      EXPECT_LE(std::abs(found[m].mode.pole.freq_Hz - truth[m].pole.freq_Hz), 0.02 * truth[m].pole.half_power_Hz())
          << seed;
  }
}

// The windows of heavily damped modes hold their neighbours. `residues` is of both channels, mode by mode.
FrfDataset neighbours(const std::vector<Pole>& poles, const std::vector<std::vector<double>>& residues,
                      double deviation, std::uint64_t seed) {
  FrfDataset set = test::empty_set(10240, 10240, 60, 1600, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    for (std::size_t m = 0; m < poles.size(); ++m) test::add_mode(set, o, poles[m], residues[o][m]);
  }
  test::add_frf_noise(set, deviation, seed);
  return set;
}

const std::vector<Pole> kWide{{109.04, 0.01476}, {132.08, 0.00593}, {176.97, 0.01018}, {330.99, 0.01406},
                              {500.66, 0.01177}, {678.39, 0.01422}, {961.18, 0.01596}, {1157.58, 0.01849}};
const std::vector<std::vector<double>> kWideResidues{{-0.65, -0.9, -0.9, -0.47, 0.61, -0.43, -0.82, -0.83},
                                                     {0.74, 0.75, -0.82, 0.89, 0.22, -0.42, 0.65, 0.49}};

// Without settling, the mode at 961 Hz is 12 standard deviations off.
TEST(SequentialFit, SettlesFromKnownPoles) {
  for (const Effort effort : {Effort::quick, Effort::standard, Effort::best}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      test::expect_modes_near(modes_from_poles(neighbours(kWide, kWideResidues, 0.03, seed), kWide, effort), kWide);
  }
}

// Without settling, the damping of the mode at 402.5 Hz is 6 standard deviations off after a quick search.
TEST(SequentialFit, SettlesAfterTheSearch) {
  const std::vector<Pole> poles{{125.3, 0.0149}, {145.5, 0.0084}, {223.0, 0.007}, {268.6, 0.0123},
                                {402.5, 0.0164}, {479.7, 0.0173}, {949.8, 0.011}, {1104.6, 0.0096}};
  const std::vector<std::vector<double>> residues{{-0.92, -0.97, -0.42, -0.57, 0.79, -0.33, 0.8, 1.0},
                                                  {0.75, -0.8, -0.38, -0.65, 0.82, -0.91, -0.79, 0.27}};
  for (const Effort effort : {Effort::quick, Effort::standard}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      IdentifyOptions options;
      options.effort = effort;
      test::expect_modes_near(identify_modes(neighbours(poles, residues, 0.013, seed), options), poles);
      test::expect_modes_near(identify_modes(neighbours(kWide, kWideResidues, 0.013, seed), options), kWide);
    }
  }
}

}  // namespace percuss::identify::sequential_fit_test
