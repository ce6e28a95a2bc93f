#include "pipeline/warnings/mode_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace percuss::pipeline::mode_warnings_test {

using testing::HasSubstr;
using testing::Not;

std::vector<identify::Mode> misfitting_modes(std::size_t count) {
  std::vector<identify::Mode> modes(count);
  for (std::size_t m = 0; m < count; ++m) {
    modes[m].pole = {.freq_Hz = 100.0 + 10 * static_cast<double>(m), .damping_ratio = 0.01};
    modes[m].joint_misfit = 20;
    modes[m].joint_residual = 0.1;
  }
  return modes;
}

TEST(JoinedModeWarnings, NameTheStartAndBothModes) {
  EXPECT_TRUE(joined_mode_warnings({}).empty());
  const std::vector<Warning> warnings = joined_mode_warnings({{.asked_Hz = 603, .found_Hz = {600.0007, 604.0023}}});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "start_between");
  EXPECT_THAT(warnings[0].message, HasSubstr("603 Hz lies between two modes of the search, 600.001 and 604.002 Hz"));
}

TEST(LocalFitWarnings, CountTheModesBeyondTheirLimit) {
  EXPECT_THAT(local_fit_warnings(misfitting_modes(8)).at(0).message, Not(HasSubstr(" more.")));
  std::vector<identify::Mode> modes = misfitting_modes(12);
  modes[3].joint_misfit = std::numeric_limits<double>::infinity();  // the fit did not converge: not in the list
  EXPECT_THAT(local_fit_warnings(modes).at(0).message, HasSubstr("180.0 Hz (20 times) and 3 more."));
}

// The record need not hold anything unusual: a weak, heavily damped mode can keep the fit from converging.
TEST(LocalFitWarnings, BlameNothingWhereTheJointFitDidNotConverge) {
  std::vector<identify::Mode> modes = misfitting_modes(3);
  for (identify::Mode& mode : modes) mode.joint_misfit = std::numeric_limits<double>::infinity();
  const std::string message = local_fit_warnings(modes).at(0).message;
  EXPECT_THAT(message, HasSubstr("did not converge. Each of them is fitted over the lines around it"));
  EXPECT_THAT(message, HasSubstr("valid within their ±"));
  EXPECT_THAT(message, Not(HasSubstr("missing")));
  EXPECT_THAT(local_fit_warnings(misfitting_modes(3)).at(0).message, HasSubstr("Possible causes: a mode that is"));
}

TEST(LocalFitWarnings, NameTheNoiseOfAnUnknownForce) {
  EXPECT_THAT(local_fit_warnings(misfitting_modes(3), false).at(0).message,
              HasSubstr("Possible causes: the noise of the force, if it had no force window, a mode that is"));
}

// A peak that the removal of a tone left is no mode.
TEST(UnmodelledPeakWarnings, NameTheTonesAmongThePeaks) {
  constexpr std::pair<double, double> kBand_Hz{60, 1300};
  constexpr double kSpacing_Hz = 1;
  const std::vector<Tone> tones{{.freq_Hz = 49.98}, {.freq_Hz = 641, .wanders = true}};
  const auto none = unmodelled_peak_warnings({{100, -40}, {252, -30}}, kBand_Hz, {}, kSpacing_Hz);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_THAT(none[0].message, HasSubstr("100 Hz (-40 dB), 252 Hz (-30 dB)"));
  EXPECT_EQ(none[0].options, std::vector<OptionId>{"start"});
  const auto both = unmodelled_peak_warnings({{100, -40}, {252.5, -30}, {645, -20}}, kBand_Hz, tones, kSpacing_Hz);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_THAT(both[0].message, HasSubstr("no mode models these peaks: 252.5 Hz (-30 dB)."));
  EXPECT_THAT(both[1].message, HasSubstr("at the frequencies of tones: 100 Hz (-40 dB), 645 Hz (-20 dB)."));
  EXPECT_THAT(both[1].message, Not(HasSubstr("starting frequency")));
  EXPECT_TRUE(both[1].options.empty());
  EXPECT_EQ(unmodelled_peak_warnings({{100, -40}}, kBand_Hz, tones, kSpacing_Hz).size(), 1U);
  EXPECT_TRUE(unmodelled_peak_warnings({{1400, -40}}, kBand_Hz, tones, kSpacing_Hz).empty());
}

