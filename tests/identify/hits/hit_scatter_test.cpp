#include "identify/hits/hit_scatter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/modal_frfs.hpp"
#include "support/single_hits.hpp"

namespace percuss::identify::hit_scatter_test {

using test::SingleHits;

constexpr double kNoise = 1e-4;  // the peaks are 100 times a residue of 1
constexpr Pole kWeak{.freq_Hz = 300, .damping_ratio = 0.005}, kStrong{.freq_Hz = 340, .damping_ratio = 0.005};

// Blows in other directions change the strong mode by up to 30 %, but not the weak one. A fit of each hit with the mean
// residue of the strong mode would be wrong at its flank, and this would move the weak mode.
TEST(HitPoles, DoNotDependOnTheResiduesOfOtherModesInTheOtherHits) {
  const SingleHits hits(1, 5, kNoise, [](FrfDataset& one, std::size_t, std::size_t hit) {
    test::add_mode(one, 0, kWeak, 1);
    test::add_mode(one, 0, kStrong, 50 * (0.7 + 0.15 * static_cast<double>(hit)));
  });
  const std::vector<Mode> modes = hits.modes({kWeak, kStrong});
  const WindowedHitPoles poles = windowed_hit_poles(hits.set, hits.frfs, modes);
  ASSERT_FALSE(poles.modes_in_hits.empty());
  for (const HitPole& hit : poles.poles[0].hits) {
    ASSERT_TRUE(hit.known);
    EXPECT_NEAR(hit.pole.freq_Hz, kWeak.freq_Hz, 5 * hit.freq_std_Hz);
    EXPECT_NEAR(hit.pole.damping_ratio, kWeak.damping_ratio, 5 * hit.damping_std);
  }
}

// A mode that no fit knows moves the poles of the hits, by another amount at each point.
TEST(HitScatter, ComparesTheHitsOfASurveyWithinTheirPoints) {
  const SingleHits hits(6, 3, kNoise, [](FrfDataset& one, std::size_t point, std::size_t) {
    test::add_mode(one, 0, kWeak, 1);
    test::add_mode(one, 0, {.freq_Hz = 312, .damping_ratio = 0.02}, 0.3 * std::cos(2.0 * static_cast<double>(point)));
  });
  std::vector<Mode> modes = hits.modes({kWeak});
  const std::vector<double> peak_N = {90,  130, 110, 100, 95,  120, 140, 105, 98,
                                      115, 102, 125, 99,  108, 135, 111, 96,  128};
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), peak_N, modes);
  EXPECT_EQ(modes[0].pole, kWeak);
  EXPECT_EQ(modes[0].freq_std_parts_Hz.hits, 0);
}

// The same modes with one hit per point. The misfit cannot be told from differences between hits, so the misfit's part
// of the ± contains both.
TEST(HitScatter, DoesNotTakeMisfitForHitsThatDifferWhereEachPointHasOneHit) {
  const SingleHits hits(12, 1, kNoise, [](FrfDataset& one, std::size_t point, std::size_t) {
    test::add_mode(one, 0, kWeak, 1);
    test::add_mode(one, 0, {.freq_Hz = 312, .damping_ratio = 0.02}, 0.3 * std::cos(2.0 * static_cast<double>(point)));
  });
  std::vector<Mode> modes = hits.modes({kWeak});
  const std::vector<double> peak_N = {90, 130, 110, 100, 95, 120, 140, 105, 98, 115, 102, 125};
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), peak_N, modes);
  EXPECT_EQ(modes[0].pole, kWeak);
  EXPECT_EQ(modes[0].freq_std_parts_Hz.hits, 0);
  EXPECT_EQ(modes[0].damping_std_parts.hits, 0);
}

// A drift from hit to hit is found without repeated hits of a point.
TEST(HitScatter, FindsADriftWhereEachPointHasOneHit) {
  const SingleHits hits(12, 1, kNoise, [](FrfDataset& one, std::size_t point, std::size_t) {
    const double change = 1e-4 * static_cast<double>(point);
    test::add_mode(one, 0, {.freq_Hz = kWeak.freq_Hz * (1 + change), .damping_ratio = kWeak.damping_ratio}, 1);
  });
  std::vector<Mode> modes = hits.modes({kWeak});
  const std::vector<double> peak_N(12, 100);
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), peak_N, modes);
  EXPECT_GT(modes[0].freq_std_parts_Hz.hits, 0);
  ASSERT_TRUE(modes[0].drift.has_value());
  EXPECT_NEAR(modes[0].drift->freq_change_per_hit, 1e-4, 1e-5);
}

