#include "identify/noise/window_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace percuss::identify {
WindowNoise::WindowNoise(const FrfDataset& set)
    : decay_per_s_(set.window_decay_per_s()), fall_(2 * decay_per_s_ / set.lines.df_Hz()) {}

// The noise of lines m apart has the correlation coefficient a/(a + 2πjm) if the window's power falls by exp(−a) over
// the record. Its real part is needed here.
double WindowNoise::roughness() const {
  const auto correlation = [&](int apart) {
    const double turn = kTwoPi * apart;
    return fall_ * fall_ / (fall_ * fall_ + turn * turn);
  };
  return fall_ > 0 ? kWhiteRoughness - 2 * correlation(1) + 0.5 * correlation(2) : kWhiteRoughness;
}

double WindowNoise::max_factor() const { return fall_ > 0 ? fall_ / -std::expm1(-fall_) : 1; }

// The mean of the window's power w², weighted with the power of the windowed mode, which decays at the rate δ:
// ∫w⁴e^(−2δt)/∫w²e^(−2δt).
double WindowNoise::share(const Pole& pole) const {
  const double decay_per_s = pole.damping_ratio * kTwoPi * pole.freq_Hz;
  return (decay_per_s + decay_per_s_) / (decay_per_s + 2 * decay_per_s_);
}

double WindowNoise::factor(double of_share) const { return fall_ > 0 ? std::max(1.0, max_factor() * of_share) : 1; }

// The mean of w², weighted with the power of (t − t̄) e^(−δt) w, where t̄ is the mean time of the windowed mode's power.
// A small change of the pole adds this function of time to the response, and no change of the residue can fit it.
double WindowNoise::of_pole(const Pole& pole) const {
  const double r = share(pole);
  return factor(r * (1 - 2 * r + 2 * r * r));
}

double WindowNoise::of_residue(const Pole& pole) const { return factor(share(pole)); }

double WindowNoise::of_residue_by_pole(const Pole& pole) const {
  const double r = share(pole);
  return factor(r * (3 - 4 * r + 2 * r * r));
}

}  // namespace percuss::identify
