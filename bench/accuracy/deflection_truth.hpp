#pragma once
#include <cstddef>
#include <vector>

#include "synth/pulse.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// The exact deflection of a held structure after a pulse, at times t from the start of the record:
///   w(t) = Σ_r A_r/ω_dr · Im z_r(t),  z_r(t) = ∫ f(τ) exp(s_r (t − τ)) dτ,  s_r = −ζω + jω_d          (1)
/// The integral uses a Gauss–Legendre rule on 64 panels of the pulse, and no sample, transform or filter. (The
/// anti-alias filter of the synthetic record changes nothing: its gain is 1 to within 2e-12 at a few hundred Hz.)
class TrueDeflection {
 public:
  TrueDeflection(const synth::Pulse& pulse, const std::vector<synth::SynthPole>& poles);
  /// w(t) for any time after the pulse.
  double at_m(double t_s, const std::vector<double>& residue_per_kg) const;
  /// The largest magnitude after the pulse and its time: on a grid of a hundredth of the highest mode's period, over
  /// two periods of the lowest, then between grid points.
  struct Peak {
    double value_m = 0, time_s = 0;
  };
  Peak peak(const std::vector<double>& residue_per_kg) const;

 private:
  struct ModalState {
    double decay_per_s, omega_radps;
    double re, im;  // z at the end of the pulse
  };
  double end_s_;
  std::vector<ModalState> states_;
};

}  // namespace percuss::accuracy
