#include "acquire/record/line_range.hpp"

#include "acquire/record/frequency_lines.hpp"

namespace percuss::acquire {

LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where) {
  return frequency_lines(freq_Hz, 1, where).lines;
}

}  // namespace percuss::acquire
