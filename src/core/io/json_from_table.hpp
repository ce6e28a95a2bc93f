#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/io/strict_json.hpp"

namespace percuss {
inline namespace core {

/// The text from which StrictObjects are read, for messages. A table adds the line number of each row of the list
/// `rows`.
struct StrictSource {
  std::string where, remedy;
  std::vector<OptionId> options{};
  std::string rows{};                         // name of the list of rows
  std::vector<std::size_t> lines{};           // [rows] line numbers
  bool table = false, decimal_comma = false;  // all values are texts; numbers may have a decimal comma
};

/// A table as a JSON document in which every value is text. Adds to `source` what messages need.
/// errors  as read_strict_table
std::string json_from_table(const JsonText& input, StrictSource& source);

}  // namespace core
}  // namespace percuss
