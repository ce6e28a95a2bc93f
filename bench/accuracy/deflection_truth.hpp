#pragma once
#include <cstddef>
#include <vector>

#include "synth/pulse.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// The deflection that a pulse makes of a held structure's modes, at times t after the record's beginning:
///   w(t) = Σ_r A_r/ω_dr · Im z_r(t),  z_r(t) = ∫ f(τ) exp(s_r (t − τ)) dτ,  s_r = −ζω + jω_d          (1)
/// The integral by Gauss and Legendre's rule on 64 panels of the pulse; no sample, no transform and no filter comes in.
/// (The filter passes what moves: at a few hundred Hz it is 1 to 2e-12.)
class TrueDeflection {
 public:
  TrueDeflection(const synth::Pulse& pulse, const std::vector<synth::SynthPole>& poles);
  double at_m(double t_s, const std::vector<double>& residue_per_kg) const;
  /// Its largest magnitude after the pulse, and when: on a grid of a hundredth of the highest mode's period, over two
  /// periods of the lowest, then between its points.
  struct Peak {
    double value_m = 0, time_s = 0;
  };
  Peak peak(const std::vector<double>& residue_per_kg) const;

 private:
  struct Swing {
    double decay_per_s, omega_radps;
    double re, im;  // z at the pulse's end
  };
  double end_s_;
  std::vector<Swing> swings_;
};

}  // namespace percuss::accuracy
