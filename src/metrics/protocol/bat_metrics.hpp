#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/uncertain_value.hpp"

namespace percuss::metrics {

/// What was read of one bat and one impact, each with the standard deviation of its reading; SI. What was not read is
/// absent, and so is every result that needs it.
struct BatReadings {
  std::optional<UncertainValue> length_m, mass_kg, cg_m, period_s;
  std::optional<UncertainValue> moi_kgm2;      // in place of the pendulum's
  std::optional<UncertainValue> ball_kg, z_m;  // z from the barrel's tip
  std::optional<UncertainValue> in_mps, out_mps;
  std::optional<UncertainValue> besr, bbcor;  // in place of the speeds'
  std::optional<UncertainValue> swing_mps;    // in place of the swing model's
  double pitch_mps = kPitchSpeed_mps;
  double nominal_mps = kNominalSpeed_mps;
  double gravity_mps2 = kProtocolGravity_mps2;
  double lot_correction = 0;  // ε of the balls, added to v_out/v_in
  SwingModel swing;
};

/// The results, (P1) to (P10); absent where the readings do not allow them.
struct BatMetrics {
  std::optional<UncertainValue> drop, moi_kgm2, besr, ncaa_besr, bbs_mps, bbcor, contact_mps, swing_mps, k;
  std::optional<int> drop_class;
};

/// All that the readings allow. BESR comes from the speeds, from its own reading, or from BBCOR, in this order.
BatMetrics bat_metrics(const BatReadings& readings);

/// The class that the rules name: −3 for bats 2.1 to 3.0 oz below their length in inches; none for others.
std::optional<int> drop_class_of(double drop);

struct MetricsWarning {
  std::string code, message;
};

/// What a reader of the results must know: constants of the source that do not agree, readings that make no sense.
std::vector<MetricsWarning> metrics_warnings(const BatReadings& readings, const BatMetrics& metrics);

}  // namespace percuss::metrics
