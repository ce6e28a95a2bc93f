#include "percuss/metrics.hpp"

#include "api/handles.hpp"
#include "core/error.hpp"
#include "metrics/protocol/bat_metrics.hpp"

namespace percuss {
namespace api {
namespace {

std::optional<metrics::UncertainValue> reading(const std::optional<Measured>& value, metrics::Reading which) {
  return value ? std::optional(metrics::UncertainValue(value->value, value->std, which)) : std::nullopt;
}

std::optional<metrics::UncertainValue> positive_reading(const std::optional<Measured>& value, metrics::Reading which,
                                                        const char* field) {
  if (value) require_above_zero(value->value, field);
  return reading(value, which);
}

std::optional<Measured> measured(const std::optional<metrics::UncertainValue>& value) {
  return value ? std::optional(Measured{value->value(), value->std()}) : std::nullopt;
}

void require_between_tip_and_pivot(const std::optional<Measured>& place_m, const std::optional<Measured>& length_m,
                                   const char* field) {
  if (place_m && (place_m->value < 0 || (length_m && place_m->value > length_m->value - metrics::kPivot_m)))
    throw InputError("the place is not between the tip and the pivot", field, "give metres from the barrel's tip");
}

metrics::BatReadings internal_readings(const BatReadings& r) {
  using metrics::Reading;
  metrics::BatReadings out;
  out.length_m = positive_reading(r.length_m, Reading::length, "BatReadings::length_m");
  out.mass_kg = positive_reading(r.mass_kg, Reading::weight, "BatReadings::mass_kg");
  out.cg_m = reading(r.cg_m, Reading::cg);
  out.period_s = positive_reading(r.period_s, Reading::period, "BatReadings::period_s");
  out.moi_kgm2 = positive_reading(r.moi_kgm2, Reading::moi, "BatReadings::moi_kgm2");
  out.ball_kg = positive_reading(r.ball_kg, Reading::ball, "BatReadings::ball_kg");
  out.z_m = reading(r.z_m, Reading::location);
  out.in_mps = positive_reading(r.v_in_mps, Reading::inbound, "BatReadings::v_in_mps");
  out.out_mps = reading(r.v_out_mps, Reading::rebound);
  out.besr = reading(r.besr, Reading::given_besr);
  out.bbcor = reading(r.bbcor, Reading::given_bbcor);
  out.swing_mps = reading(r.v_swing_mps, Reading::swing);
  out.lot_correction = r.lot_correction;
  return out;
}

}  // namespace
}  // namespace api

BatPerformance bat_performance(const BatReadings& readings) {
  if (readings.length_m && !(readings.length_m->value > 2 * metrics::kPivot_m))
    throw InputError("the bat is too short", "BatReadings::length_m", "give more than 0.3048 m");
  api::require_between_tip_and_pivot(readings.cg_m, readings.length_m, "BatReadings::cg_m");
  api::require_between_tip_and_pivot(readings.z_m, readings.length_m, "BatReadings::z_m");
  const metrics::BatReadings internal = api::internal_readings(readings);
  const metrics::BatMetrics results = metrics::bat_metrics(internal);
  BatPerformance out{.drop = api::measured(results.drop),
                     .moi_kgm2 = api::measured(results.moi_kgm2),
                     .besr = api::measured(results.besr),
                     .ncaa_besr = api::measured(results.ncaa_besr),
                     .bbs_mps = api::measured(results.bbs_mps),
                     .bbcor = api::measured(results.bbcor),
                     .v_contact_mps = api::measured(results.contact_mps),
                     .v_swing_mps = api::measured(results.swing_mps),
                     .k = api::measured(results.k)};
  out.warnings = api::warnings_of(metrics::metrics_warnings(internal, results));
  return out;
}

}  // namespace percuss
