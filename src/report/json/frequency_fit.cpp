#include "report/json/frequency_fit.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/math/significance.hpp"
#include "report/text/birge_text.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Whether the standard deviations of the parameters follow from those of the frequencies.
bool states_std(const FrequencyFit& fit) {
  return !fit.frequencies.empty() && fit.frequencies.front().measured_std_Hz > 0;
}

std::size_t degrees_of_freedom(const FrequencyFit& fit) { return fit.frequencies.size() - fit.parameters; }

double difference_percent(const FrequencyFit::Frequency& one) { return 100 * (one.model_Hz / one.measured_Hz - 1); }

}  // namespace

nlohmann::ordered_json frequencies_json(const FrequencyFit& fit) {
  Json out = Json::array();
  for (const FrequencyFit::Frequency& one : fit.frequencies) {
    out.push_back({{"mode", one.mode},
                   {"measured_hz", one.measured_Hz},
                   {"measured_std_hz", one.measured_std_Hz > 0 ? Json(one.measured_std_Hz) : Json()},
                   {"model_hz", one.model_Hz},
                   {"difference_percent", difference_percent(one)}});
  }
  return out;
}

void add_birge_ratio(const FrequencyFit& fit, nlohmann::ordered_json& json) {
  if (states_std(fit)) json["birge_ratio"] = birge_ratio(fit.chi2, static_cast<double>(degrees_of_freedom(fit)));
}

std::string birge_text(const FrequencyFit& fit) {
  return states_std(fit) ? birge_text(fit.chi2, degrees_of_freedom(fit)) : "";
}

TextTable frequency_table(const FrequencyFit& fit) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"measured", TextTable::Align::right},
                   {"model", TextTable::Align::right},
                   {"difference", TextTable::Align::right}});
  for (const FrequencyFit::Frequency& one : fit.frequencies) {
    table.add({std::to_string(one.mode), value_with_std(one.measured_Hz, one.measured_std_Hz) + " Hz",
               fmt::format("{:.6g} Hz", one.model_Hz), fmt::format("{:+.2f} %", difference_percent(one))});
  }
  return table;
}

}  // namespace percuss::report
