#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/text/text_table.hpp"

namespace percuss::report {

/// The fit of a model to measured frequencies, for a document and for the terminal.
struct FrequencyFit {
  struct Frequency {
    std::size_t mode = 0;
    double measured_Hz = 0;
    double measured_std_Hz = 0;  // 0: unknown, then for all frequencies
    double model_Hz = 0;
  };
  std::vector<Frequency> frequencies;  // empty: nothing was fitted
  std::size_t parameters = 0;          // fitted ones
  double chi2 = 0;
};

/// [{mode, measured_hz, measured_std_hz, model_hz, difference_percent}].
nlohmann::ordered_json frequencies_json(const FrequencyFit& fit);

/// Adds "birge_ratio" if the standard deviations of the parameters follow from those of the frequencies.
void add_birge_ratio(const FrequencyFit& fit, nlohmann::ordered_json& json);

/// birge_text() in the same case, otherwise empty.
std::string birge_text(const FrequencyFit& fit);

/// Mode, measured and modelled frequency, and their difference.
TextTable frequency_table(const FrequencyFit& fit);

}  // namespace percuss::report
