#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/fit/local_fit.hpp"
#include "synth/spec.hpp"

namespace percuss::test {

/// H1 of all channels of a record with one hit per row, by point, at the lines from low to high, from forces that are
/// known in full: no gate, no baseline. With `decay_per_s` an exponential window of that decay.
identify::FrfDataset frf_set_of(const acquire::Record& record, double low_Hz, double high_Hz, double decay_per_s = 0);

/// A set of one point and `channels` FRF channels, all zero, from a force of one sample: lines of a record so long that a
/// mode of more than 5 bandwidths per hertz has gone at its end.
identify::FrfDataset empty_set(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz, std::size_t channels);

/// H of one mode, straight from its definition.
Complex mode_accelerance(const identify::Pole& pole, Complex s);

/// Adds a mode's lines to an output, and white noise whose real and imaginary parts each have this deviation.
void add_mode(identify::FrfDataset& set, std::size_t output, const identify::Pole& pole, Complex residue);
void add_frf_noise(identify::FrfDataset& set, double deviation, std::uint64_t seed);

/// A bat test of quiet channels: these modes, a row of so many seconds, no noise, accelerometers at 0° and 90°.
synth::SynthSpec bat_spec(std::vector<synth::SynthMode> modes, double duration_s);

/// A beam with one bending mode whose node lies at 7.5 in, struck once at each of `points` places from `first_in` on.
synth::SynthSpec roving_beam_spec(double first_in, double step_in, int points);

}  // namespace percuss::test
