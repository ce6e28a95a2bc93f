#include "support/hits_with_phases.hpp"

#include <complex>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::test {
namespace {

constexpr double kNoise = 1e-4;

identify::FrfDataset frf_of(const identify::Mode& strong, const identify::Mode& weak, std::uint64_t seed) {
  identify::FrfDataset set = empty_set(2000, 2000, 10, 990, 1);
  for (const identify::Mode* mode : {&strong, &weak}) add_mode(set, 0, mode->pole, mode->residues.front().value);
  add_frf_noise(set, kNoise, seed);
  return set;
}

}  // namespace

identify::Mode mode_at(double freq_Hz, double half_power_Hz, Complex residue) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = freq_Hz, .damping_ratio = half_power_Hz / freq_Hz / 2};
  mode.residues = {{.value = residue}};
  return mode;
}

HitsWithPhases::HitsWithPhases(const identify::Mode& weak, std::size_t hits, double turns)
    : strong(mode_at(431, 4, 100)), weak_mean(weak) {
  Complex mean;
  for (std::size_t h = 0; h < hits; ++h) {
    const Complex phase = std::polar(1.0, kTwoPi * turns * static_cast<double>(h));
    identify::Mode of_hit = weak;
    of_hit.residues.front().value *= phase;
    identify::FrfDataset one = frf_of(strong, of_hit, h + 2);
    const Complex* const force = one.points.front().spectra.front().get();
    for (std::size_t k = 0; k < one.lines.count; ++k) one.channels.front().frf[k] *= force[k];
    mean += phase / static_cast<double>(hits);
    spectra_.push_back(one.channels.front().frf);
    frfs.set.points.push_back(one.points.front());
    frfs.set.channels.push_back({.point = h, .channel = 0, .frf = {}});
    frfs.points.push_back(0);
  }
  for (const std::vector<Complex>& spectrum : spectra_) frfs.accel.emplace_back(spectrum);
  weak_mean.residues.front().value *= mean;
  set = frf_of(strong, weak_mean, 1);
  frfs.set.lines = set.lines;
  frfs.set.usable_bandwidth_Hz = set.usable_bandwidth_Hz;
}

}  // namespace percuss::test
