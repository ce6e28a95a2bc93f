// FRFs from arrays of force and acceleration, for a program that acquires its own data.
//
//   frf_from_arrays [MOBILITY.csv]
//
// The signals are those of one oscillator, 0.5 kg at 120 Hz with a damping ratio of 0.01, under three half-sine pulses.
#include <percuss/analysis.hpp>
#include <percuss/error.hpp>
#include <percuss/frf.hpp>
#include <percuss/write.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

namespace {

constexpr double kRate_Hz = 8192, kFreq_Hz = 120, kDamping = 0.01, kMass_kg = 0.5;
constexpr std::size_t kSamples = 16384, kFirst = 80, kPulse = 16;

// A half-sine pulse from sample kFirst on.
std::vector<double> pulse_N(double peak_N) {
  std::vector<double> force(kSamples);
  for (std::size_t n = 0; n <= kPulse; ++n)
    force[kFirst + n] = peak_N * std::sin(std::numbers::pi * static_cast<double>(n) / kPulse);
  return force;
}

// The oscillator's acceleration: its velocity and deflection step by step (semi-implicit Euler, 64 steps a sample).
std::vector<double> response_mps2(const std::vector<double>& force_N) {
  constexpr std::size_t kSteps = 64;
  const double omega = 2 * std::numbers::pi * kFreq_Hz, dt_s = 1 / (kRate_Hz * kSteps);
  std::vector<double> accel(kSamples);
  double x_m = 0, v_mps = 0;
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double next_N = n + 1 < kSamples ? force_N[n + 1] : 0;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const double force = force_N[n] + (next_N - force_N[n]) * static_cast<double>(i) / kSteps;
      const double a_mps2 = force / kMass_kg - 2 * kDamping * omega * v_mps - omega * omega * x_m;
      if (i == 0) accel[n] = a_mps2;
      v_mps += a_mps2 * dt_s;
      x_m += v_mps * dt_s;
    }
  }
  return accel;
}

}  // namespace

int main(int argc, char** argv) try {
  percuss::RecordArrays arrays{.fs_Hz = kRate_Hz};
  for (const double peak_N : {80.0, 100.0, 120.0}) {
    arrays.force_N.push_back(pulse_N(peak_N));
    arrays.accel_mps2.push_back({response_mps2(arrays.force_N.back())});  // one channel
  }
  const percuss::Record record = percuss::record_from_arrays(std::move(arrays));

  const percuss::FrfSet frfs = percuss::estimate_frfs(record, {.band_Hz = percuss::Band{20, 400}});
  const percuss::Frf& frf = frfs.frfs().front();
  std::size_t peak = 0;
  for (std::size_t k = 0; k < frf.value.size(); ++k) {
    if (std::abs(frf.value[k]) > std::abs(frf.value[peak])) peak = k;
  }
  std::printf("peak at %.1f Hz: %.1f ± %.2g %s, coherence %.6f\n", frfs.freq_Hz()[peak], std::abs(frf.value[peak]),
              frf.std[peak], frfs.unit().c_str(), frf.coherence[peak]);
  const percuss::FrfSet mobility = frfs.converted(percuss::FrfKind::mobility);
  std::printf("there the mobility is %.4f %s\n", std::abs(mobility.frfs().front().value[peak]),
              mobility.unit().c_str());

  // FRFs are enough for an analysis. These come from the record above; frfs_from_arrays takes FRFs of any source.
  for (const percuss::Mode& mode : percuss::Analysis(frfs).modes())
    std::printf("mode at %.2f Hz, damping ratio %.5f\n", mode.freq_Hz, mode.damping_ratio);
  if (argc > 1) percuss::write(argv[1], mobility, {.overwrite = true});
  return 0;
} catch (const percuss::InputError& error) {
  std::fprintf(stderr, "%s\n", error.written(percuss::option_field).c_str());
  return 3;
}
