#include "identify/hits/hit_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "identify/fit/joint_fit.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::hit_scatter_test {

constexpr double kNoise = 1e-4;  // the peaks are 100 times a residue of 1
constexpr Pole kWeak{.freq_Hz = 300, .damping_ratio = 0.005}, kStrong{.freq_Hz = 340, .damping_ratio = 0.005};

FrfDataset lines_of_channels(std::size_t channels) { return test::empty_set(4096, 8192, 200, 450, channels); }

// The hits of a test, one channel each, and their average at each point. `add` adds the modes of a hit.
struct Hits {
  FrfDataset set;
  HitFrfs frfs;
  std::vector<std::vector<Complex>> spectra;

  Hits(std::size_t points, std::size_t hits_per_point,
       const std::function<void(FrfDataset& one, std::size_t point, std::size_t hit)>& add)
      : set(lines_of_channels(points)) {
    const FrfDataset single = lines_of_channels(1);
    set.points.assign(points, single.points.front());
    frfs.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
    for (std::size_t p = 0; p < points; ++p) {
      set.channels[p].point = p;
      set.channels[p].channel = 0;
      for (std::size_t h = 0; h < hits_per_point; ++h) {
        FrfDataset one = single;
        add(one, p, h);
        test::add_frf_noise(one, kNoise, 1 + p * hits_per_point + h);
        const Complex* const force = one.points.front().spectra.front().get();
        for (std::size_t k = 0; k < set.lines.count; ++k) {
          set.channels[p].frf[k] += one.channels[0].frf[k] / static_cast<double>(hits_per_point);
          one.channels[0].frf[k] *= force[k];
        }
        frfs.set.channels.push_back({.point = frfs.set.points.size(), .channel = 0, .frf = {}});
        frfs.set.points.push_back(one.points.front());
        frfs.points.push_back(p);
        spectra.push_back(one.channels[0].frf);
      }
    }
    frfs.accel.assign(spectra.begin(), spectra.end());
  }

  std::vector<Mode> modes(const std::vector<Pole>& poles) const {
    const JointFit fit = fit_residues(set, poles);
    std::vector<Mode> out;
    for (std::size_t m = 0; m < poles.size(); ++m) {
      Mode& mode = out.emplace_back();
      mode.pole = poles[m];
      for (std::size_t o = 0; o < set.channels.size(); ++o) {
        const auto row = static_cast<Eigen::Index>(o), column = static_cast<Eigen::Index>(m);
        mode.residues.push_back({.point = o, .channel = 0, .value = fit.residues(row, column), .std = kNoise});
      }
    }
    return out;
  }
};

// A blow in another direction changes the strong mode by 30 % and leaves the weak one. With the mean residue of the
// strong mode, its flank would move the weak one.
TEST(HitPoles, DoNotDependOnTheResiduesOfOtherModesInTheOtherHits) {
  const Hits hits(1, 5, [](FrfDataset& one, std::size_t, std::size_t hit) {
    test::add_mode(one, 0, kWeak, 1);
    test::add_mode(one, 0, kStrong, 50 * (0.7 + 0.15 * static_cast<double>(hit)));
  });
  const std::vector<Mode> modes = hits.modes({kWeak, kStrong});
  const WindowedHitPoles poles = windowed_hit_poles(hits.set, hits.frfs, modes);
  ASSERT_FALSE(poles.of_hits.empty());
  for (const HitPole& hit : poles.poles[0].hits) {
    ASSERT_TRUE(hit.known);
    EXPECT_NEAR(hit.pole.freq_Hz, kWeak.freq_Hz, 5 * hit.freq_std_Hz);
    EXPECT_NEAR(hit.pole.damping_ratio, kWeak.damping_ratio, 5 * hit.damping_std);
  }
}

// A mode that no fit knows moves the poles of the hits, by another amount at each point.
TEST(HitScatter, ComparesTheHitsOfASurveyWithinTheirPoints) {
  const Hits hits(6, 3, [](FrfDataset& one, std::size_t point, std::size_t) {
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

TEST(HitScatter, FindsHitsOfOnePointThatDiffer) {
  const Hits hits(6, 3, [](FrfDataset& one, std::size_t point, std::size_t hit) {
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
  const Hits hits(6, 3, [](FrfDataset& one, std::size_t point, std::size_t hit) {
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

}  // namespace percuss::identify::hit_scatter_test
