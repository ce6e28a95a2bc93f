#pragma once
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "metrics/deflection/integration.hpp"
#include "metrics/deflection/modal_response.hpp"

namespace percuss::metrics {

enum class DeflectionMethod { automatic, small_interval, drift_free, frequency, modal };
const char* name_of(DeflectionMethod method);

/// The acceleration that a sensor shows at rest.
struct SensorLevel {
  double mps2 = 0, std_mps2 = 0;
};

/// One impact, measured by one accelerometer.
struct ImpactSignal {
  double fs_Hz = 0;
  std::span<const double> accel_mps2;  // [samples]
  double onset_s = 0;                  // start of the contact, from the first sample; the structure rests before it
  // The excitation, for the modal method and for a free body:
  std::span<const double> force_N;  // [samples]; empty: not measured
  double force_noise_N = 0;         // standard deviation of a sample
  double rigid_per_kg = 0;          // rigid-body accelerance of a free body at the point; 0: held or unknown
  std::vector<ModalContribution> modes;
  /// The strength of the accelerometer's 1/f noise (baseline_noise.hpp), from several impacts; 0: white noise. Not set:
  /// estimated from this signal.
  std::optional<double> flicker_strength{};
  /// FlickerEvidence::motion of this signal, from the same options. Null: deflection_of() integrates.
  std::shared_ptr<const Motion> motion{};
  /// The sensor's level, from the rest before an earlier impact of the same record. Not set: the structure is taken to
  /// rest before this impact.
  std::optional<SensorLevel> level{};
};

struct DeflectionOptions {
  DeflectionMethod method = DeflectionMethod::automatic;
  double highpass_corner_Hz = 0;    // first-order corner of the charge amplifier; 0: none
  std::optional<double> lowest_Hz;  // for `frequency`; default: half the frequency of the deflection's largest line
  bool free_body = false;           // the structure may move away and need not return to its position of rest
  bool moves_before = false;  // the structure already moves before the impact: not all of its motion is the blow's
};

struct Deflection {
  DeflectionMethod method = DeflectionMethod::drift_free;
  std::vector<double> velocity_mps, deflection_m;
  std::vector<double> std_m;  // of the deflection; empty where the method has none
  double bias_mps2 = 0;       // subtracted from the acceleration
  // The late deflection, about the position of rest or at it, served to correct the drift (ZeroMeanCorrection).
  bool zero_mean_corrected = false;
  // drift_free only: the line through the samples before the impact, which is no bias of the sensor (ImpactSignal::
  // level), made most of the deflection. The standard deviation includes it, and the peak was found anew.
  bool moved_before = false;
  std::size_t peak = 0;  // sample of the largest significant deflection
  double peak_m = 0;     // signed; NaN, like peak_std_m and forward_m, where no deflection is significant
  double peak_std_m = 0;
  bool larger_later = false;  // larger values follow the peak, but their standard deviation grows faster than they
  // modal only: rigid-body motion is left out, and the record does not show that the structure returns to rest
  bool rigid_motion_left_out = false;
  // modal only: the integral of the acceleration contradicts the stated rigid-body motion; the standard deviation
  // includes the difference
  bool rigid_motion_contradicted = false;
  double forward_m = 0, forward_std_m = 0;  // the peak in the direction of the first motion; signed
  // The deflection that bias and drift cause at the last sample: for drift_free its standard deviation, for
  // small_interval its value; 0 for the other methods.
  double drift_m = 0;

  bool has_peak() const { return !std::isnan(peak_m); }
};

/// Computes the deflection of the struck structure from its acceleration (and force).
///   drift_free      subtracts the bias and drift before the impact, integrates without quadrature error
///                   (integrate_twice), and centres a held structure on its position of rest. Its standard deviation
///                   includes the bias and the double integral of white noise, σ_w² = σ_a² Δt t³/3. Where the noise
///                   rises at low frequencies, the error that it makes is estimated and subtracted (BaselineNoise).
///                   If the line before the impact shows a motion (Deflection::moved_before), the standard deviation
///                   includes the line's difference from the sensor's level.
///   small_interval  first-order sums from the impact on (small_interval_sums), without any correction
///   frequency       division in the frequency domain, line by line
///   modal           the response of the modes to the force. With rigid-body motion it is compared with the integral
///                   of the acceleration (Deflection::rigid_motion_contradicted): a body hung on a suspension is free
///                   only for a part of the suspension's period
///   automatic       modal where force and modes are known and the record does not show the structure at rest before
///                   the impact; otherwise drift_free
/// Precondition: modal needs force and modes. shapes [samples].
/// theory (7.4)
Deflection deflection_of(const ImpactSignal& signal, const DeflectionOptions& options = {});

/// The evidence of one signal for 1/f noise, for drift_free.
struct FlickerEvidence {
  /// BaselineNoise::log_gains(). flicker_strength() of the sum over the impacts gives ImpactSignal::flicker_strength,
  /// since they share the noise of the sensor. Empty where the signal gives none.
  std::vector<double> log_gains;
  /// Of the acceleration after the samples at rest, less the line through them. deflection_of() need not compute it
  /// again.
  std::shared_ptr<const Motion> motion;
};
FlickerEvidence flicker_evidence(const ImpactSignal& signal, const DeflectionOptions& options = {});

/// The level of a sensor, from the samples before an impact. Its standard deviation includes a drift of the level
/// within them. Nothing with fewer than 64 samples.
std::optional<SensorLevel> sensor_level(std::span<const double> before_mps2, double fs_Hz);

/// The time at which the structure starts to move, counted from the first sample, for records without force. It is the
/// time of the first sample beyond eight standard deviations of the noise (from the first fiftieth of the record) and
/// beyond a thousandth of the largest sample. A glitch below a hundredth of the largest sample does not count if 64
/// samples at rest follow.
double motion_onset_s(std::span<const double> accel_mps2, double fs_Hz);

}  // namespace percuss::metrics
