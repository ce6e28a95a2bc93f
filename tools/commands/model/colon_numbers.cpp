#include "commands/model/colon_numbers.hpp"

#include <algorithm>
#include <string>

#include "cli/option_units.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::tools {

std::optional<std::vector<double>> numbers_between_colons(std::string_view text, std::string_view placeholder) {
  std::vector<double> values;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(':', from), text.size());
    const std::string word(text.substr(from, to - from));
    const bool has_unit = values.empty() && !placeholder.empty();
    const ParsedNumber number = parse_number(has_unit ? in_option_unit(word, placeholder) : word, false);
    if (number.problem != NumberProblem::none) return std::nullopt;
    values.push_back(number.value);
    from = to + 1;
  }
  return values;
}

}  // namespace percuss::tools
