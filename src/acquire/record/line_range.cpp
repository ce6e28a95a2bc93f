#include "acquire/record/line_range.hpp"

#include "acquire/record/frequency_lines.hpp"

namespace percuss::acquire {

std::vector<double> frequencies_Hz(const LineRange& lines) {
  std::vector<double> freq_Hz(lines.count);
  for (std::size_t k = 0; k < lines.count; ++k) freq_Hz[k] = lines.freq_Hz(k);
  return freq_Hz;
}

LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where) {
  return frequency_lines(freq_Hz, 1, where).lines;
}

}  // namespace percuss::acquire
