#include "metrics/study/batch_columns.hpp"

namespace percuss::metrics {

const std::vector<std::string>& batch_columns() {
  static const std::vector<std::string> columns{
      "row", "id", "path", "run",
      // of a record
      "bytes", "code", "reason", "fs_hz", "band_low_hz", "band_high_hz", "hits_accepted", "hits_rejected", "modes",
      "findings", "warnings",
      // of a mode
      "index", "frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std", "family", "order",
      "confidence", "alternative", "overlay_difference_db", "overlaid", "ratio_re", "ratio_im", "ratio_std",
      "double_peak_partner", "double_peak_separation_hz", "double_peak_first"};
  return columns;
}

}  // namespace percuss::metrics
