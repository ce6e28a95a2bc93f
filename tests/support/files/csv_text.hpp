#pragma once
#include <memory>
#include <string>

#include "acquire/formats/text/read_csv.hpp"
#include "core/io/input_file.hpp"

namespace percuss::test {

/// A text as if read from the file x.csv.
inline FileBytes csv_bytes(const std::string& text) {
  const auto kept = std::make_shared<const std::string>(text);
  return {.path = "x.csv", .data = {kept, kept->data()}, .size = kept->size()};
}

inline acquire::Record csv_record(const std::string& text, const acquire::ReadOptions& options = {}) {
  return acquire::open_csv(csv_bytes(text), options);
}

}  // namespace percuss::test
