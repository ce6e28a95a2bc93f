#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/io/strict_json.hpp"

namespace percuss::inline core {

/// The text that StrictObjects stand in; for a table, also which line each row of the list `rows` is.
struct StrictSource {
  std::string where, example;
  std::string rows{};
  std::vector<std::size_t> lines{};
  bool table = false, decimal_comma = false;  // values are texts, and numbers in them may be written so
};

/// A table as a JSON document in which every value is a text; adds to `source` what messages need. InputError as
/// read_strict_table.
std::string json_from_table(const StrictText& input, StrictSource& source);

}  // namespace percuss::inline core
