#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/model/mode.hpp"
#include "synth/spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::test {

/// H1 estimates of each point and channel, at the spectral lines from low_Hz to high_Hz. Each row of the record is one
/// hit. The force is exact, without a force window or baseline. `decay_per_s` is the decay of an exponential window.
identify::FrfDataset frf_set_of(const acquire::Record& record, double low_Hz, double high_Hz, double decay_per_s = 0);

/// FRFs of zeros for one point and `channels` FRF channels, from a force of one sample. `samples` is the length of the
/// record and sets the line spacing. add_mode adds FRFs of complete decays: a mode with a half-power bandwidth of 5
/// lines decays to 2e-7 within the record.
identify::FrfDataset empty_set(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz, std::size_t channels);

/// The lines as a shared spectrum.
frf::Spectrum make_spectrum(std::vector<Complex> lines);

/// The FRF of one mode, by its definition.
Complex mode_accelerance(const identify::Pole& pole, Complex s);

/// The exact FRF of point 0 and a channel at s. A windowed FRF at ω equals it at s = jω + decay.
Complex exact_at(const synth::Truth& truth, Complex s, std::size_t channel);

/// Adds the FRF of a mode to set.channels[channel].
void add_mode(identify::FrfDataset& set, std::size_t channel, const identify::Pole& pole, Complex residue);
/// Adds white noise to all FRFs. `deviation` is the standard deviation of its real and of its imaginary part.
void add_frf_noise(identify::FrfDataset& set, double deviation, std::uint64_t seed);

/// FRFs of one channel from 250 to 650 Hz, with little noise: a mode at 320 Hz, and forty components from 500 to 503.9
/// Hz that stand for a mode whose frequency changes during the decay.
identify::FrfDataset frfs_of_changing_mode();

/// Gives point 0 the force of a hit: a pulse of 1 N and 9 samples in a gate of 90. The pulse is clean; `noise_N` is the
/// standard deviation that is stated for the noise of the force channel.
void set_gated_pulse(identify::FrfDataset& set, double noise_N);
/// Multiplies all FRFs by a random gain from the errors of the force of point 0.
void add_random_gain(identify::FrfDataset& set, std::uint64_t seed);

/// The FRF of each channel as a vector of the spectral lines.
std::vector<Eigen::VectorXcd> frf_vectors(const identify::FrfDataset& set);
/// The spectral lines as a vector.
Eigen::VectorXcd vector_of(const std::vector<Complex>& lines);
/// The largest magnitude of a line.
double largest(const Eigen::VectorXcd& lines);

/// A normal error exceeds it once in 150 000.
inline constexpr double kModeDeviations = 4.5;
/// Expects as many modes as true poles, with frequencies and damping ratios within kModeDeviations of their stated
/// standard deviations.
void expect_modes_near(const std::vector<identify::Mode>& found, const std::vector<identify::Pole>& truth);

/// A bat test without noise: these modes, rows of this many seconds, accelerometers at 0° and 90°.
synth::SynthSpec bat_spec(std::vector<synth::SynthMode> modes, double duration_s);

/// A bat test with little noise: a bending mode at 200 Hz and a hoop mode at 1900 Hz.
synth::SynthSpec bending_and_hoop_spec(double duration_s = 1);

/// A bat test with rows of 0.35 s: the mode at 120 Hz still has more than a third of its amplitude at the end.
synth::SynthSpec truncated_bat_spec();

/// A beam with one bending mode whose node lies at 7.5 in, struck once at each of `points` positions from `first_in`
/// on.
synth::SynthSpec roving_beam_spec(double first_in, double step_in, int points);

}  // namespace percuss::test