TEST(LocalFitWarnings, CountTheModesThatTheJointFitDescribesFarWorse) {
  std::vector<identify::Mode> modes = misfitting_modes(3);
  modes[1].joint_misfit = 2;  // keeps its local fit, too
  EXPECT_THAT(local_fit_warnings(modes).at(0).message,
              HasSubstr("around 2 of 3 modes, all modes together leave at least ten times the residual energy"));
}

// Two modes at ten points of three hits each, in the order of the points. At each point, the frequency of a mode
// changes by the fraction change(h), with h the mean number of the point's hits.
struct ScatteringTest {
  std::vector<identify::Mode> modes;
  std::vector<AnalysedHit> hits;
};

ScatteringTest scattering_test(const std::function<double(double hit)>& change) {
  constexpr int kPoints = 10, kHits = 3;
  ScatteringTest out{.modes = std::vector<identify::Mode>(2), .hits = {}};
  for (int p = 0; p < kPoints; ++p)
    out.hits.insert(out.hits.end(), kHits, {.hit = {.peak_N = 100}, .point = p, .accepted = true});
  for (std::size_t m = 0; m < 2; ++m) {
    identify::Mode& mode = out.modes[m];
    mode.pole = {.freq_Hz = 100.0 * static_cast<double>(m + 1), .damping_ratio = 0.01};
    mode.freq_scatter_Hz = 1e-4 * mode.pole.freq_Hz;
    for (int p = 0; p < kPoints; ++p) {
      identify::Residue& residue = mode.residues.emplace_back();
      residue.point = static_cast<std::size_t>(p);
      residue.value = p == 4 ? 1e-3 : 1;  // near a node
      residue.own_pole = mode.pole;
      residue.own_pole->freq_Hz *= 1 + (p == 4 ? 5e-4 : change(kHits * p + 1));
    }
  }
  return out;
}

// Only the first mode has a clear drift of its own.
std::vector<Warning> warnings_of(ScatteringTest test, std::optional<double> drift) {
  if (drift) test.modes[0].drift = identify::DriftTrend{.freq_change_per_hit = *drift, .std = 0.01 * *drift};
  return freq_scatter_warnings(test.modes, order_of_points(test.hits));
}

TEST(FreqScatterWarnings, LeaveTheCauseToADriftThatExplainsTheScatter) {
  constexpr double kDrift = 1e-5;
  const ScatteringTest drifting = scattering_test([](double hit) { return kDrift * (hit - 14.5); });
  EXPECT_TRUE(warnings_of(drifting, kDrift).empty());
  EXPECT_TRUE(warnings_of(drifting, 1.05 * kDrift).empty());
  EXPECT_THAT(warnings_of(drifting, std::nullopt).at(0).message, HasSubstr("100.0 Hz (by 0.01 Hz), 200.0 Hz"));
  EXPECT_FALSE(warnings_of(drifting, -kDrift).empty());
  EXPECT_FALSE(freq_scatter_warnings(drifting.modes).empty());  // hits that are not known
}

TEST(FreqScatterWarnings, NameTheNoiseOfAnUnknownForce) {
  const ScatteringTest test = scattering_test([](double hit) { return std::fmod(hit, 2) < 1 ? 1e-4 : -1e-4; });
  EXPECT_THAT(freq_scatter_warnings(test.modes, {}, false).at(0).message,
              HasSubstr("Possible causes: the noise of the force, if it had no force window, temperature"));
  EXPECT_THAT(freq_scatter_warnings(test.modes).at(0).message, HasSubstr("Possible causes: temperature"));
}

