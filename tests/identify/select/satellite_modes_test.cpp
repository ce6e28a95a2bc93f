#include "identify/select/satellite_modes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "identify/select/sequential_fit.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::satellite_modes_test {

// The satellite has a hundredth of the residues of the mode beside it and lies half a bandwidth from it. Only the
// second dataset contains it.
TEST(SatelliteModes, StayWhereTheFrfsShowThem) {
  const std::vector<Pole> modes{{300, 0.01}, {700, 0.01}, {1100, 0.01}};
  const Pole satellite{.freq_Hz = 707, .damping_ratio = 0.01};
  for (const bool real : {false, true}) {
    FrfDataset set = test::empty_set(8192, 8192, 40, 1600, 2);
    for (std::size_t o = 0; o < 2; ++o) {
      for (const Pole& pole : modes) test::add_mode(set, o, pole, o == 0 ? 0.8 : 0.5);
      if (real) test::add_mode(set, o, satellite, o == 0 ? 0.008 : -0.005);
    }
    test::add_frf_noise(set, 1e-6, 3);
    SequentialFitOptions options = sequential_fit_options(Effort::standard);
    options.start = modes;
    std::vector<FittedMode> found = fit_sequentially(set, options);
    ASSERT_EQ(found.size(), 3U);
    FittedMode tiny = found[1];
    tiny.mode.pole = satellite;
    for (Residue& residue : tiny.mode.residues) residue.value *= 0.01;
    if (real) {  // a local fit that includes the satellite leaves only noise
      for (FittedMode& mode : found) mode.noise.setConstant(1e-6);
    }
    found.insert(found.begin() + 2, tiny);
    const auto residual = refine_without_satellites(set, found);
    EXPECT_EQ(residual.empty(), real);
    EXPECT_EQ(found.size(), real ? 4U : 3U);
  }
}

}  // namespace percuss::identify::satellite_modes_test
