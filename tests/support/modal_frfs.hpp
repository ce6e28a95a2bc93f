#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/fit/local_fit.hpp"
#include "synth/spec.hpp"

namespace percuss::test {

/// H1 estimates of all channels of a record with one hit per row, by point, at the spectral lines from low to high. The
/// force is exact, without a force window or baseline. `decay_per_s` is the decay of an exponential window.
identify::FrfDataset frf_set_of(const acquire::Record& record, double low_Hz, double high_Hz, double decay_per_s = 0);

/// FRFs of zeros for one point and `channels` FRF channels, from a force of one sample. `samples` is the length of the
/// record and sets the line spacing. A mode with a half-power bandwidth of 5 lines decays to 2e-7 within the record.
identify::FrfDataset empty_set(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz, std::size_t channels);

/// The FRF of one mode, by its definition.
Complex mode_accelerance(const identify::Pole& pole, Complex s);

/// Adds the FRF of a mode to an output, and white noise whose real and imaginary parts have this standard deviation.
void add_mode(identify::FrfDataset& set, std::size_t output, const identify::Pole& pole, Complex residue);
void add_frf_noise(identify::FrfDataset& set, double deviation, std::uint64_t seed);

/// A bat test without noise: these modes, rows of this many seconds, accelerometers at 0° and 90°.
synth::SynthSpec bat_spec(std::vector<synth::SynthMode> modes, double duration_s);

/// A beam with one bending mode whose node lies at 7.5 in, struck once at each of `points` positions from `first_in`
/// on.
synth::SynthSpec roving_beam_spec(double first_in, double step_in, int points);

}  // namespace percuss::test
