#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "identify/decay/free_decay_fit.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The amplitude of a mode in each hit, at the decays' first sample and in the reference channel.
struct HitAmplitude {
  Complex value;
  double std = 0;  // of the real part and of the imaginary part
};

/// A mode of a structure that moves freely.
struct DecayMode {
  /// The residues are relative: the amplitudes of the channels over the reference channel's, which is 1. Their
  /// standard deviations include the reference's.
  Mode mode;
  std::vector<HitAmplitude> hits;
  double energy = 0;                                               // over the noise
  std::optional<std::pair<double, double>> alternative_pair_Hz{};  // FittedDecay::alternative_pair_Hz
  std::vector<DecayMode> companions{};                             // gather_companions(): further parts of its decay
  std::vector<double> unresolved_Hz{};  // gather_companions(): other modes that may be parts of its decay
};

/// The modes of a test without a force, and the sinusoids among its decays.
struct DecayResults {
  std::vector<DecayMode> modes;  // ascending in frequency
  std::vector<DecayMode> tones;  // do not decay: their damping ratio is within three standard deviations of 0
  std::size_t reference = 0;     // channel: no mode has a node there, as far as the channels allow
};

/// The modes within a band from fitted decays. Amplitudes of several hits and channels are a product of one number per
/// hit and one per channel (rank one, weighted by the channels' noise). The parts of a ± are as for modes of FRFs:
/// noise; scatter between the hits, where it is significant; misfit, where neighbouring residuals correlate, and the
/// spread of the companions (gather_companions).
/// `channels` is the number of channels of the FreeDecays.
DecayResults modes_of_decays(const FreeDecayFit& fit, std::size_t channels, std::pair<double, double> band_Hz);

}  // namespace percuss::identify
