#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "synth/read_spec.hpp"

namespace percuss::synth {

SynthSpec synth_preset(std::string_view name) {
  std::vector<std::string_view> names;
  for (const SynthPreset& preset : synth_presets()) {
    if (preset.name == name) return parse_synth_spec(preset.text, name);
    names.push_back(preset.name);
  }
  throw InputError("neither a file nor a preset", one_line(name),
                   fmt::format("presets are {}", fmt::join(names, ", ")));
}

std::string_view synth_example() {
  return R"json({
  // A synthetic hammer test. Positions are metres from the barrel's end, angles degrees around the barrel. The keys name
  // all other units. Comments are allowed. Required: fs_hz, samples or duration_s, modes.
  "schema": "percuss/synth/1",
  "name": "example",
  "description": "An example of every key",
  "fs_hz": 25600,
  "samples": 25600,            // per row; or "duration_s": 1.0
  "layout": "rows",            // "rows": one hit each; "continuous": one long row, "hit_times_s": [1.0, 3.5, …]
  "seed": 1,                   // equal spec and seed give equal samples
  "band_hz": [60, 3200],       // modes in it are marked in_band in the truth
  "structure": {               // a free bat
    "length_m": 0.84,
    "barrel_m": 0.33,          // from the end to the taper: the range of hoop modes
    "radius_m": 0.0333,        // only for the drawing of points
    "mass_kg": 0.85,           // rigid body: mass, inertia about its centre, centre of mass
    "inertia_kgm2": 0.045,
    "cm_m": 0.378
    // or "rigid_line_per_kg": [point by point, sensor by sensor]
  },
  "modes": [
    {"frequency_hz": 205, "damping_ratio": 0.008, "family": "bending", "order": 1, "angle_deg": 20, "amplitude_per_sqrt_kg": 1.7},
    {"frequency_hz": 2100, "damping_ratio": 0.0025, "family": "hoop", "order": 1, "angle_deg": 12, "amplitude_per_sqrt_kg": 2.7},
    // residues in place of the shape, sensor by sensor within each point
    {"frequency_hz": 2900, "damping_ratio": 0.003, "family": "hoop", "order": 2, "residue_per_kg": [0.8, -0.8]}
  ],
  "sensors": [
    {"position_m": 0.0508, "angle_deg": 0},
    {"position_m": 0.0508, "angle_deg": 90, "sign": -1, "gain": 1.0}  // opposite direction; recorded / true value
  ],
  "impact": {"position_m": 0.1524, "angle_deg": 20,    // a list of such points: roving hammer
             "xyz_m": [0.1524, 0.0333, 0]},  // optional: the place for the record's geometry alone
  "pulse": {"kind": "haversine", "width_s": 0.00025, "peak_n": 300, "width_spread": 0.1, "peak_spread": 0.25},  // or halfsine, sine-cubed
  "hits": 5,                   // per point and run
  "runs": 1,                   // repetitions of the hits with new noise
  "pretrigger_s": 0.005,       // before the onset; negative: the onset is missed
  "onset_spread_s": 0.0015,    // random part: onsets fall between samples
  "noise": {"force": 0.0001, "accel": 0.001},  // standard deviations, as fractions of the largest force and of each channel's RMS
  "recorder": {
    "force_gain": 1.0,
    "force_bias_n": 0.1, "accel_bias_mps2": 0.5, "accel_drift_mps2_per_s": 0.1,
    "force_clip_n": 1000, "accel_clip_mps2": 10000,
    "bits": 24, "force_range_n": 1200, "accel_range_mps2": 12000
  },
  "faults": [                  // hits count from 0 over a run
    {"hit": 1, "kind": "double", "delay_s": 0.012, "ratio": 0.35},
    {"hit": 2, "kind": "weak", "ratio": 0.05},
    {"hit": 3, "kind": "late", "delay_s": 0.0001},
    {"hit": 4, "kind": "reversed"}
    // {"hit": 0, "kind": "missing"}
  ]
}
)json";
}

}  // namespace percuss::synth
