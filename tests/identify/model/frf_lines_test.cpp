#include "identify/model/frf_lines.hpp"

#include <gtest/gtest.h>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::frf_lines_test {

// The record is truncated, so the mode's column of the least-squares matrix depends on the force at each line.
TEST(LinesOf, GiveTheSameModeAsAllLines) {
  const synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 169, .damping_ratio = 0.002, .residue_per_kg = {1.1, -0.4}}}, 0.5);
  const FrfDataset set = test::frf_set_of(synth::synthesise(spec).record, 60, 800);
  const std::size_t first = set.lines.nearest(120), count = set.lines.nearest(230) - first;
  const FrfDataset part = lines_of(set, first, count);
  EXPECT_EQ(part.lines.freq_Hz(0), set.lines.freq_Hz(first));
  EXPECT_EQ(part.lines.count, count);
  EXPECT_EQ(part.channels[1].frf.back(), set.channels[1].frf[first + count - 1]);
  const auto modes = identify_modes(part);
  ASSERT_EQ(modes.size(), 1U);
  constexpr double kFit = 1e-8;  // without noise, only the truncation of the decay changes the FRFs, and it is modelled
  EXPECT_NEAR(modes[0].pole.freq_Hz, 169, 10 * kFit);
  EXPECT_NEAR(modes[0].pole.damping_ratio, 0.002, kFit);
}

}  // namespace percuss::identify::frf_lines_test
