#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/warning.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/uncertain_value.hpp"

namespace percuss::metrics {

/// The readings of one bat and one impact in SI units, each with its standard deviation. A result that needs an absent
/// reading is absent as well.
struct BatReadings {
  std::optional<UncertainValue> length_m, mass_kg, cg_m, period_s;
  std::optional<UncertainValue> moi_kgm2;      // replaces the pendulum
  std::optional<UncertainValue> ball_kg, z_m;  // z from the barrel's tip
  std::optional<UncertainValue> in_mps, out_mps;
  std::optional<UncertainValue> besr, bbcor;  // one of them, where the speeds are absent
  std::optional<UncertainValue> swing_mps;    // replaces the swing model
  double pitch_mps = kPitchSpeed_mps;
  double nominal_mps = kNominalSpeed_mps;
  double gravity_mps2 = kProtocolGravity_mps2;
  double lot_correction = 0;  // ε of the balls, added to v_out/v_in
  SwingModel swing;
};

/// The results (P1) and (P3) to (P10); absent where a reading is missing.
struct BatMetrics {
  std::optional<UncertainValue> drop, moi_kgm2, besr, ncaa_besr, bbs_mps, bbcor, contact_mps, swing_mps, k;
  std::optional<int> drop_class;
};

/// Computes all results that the readings allow. BESR comes from the speeds, else from its own reading, else from
/// BBCOR.
/// errors  InputError: BESR and BBCOR are both given.
BatMetrics bat_metrics(const BatReadings& readings);

/// The class of a drop in the rules: −3 for 2.1 to 3.0 oz below the length in inches, none otherwise.
std::optional<int> drop_class_of(double drop);

using warnings::Warning;
using warnings::with_remedy;

/// All codes of metrics_warnings(), most serious first. docs/reference/warnings.md has a row for each.
std::span<const warnings::RankedCode> ranked_metrics_codes();

/// Warns of implausible values and of inconsistent constants of the source. The most serious warning comes first, and
/// each has the severity of its code.
std::vector<Warning> metrics_warnings(const BatReadings& readings, const BatMetrics& metrics);

}  // namespace percuss::metrics
