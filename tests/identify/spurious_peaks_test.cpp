// Surveys with frequency scatter between points and noise that grows with the response. A fit with the same poles at
// all points leaves a residual with many peaks, none of which is a mode.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::spurious_peaks_test {

constexpr double kGainNoise = 0.05;
constexpr double kLineNoise = 0.01;  // the peaks are a few hundred high
constexpr std::uint64_t kSeed = 1;
const std::vector<double> kModes_Hz{112, 307, 596, 974};

// One hit at each of nine points, ζ = 1e-4, lines 0.04 Hz apart; the force is unknown.
FrfDataset survey(double low_Hz) {
  FrfDataset set = test::empty_set(2560, 65536, low_Hz, 1000, 9);
  set.points.assign(9, {});
  synth::RandomStream random({kSeed});
  const auto normal = [&] {
    std::array<double, 1> value{};
    random.add_normal(1, value);
    return value[0];
  };
  for (std::size_t p = 0; p < 9; ++p) {
    set.channels[p].point = p;
    set.channels[p].channel = 0;
    for (std::size_t m = 0; m < kModes_Hz.size(); ++m) {
      const double shape = std::cos(static_cast<double>((m + 1) * p) * 0.4 + 0.3);
      const Pole pole{kModes_Hz[m] + 0.2e-4 * kModes_Hz[m] * normal(), 1e-4};
      test::add_mode(set, p, pole, 0.1 * shape);
    }
    for (Complex& line : set.channels[p].frf) line *= Complex(1 + kGainNoise * normal(), kGainNoise * normal());
  }
  test::add_frf_noise(set, kLineNoise, kSeed);
  return set;
}

TEST(SpuriousPeaks, KeepsTheModesWithAPeakWhenTheResidualHasManyPeaks) {
  for (const double low_Hz : {70.0, 80.0}) {
    const auto modes = identify_modes(survey(low_Hz));
    for (const double freq_Hz : kModes_Hz) {
      const auto near = [&](const Mode& mode) { return std::abs(mode.pole.freq_Hz - freq_Hz) < 0.1; };
      EXPECT_EQ(std::count_if(modes.begin(), modes.end(), near), 1) << freq_Hz << " from " << low_Hz;
    }
  }
}

}  // namespace percuss::identify::spurious_peaks_test
