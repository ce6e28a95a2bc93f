#pragma once
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "metrics/deflection/integration.hpp"
#include "metrics/deflection/modal_response.hpp"

namespace percuss::metrics {

enum class DeflectionMethod { automatic, small_interval, drift_free, frequency, modal };
const char* name_of(DeflectionMethod method);

/// One impact as one accelerometer saw it.
struct ImpactSignal {
  double fs_Hz = 0;
  std::span<const double> accel_mps2;  // [samples]
  double onset_s = 0;                  // of the contact, from the first sample: until then the structure rests
  // What is known of the excitation, for the modal method and for a free body:
  std::span<const double> force_N;  // [samples]; empty: not measured
  double rigid_per_kg = 0;          // accelerance of the free body at the point; 0: held, or not known
  std::vector<ModalContribution> modes;
};

struct DeflectionOptions {
  DeflectionMethod method = DeflectionMethod::automatic;
  double highpass_corner_Hz = 0;    // first-order corner of the charge amplifier; 0: none
  std::optional<double> lowest_Hz;  // of the method frequency; default: half of the strongest line of the deflection
  bool free_body = false;           // the structure may drift away: it need not return to where it rested
};

struct Deflection {
  DeflectionMethod method = DeflectionMethod::drift_free;
  std::vector<double> velocity_mps, deflection_m;
  std::vector<double> std_m;  // of the deflection; empty where the method knows none
  double bias_mps2 = 0;       // that was taken away
  bool held = false;          // the mean late deflection was used to take drift away
  std::size_t peak = 0;       // sample of the largest deflection that the deviation allows to tell
  double peak_m = 0;          // signed; NaN, as its deviation and forward_m, where nothing stands out of the noise
  double peak_std_m = 0;
  double forward_m = 0, forward_std_m = 0;  // the same of deflections the way the structure first went; signed
  double drift_m = 0;                       // deviation that bias and drift have at the last sample

  bool has_peak() const { return !std::isnan(peak_m); }
};

/// Deflection of the struck structure from its acceleration (and force). drift_free: bias of the samples before the
/// impact, rest until then, integration without error (integrate_twice), and the place around which a held structure
/// swings; deviation of the double integral of white noise, σ_w² = σ_a² Δt t³/3, and of the bias. small_interval: the
/// source's sums, from the impact, nothing taken away. frequency: line by line. modal: the modes and the force.
/// Automatic: drift_free where the record shows the rest before the impact, else modal where force and modes are known.
/// Needs force and modes for modal (a precondition). shapes [samples].
/// theory (7.4)
Deflection deflection_of(const ImpactSignal& signal, const DeflectionOptions& options = {});

/// Where the structure starts to move, from the first sample: the first that leaves the noise of the first fiftieth of
/// the record by eight deviations and a thousandth of the largest. For records without force.
double motion_onset_s(std::span<const double> accel_mps2, double fs_Hz);

}  // namespace percuss::metrics