// A line explains three quarters of the variance of a step.
TEST(FreqScatterWarnings, NameASensorThatWasMovedBesideADrift) {
  const ScatteringTest moved = scattering_test([](double hit) { return hit < 15 ? -1e-4 : 1e-4; });
  EXPECT_THAT(warnings_of(moved, 1e-5).at(0).message,
              testing::AllOf(HasSubstr("200.0 Hz (by 0.02 Hz). The drift from hit to hit does not explain this"),
                             HasSubstr("a sensor that was moved")));
}

TEST(FreqScatterWarnings, NumberTheUsedHitsInTheirOrder) {
  std::vector<AnalysedHit> hits(5);
  for (std::size_t h = 0; h < hits.size(); ++h) hits[h] = {.point = h < 3 ? 7 : 2, .accepted = h != 1};
  EXPECT_THAT(order_of_points(hits), testing::ElementsAre(std::pair(2, 2.5), std::pair(7, 0.5)));
}

TEST(NoModesWarnings, SayThatTheBandOrTheStartsHoldNoMode) {
  EXPECT_TRUE(no_modes_warnings(misfitting_modes(1), {60, 3200}, false).empty());
  const Warning in_band = no_modes_warnings({}, {60, 3200}, false).at(0);
  EXPECT_EQ(in_band.code, "no_modes");
  EXPECT_THAT(in_band.message, HasSubstr("from 60 to 3200 Hz"));
  EXPECT_THAT(no_modes_warnings({}, {60, 3200}, true).at(0).message, HasSubstr("at the starting frequencies"));
}

TEST(UnmodelledPoleWarnings, CountThePolesBeyondTheirLimit) {
  std::vector<identify::Pole> poles;
  poles.reserve(12);
  for (int p = 0; p < 12; ++p) poles.push_back({.freq_Hz = 100.0 + 10 * p, .damping_ratio = 0.01});
  const std::pair band_Hz{105.0, 1000.0};
  EXPECT_THAT(unmodelled_pole_warnings(poles, band_Hz).at(0).message, HasSubstr("180 Hz (1 %) and 3 more."));
  poles.resize(9);
  EXPECT_THAT(unmodelled_pole_warnings(poles, band_Hz).at(0).message, Not(HasSubstr(" more.")));
  EXPECT_TRUE(unmodelled_pole_warnings(poles, {200.0, 300.0}).empty());
}

// Modes 50 Hz apart with half-power bandwidths of 40 Hz. Two of the frequencies are known only to 25 Hz.
TEST(CrowdWarnings, NameTheOverlapAndTheModesThatAreHardlyKnown) {
  std::vector<identify::Mode> modes(16);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const double freq_Hz = 200.0 + 50 * static_cast<double>(m);
    modes[m].pole = {.freq_Hz = freq_Hz, .damping_ratio = 20 / freq_Hz};
    modes[m].freq_std_Hz = m == 2 || m == 5 ? 25 : 0.1;
  }
  const std::pair band_Hz{100.0, 1100.0};
  const Warning warning = crowd_warnings(modes, band_Hz).at(0);
  EXPECT_EQ(warning.code, "crowded");
  EXPECT_THAT(warning.message, HasSubstr("16 modes overlap: together their half-power bandwidths are 0.64 times"));
  EXPECT_THAT(warning.message, HasSubstr("hardly better than their bandwidth: 300 Hz, 450 Hz;"));
  for (identify::Mode& mode : modes) mode.residues.resize(3);  // shapes separate close modes
  EXPECT_TRUE(crowd_warnings(modes, band_Hz).empty());
  for (identify::Mode& mode : modes) mode.residues.resize(2);
  modes.resize(14);
  EXPECT_TRUE(crowd_warnings(modes, band_Hz).empty());
}

}  // namespace percuss::pipeline::mode_warnings_test
