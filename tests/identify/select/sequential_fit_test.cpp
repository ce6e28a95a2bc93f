#include "identify/select/sequential_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

}  // namespace percuss::identify::sequential_fit_test
