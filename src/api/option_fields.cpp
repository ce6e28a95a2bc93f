#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "percuss/error.hpp"

namespace percuss {
namespace {

/// An aggregate and one of its fields that is an option. The name of the field is the identifier, then "_" and the unit
/// if any.
struct FieldName {
  std::string_view aggregate, field;
};

constexpr std::array<FieldName, 56> kFields{{
    {"ReadOptions", "fs_Hz"},
    {"ReadOptions", "df_Hz"},
    {"ReadOptions", "force_channel"},
    {"ReadOptions", "accel_channel"},
    {"ReadOptions", "force_unit"},
    {"ReadOptions", "unit"},
    {"ReadOptions", "force_scale"},
    {"ReadOptions", "accel_scale"},
    {"ReadOptions", "force_sensitivity_VpN"},
    {"ReadOptions", "accel_sensitivity_Vpmps2"},
    {"ReadOptions", "pressure_sensitivity_VpPa"},
    {"ReadOptions", "angle_rad"},
    {"ReadOptions", "position_m"},
    {"ReadOptions", "setup"},
    {"ReadOptions", "frf_kind"},
    {"ReadOptions", "averages"},
    {"ReadOptions", "files"},
    {"ReadOptions", "trust_input"},
    {"HitOptions", "trigger_N"},
    {"HitOptions", "pretrigger_s"},
    {"HitOptions", "length_s"},
    {"HitOptions", "from_s"},
    {"HitOptions", "to_s"},
    {"HitOptions", "force_window"},
    {"HitOptions", "accept_hit"},
    {"HitOptions", "reject_hit"},
    {"AnalysisOptions", "band_Hz"},
    {"AnalysisOptions", "effort"},
    {"AnalysisOptions", "estimator"},
    {"AnalysisOptions", "modes"},
    {"AnalysisOptions", "start_Hz"},
    {"AnalysisOptions", "exponential"},
    {"AnalysisOptions", "delay_s"},
    {"AnalysisOptions", "overlay_dB"},
    {"AnalysisOptions", "object"},
    {"AnalysisOptions", "threads"},
    {"AnalysisOptions", "budget"},
    {"JsonOptions", "per_hit"},
    {"JsonOptions", "stabilisation"},
    {"SurveyOptions", "geometry"},
    {"SurveyOptions", "roving"},
    {"SurveyOptions", "driving_point"},
    {"DeflectionOptions", "method"},
    {"DeflectionOptions", "highpass_corner_Hz"},
    {"DeflectionOptions", "lowest_Hz"},
    {"DeflectionOptions", "free_body"},
    {"DeflectionOptions", "effective_mass_kg"},
    {"DeflectionOptions", "positions_m"},
    {"DeflectionOptions", "beam_distance_m"},
    {"DeflectionOptions", "beam_time_s"},
    {"WriteOptions", "kind"},
    {"WriteOptions", "picture"},
    {"WriteOptions", "overwrite"},
    {"SynthOptions", "seed"},
    {"BatReadings", "besr"},
    {"BatReadings", "bbcor"},
}};

constexpr std::array<std::string_view, 9> kUnits{"Hz", "VpN", "Vpmps2", "VpPa", "rad", "m", "s", "N", "kg"};

// Whether an identifier names a field: "fs" names fs_Hz. There are two exceptions. "overlay_db" contains its unit, and
// "force" names the field `overwrite`, because "force" means a signal in the C++ interface.
bool names(std::string_view field, std::string_view id) {
  if (field == id) return true;
  if (id == "overlay_db" || id == "force") return field == (id == "force" ? "overwrite" : "overlay_dB");
  if (!field.starts_with(id) || field.size() <= id.size() || field[id.size()] != '_') return false;
  const std::string_view unit = field.substr(id.size() + 1);
  return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

}  // namespace

std::string option_field(std::string_view id) {
  for (const FieldName& name : kFields) {
    if (names(name.field, id)) return std::string(name.aggregate) + "::" + std::string(name.field);
  }
  return std::string(id);
}

}  // namespace percuss
