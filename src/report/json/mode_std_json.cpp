#include "report/json/mode_std_json.hpp"

#include <nlohmann/json.hpp>

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json parts_json(const identify::StdParts& parts) {
  return {{"noise", parts.noise}, {"hits", parts.hits}, {"misfit", parts.misfit}};
}

Json amplitude_json(const identify::AmplitudeTrend& trend) {
  return {{"frequency_slope_hz_per_n", trend.freq_slope_Hz_per_N}, {"std", trend.freq_slope_std},
          {"frequency_at_zero_hz", trend.freq_at_zero_Hz},         {"damping_slope_per_n", trend.damping_slope_per_N},
          {"damping_slope_std", trend.damping_slope_std},          {"damping_ratio_at_zero", trend.damping_at_zero}};
}

}  // namespace

void add_std_parts(Json& json, const identify::Mode& mode) {
  json["frequency_std_parts_hz"] = parts_json(mode.freq_std_parts_Hz);
  json["damping_ratio_std_parts"] = parts_json(mode.damping_std_parts);
  json["amplitude"] = mode.amplitude ? amplitude_json(*mode.amplitude) : Json();
  if (mode.drift)
    json["drift"] = {{"frequency_change_per_hit", mode.drift->freq_change_per_hit}, {"std", mode.drift->std}};
}

}  // namespace percuss::report