// Ratios of residues that differ from point to point, but not between the hits of a point, are misfit.
TEST(ResidueRatios, ScatterWithinThePoints) {
  const auto ratios = [](const std::vector<double>& values) {
    std::vector<ResidueRatio> out;
    for (const double value : values) out.push_back({.sum = 1e6 * value, .weight = 1e6});
    return out;
  };
  const std::vector<ResidueRatio> of_points = ratios({1.1, 1.1, 1.1, 0.9, 0.9, 0.9});
  EXPECT_TRUE(scatter_clearly(of_points));
  EXPECT_FALSE(scatter_clearly(of_points, {0, 0, 0, 1, 1, 1}));
  EXPECT_TRUE(scatter_clearly(of_points, {0, 1, 1, 1, 0, 0}));
  EXPECT_FALSE(scatter_clearly(of_points, {0, 1, 2, 3, 4, 5})) << "one hit per point";
}

TEST(HitScatter, FindsHitsOfOnePointThatDiffer) {
  const SingleHits hits(6, 3, kNoise, [](FrfDataset& one, std::size_t point, std::size_t hit) {
    const double off = static_cast<double>((point + 2 * hit) % 3) - 1;
    test::add_mode(one, 0, {.freq_Hz = kWeak.freq_Hz * (1 + 1e-4 * off), .damping_ratio = kWeak.damping_ratio}, 1);
  });
  std::vector<Mode> modes = hits.modes({kWeak});
  const std::vector<double> peak_N(18, 100);
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), peak_N, modes);
  EXPECT_GT(modes[0].freq_std_parts_Hz.hits, 0);
}

// The poles of single points differ by the misfit, from each other and from the fit of all points together. The hits of
// each point lie evenly about their average.
TEST(HitScatter, DoesNotMoveAPoleByTheMisfitOfThePoints) {
  const SingleHits hits(6, 3, kNoise, [](FrfDataset& one, std::size_t point, std::size_t hit) {
    const double off = static_cast<double>((point + 2 * hit) % 3) - 1, at = static_cast<double>(point);
    test::add_mode(one, 0, {.freq_Hz = kWeak.freq_Hz * (1 + 1e-4 * off), .damping_ratio = kWeak.damping_ratio},
                   1 + 0.5 * std::cos(at));
    test::add_mode(one, 0, {.freq_Hz = 306, .damping_ratio = 0.02}, 0.5 * (1 + std::cos(2 * at)));
  });
  std::vector<Mode> modes = hits.modes({kWeak});
  const std::vector<double> peak_N(18, 100);
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), peak_N, modes);
  EXPECT_GT(modes[0].freq_std_parts_Hz.hits, 0);
  EXPECT_NEAR(modes[0].pole.freq_Hz, kWeak.freq_Hz, 2e-5 * kWeak.freq_Hz) << "the misfit moves single points by 1e-3";
}

// All modes of a hit shift together, as at another temperature. One mode is too weak to show it. Another stays as it
// is.
TEST(HitScatter, GivesAWeakModeTheScatterThatTheOthersShare) {
  constexpr std::array kOff{1.2e-5, -0.4e-5, -1.5e-5, 0.9e-5, -0.2e-5};  // standard deviation 1.1e-5
  constexpr std::array kFreq_Hz{220.0, 270.0, 320.0, 370.0, 430.0};
  constexpr std::size_t kWeakest = 2, kSteady = 3;
  const SingleHits hits(1, kOff.size(), kNoise, [&](FrfDataset& one, std::size_t, std::size_t hit) {
    for (std::size_t m = 0; m < kFreq_Hz.size(); ++m) {
      const double factor = 1 + (m == kSteady ? 0 : kOff.at(hit));
      test::add_mode(one, 0, {.freq_Hz = kFreq_Hz.at(m) * factor, .damping_ratio = 0.005}, m == kWeakest ? 3e-4 : 1);
    }
  });
  std::vector<Pole> poles;
  for (const double freq_Hz : kFreq_Hz) poles.push_back({.freq_Hz = freq_Hz, .damping_ratio = 0.005});
  std::vector<Mode> modes = hits.modes(poles);
  add_hit_scatter(hits.set, hits.frfs, windowed_hit_poles(hits.set, hits.frfs, modes), {99, 103, 101, 98, 100}, modes);
  ASSERT_LT(modes[0].hit_scatter_freq_p, 1);
  const double shared = modes[0].freq_std_parts_Hz.hits / kFreq_Hz[0];
  EXPECT_GT(shared, 0.4e-5);
  EXPECT_EQ(modes[kWeakest].hit_scatter_freq_p, 1) << "not significant";
  EXPECT_NEAR(modes[kWeakest].freq_std_parts_Hz.hits, shared * kFreq_Hz[kWeakest], 0.5 * shared * kFreq_Hz[kWeakest]);
  EXPECT_EQ(modes[kWeakest].freq_std_Hz, modes[kWeakest].freq_std_parts_Hz.total());
  EXPECT_EQ(modes[kSteady].freq_std_parts_Hz.hits, 0) << "its hits show that it does not scatter";
}

}  // namespace percuss::identify::hit_scatter_test
