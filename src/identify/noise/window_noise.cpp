#include "identify/noise/window_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace percuss::identify {
WindowNoise::WindowNoise(const FrfDataset& set)
    : decay_per_s_(set.window_decay_per_s()), fall_(2 * decay_per_s_ / set.lines.df_Hz()) {}

// Lines m apart have a/(a + 2πjm) of their noise in common, when its power falls by exp(−a) over the record.
double WindowNoise::roughness() const {
  const auto common = [&](int apart) {
    const double turn = kTwoPi * apart;
    return fall_ * fall_ / (fall_ * fall_ + turn * turn);
  };
  return fall_ > 0 ? kWhiteRoughness - 2 * common(1) + 0.5 * common(2) : kWhiteRoughness;
}

double WindowNoise::most() const { return fall_ > 0 ? fall_ / -std::expm1(-fall_) : 1; }

// The window's power once more, over the record as the mode sees it: ∫w⁴e^(−2σt)/∫w²e^(−2σt).
double WindowNoise::share(const Pole& pole) const {
  const double decay_per_s = pole.damping_ratio * kTwoPi * pole.freq_Hz;
  return (decay_per_s + decay_per_s_) / (decay_per_s + 2 * decay_per_s_);
}

double WindowNoise::of_residue(const Pole& pole) const { return fall_ > 0 ? std::max(1.0, most() * share(pole)) : 1; }

// What a pole's step does grows with time, so that later samples count.
double WindowNoise::of_pole(const Pole& pole) const {
  return fall_ > 0 ? std::max(1.0, most() * std::pow(share(pole), 3)) : 1;
}

}  // namespace percuss::identify
