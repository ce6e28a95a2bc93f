#include "identify/started_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::started_modes_test {

struct Part {
  Pole pole;
  double residue = 0;
};

// Residues in the first channel; the second sees each mode less.
FrfDataset set_of(const std::vector<Part>& parts, std::uint64_t seed) {
  FrfDataset set = test::empty_set(5120, 12800, 8, 975, 2);
  for (std::size_t m = 0; m < parts.size(); ++m) {
    test::add_mode(set, 0, parts[m].pole, parts[m].residue);
    test::add_mode(set, 1, parts[m].pole, (m % 2 == 0 ? 0.6 : -0.4) * parts[m].residue);
  }
  test::add_frf_noise(set, 1e-4, seed);
  return set;
}

// A frame whose modes differ much in size: the highest line near a weak mode belongs to its neighbour.
const std::vector<Part> kFrame{{{26.66, 0.01495}, 2e-3},   {{42.27, 0.00521}, 0.05},   {{48.17, 0.0195}, 0.02},
                               {{55.46, 0.0133}, 1e-3},    {{63.67, 0.01705}, 1.5e-3}, {{89.667, 0.01588}, 0.02},
                               {{282.839, 0.01789}, 0.05}, {{286.233, 0.0134}, -8e-3}, {{335.877, 0.01628}, 0.03},
                               {{645.73, 0.01238}, 0.04},  {{913.0, 0.006}, 0.03}};

std::vector<double> rounded(const std::vector<Mode>& modes) {
  std::vector<double> freq_Hz;
  for (const Mode& mode : modes) freq_Hz.push_back(0.1 * std::round(10 * mode.pole.freq_Hz));
  return freq_Hz;
}

std::vector<Mode> without(std::vector<Mode> modes, std::size_t index) {
  modes.erase(modes.begin() + static_cast<std::ptrdiff_t>(index));
  return modes;
}

void expect_equal(const std::vector<Mode>& found, const std::vector<Mode>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t m = 0; m < found.size(); ++m) {
    EXPECT_EQ(found[m].pole, expected[m].pole) << m;
    EXPECT_EQ(found[m].freq_std_Hz, expected[m].freq_std_Hz) << m;
    EXPECT_EQ(found[m].residues[0].value, expected[m].residues[0].value) << m;
  }
}

TEST(StartedModes, AreTheModesOfTheSearchWhereItsOwnListIsStated) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const FrfDataset set = set_of(kFrame, seed);
    const std::vector<Mode> found = identify_modes(set);
    ASSERT_EQ(found.size(), kFrame.size());
    const IdentifyOptions own{.start_Hz = rounded(found)};
    expect_equal(identify_modes(set, own), found);
    EXPECT_TRUE(refused_starts(set, own).empty());
  }
}

// The other modes stay in the fit, and so does the close mode at 282.8 Hz.
TEST(StartedModes, KeepTheirValuesWhereOnlySomeAreStated) {
  const FrfDataset set = set_of(kFrame, 4);
  const std::vector<Mode> found = identify_modes(set);
  ASSERT_EQ(found.size(), kFrame.size());
  expect_equal(identify_modes(set, {.start_Hz = {89.7, 286.2}}), {found[5], found[7]});
}

TEST(StartedModes, DoNotChangeWhereAStartIsRefused) {
  const FrfDataset set = set_of(kFrame, 5);
  const std::vector<Mode> found = identify_modes(set);
  std::vector<double> start_Hz = rounded(found);
  start_Hz.push_back(480);
  const IdentifyOptions options{.start_Hz = start_Hz};
  expect_equal(identify_modes(set, options), found);
  const std::vector<RefusedStart> refused = refused_starts(set, options);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].asked_Hz, 480);
}

// As if the search had not found a mode: it is fitted beside the others, and all of them become right.
TEST(StartedModes, IncludeTheModesThatTheSearchDidNotFind) {
  const FrfDataset set = set_of(kFrame, 6);
  const std::vector<Mode> found = identify_modes(set);
  ASSERT_EQ(found.size(), kFrame.size());
  for (const std::size_t missing : {std::size_t{0}, std::size_t{3}, std::size_t{5}, std::size_t{9}}) {
    const StartedModes started = with_started_modes(set, without(found, missing), rounded(found), Effort::best);
    EXPECT_TRUE(started.refused.empty()) << missing;
    std::vector<Pole> truth;
    for (const Part& part : kFrame) truth.push_back(part.pole);
    test::expect_modes_near(started.modes, truth);
  }
}

// Two modes at most a bandwidth apart, found as one mode. The fit of the stated pair starts at the stated frequencies.
TEST(StartedModes, SeparateAPairThatWasFoundAsOneMode) {
  const std::vector<Part> pair{{{150, 0.01}, 0.4}, {{400, 0.006}, 0.5}, {{402, 0.006}, 0.3}};
  const FrfDataset set = set_of(pair, 7);
  std::vector<Mode> one = modes_from_frequencies(set, {150, 401}, Effort::best);
  ASSERT_EQ(one.size(), 2U);
  const StartedModes started = with_started_modes(set, one, {150, 400, 402}, Effort::best);
  EXPECT_TRUE(started.refused.empty());
  std::vector<Pole> truth;
  for (const Part& part : pair) truth.push_back(part.pole);
  test::expect_modes_near(started.modes, truth);
}

TEST(StartedModes, FitOneModeAtAStartBetweenTwoThatWereFound) {
  const FrfDataset set = set_of({{{150, 0.01}, 0.4}, {{400, 0.006}, 0.5}}, 8);
  std::vector<Mode> found = identify_modes(set);
  ASSERT_EQ(found.size(), 2U);
  Mode half = found[1];
  for (Residue& residue : half.residues) residue.value *= 0.5;
  found[1] = half;
  found[1].pole.freq_Hz -= 0.8;
  half.pole.freq_Hz += 0.8;
  found.push_back(half);
  const StartedModes started = with_started_modes(set, found, {150, 400.1}, Effort::best);
  EXPECT_TRUE(started.refused.empty());
  test::expect_modes_near(started.modes, {{150, 0.01}, {400, 0.006}});
  ASSERT_EQ(started.joined.size(), 1U);
  EXPECT_EQ(started.joined[0].asked_Hz, 400.1);
  EXPECT_EQ(started.joined[0].found_Hz, std::pair(found[1].pole.freq_Hz, found[2].pole.freq_Hz));
  // A single start close to one of the two modes names this mode. Two starts name the two modes.
  EXPECT_TRUE(with_started_modes(set, found, {150, found[1].pole.freq_Hz + 0.1}, Effort::best).joined.empty());
  EXPECT_TRUE(with_started_modes(set, found, {400.1, found[2].pole.freq_Hz}, Effort::best).joined.empty());
}

TEST(ModesAtStarts, AreNamedByTheNearestStartAndOnlyWithinABandwidth) {
  const FrfDataset set = set_of(kFrame, 9);
  std::vector<Mode> modes(3);
  modes[0].pole = {100, 0.01};
  modes[1].pole = {101, 0.01};
  modes[2].pole = {300, 0.01};
  const std::vector<Mode> named = modes_at_starts(set.lines, modes, {101.1, 290, 600});
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0].pole.freq_Hz, 101);
}

}  // namespace percuss::identify::started_modes_test
