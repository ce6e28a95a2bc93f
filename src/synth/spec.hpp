#pragma once
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace percuss::synth {

enum class SynthModeType { bending, hoop };
enum class SynthLayout { rows, continuous };               // one hit per row, or one long row with every hit of a run
enum class PulseKind { halfsine, haversine, sine_cubed };  // sin, sin² and sin³ of π t/width
enum class SynthFaultKind { double_hit, weak, missing, late, reversed };

struct SynthMode {
  double freq_Hz = 0;
  double damping_ratio = 0;
  SynthModeType type = SynthModeType::bending;
  int order = 1;                         // bending: of the free-free beam; hoop: axial half-waves
  double angle_rad = 0;                  // plane of bending; an antinode of the hoop pattern
  double amplitude_per_sqrt_kg = 1;      // mass-normalised shape: at the knob (bending), at the antinode (hoop)
  std::vector<double> residue_per_kg{};  // [points × sensors]; replaces the shape
};

struct SynthSensor {
  double position_m = 2 * kInch_m;
  double angle_rad = 0;
  double sign = 1;  // −1: mounted in the opposite direction
  double gain = 1;  // recorded / true value: 0.98 reads 2 % low
};

struct SynthPoint {
  double position_m = 6 * kInch_m;
  double angle_rad = 0;
  std::vector<double> xyz_m{};  // [3], for the record's geometry only; empty: from position and angle
};

/// A free bat. The inertia is about the centre of mass.
struct SynthStructure {
  double length_m = 0.84;
  double barrel_m = 13 * kInch_m;  // from the end to the taper: the range of the hoop modes
  double radius_m = 0.0333;        // only for the drawing of points
  double mass_kg = 0.85;
  double inertia_kgm2 = 0.045;
  double cm_m = 0.378;
  std::vector<double> rigid_line_per_kg{};  // [points × sensors]; replaces mass, inertia and cm
};

struct SynthPulse {
  PulseKind kind = PulseKind::haversine;
  double width_s = 0.3e-3;
  double peak_N = 300;
  double width_spread = 0.1;  // relative, uniform between −spread and +spread
  double peak_spread = 0.25;
};

/// Standard deviations of white Gaussian noise, as fractions.
struct SynthNoise {
  double force = 0;  // of the largest force in the test
  double accel = 0;  // of the channel's RMS over the test
};

/// The effects of a recorder on the signals after its filter, in this order: gain, noise, bias and drift, clipping,
/// quantisation.
struct SynthRecorder {
  double force_gain = 1;  // recorded force over true force
  double force_bias_N = 0;
  double accel_bias_mps2 = 0;
  double accel_drift_mps2_per_s = 0;
  std::optional<double> force_clip_N{};
  std::optional<double> accel_clip_mps2{};
  int bits = 0;                           // 0: no quantisation
  std::optional<double> force_range_N{};  // full scale for `bits`; absent: see recorder_range()
  std::optional<double> accel_range_mps2{};
};

/// A fault of one hit. `hit` counts from 0 over the hits of a run (point by point).
struct SynthFault {
  std::size_t hit = 0;
  SynthFaultKind kind = SynthFaultKind::double_hit;
  double ratio = 0.3;      // second pulse to first (double_hit); peak to its usual value (weak)
  double delay_s = 0.010;  // from the first pulse to the second (double_hit), from the onset to the trigger (late)
};

/// The description of a synthetic hammer test. The defaults describe a bat test. Build it with designated initialisers
/// or read it from JSON (read_spec.hpp; docs/guides/synth.md states the keys). Positions count from the barrel's end,
/// angles around the barrel.
struct SynthSpec {
  std::string name = "synthetic";
  std::string description{};
  double fs_Hz = 25600;
  std::size_t samples = 25600;  // per row
  SynthLayout layout = SynthLayout::rows;
  std::uint64_t seed = 0;
  double band_low_Hz = 60, band_high_Hz = 3200;  // modes in it are marked in_band in the truth document
  SynthStructure structure{};
  std::vector<SynthMode> modes{};
  std::vector<SynthSensor> sensors{{}, {.angle_rad = std::numbers::pi / 2}};
  std::vector<SynthPoint> points{{}};  // several: roving hammer
  SynthPulse pulse{};
  std::size_t hits = 5;               // per point and run
  std::size_t runs = 1;               // repetitions of the hits with new noise
  double pretrigger_s = 0.005;        // from the start of a row to the onset; negative: the row misses the onset
  double onset_spread_s = 0.0015;     // random part, uniform from 0 to this: onsets fall between samples
  std::vector<double> hit_times_s{};  // continuous: onsets; empty: spread evenly, with jitter
  SynthNoise noise{};
  SynthRecorder recorder{};
  std::vector<SynthFault> faults{};
};

/// Checks that the spec is finite, physical and small enough for memory.
/// errors  InputError with the key and `where`.
void validate(const SynthSpec& spec, std::string_view where = "synth spec");

}  // namespace percuss::synth
