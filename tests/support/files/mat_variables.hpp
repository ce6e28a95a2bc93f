#pragma once
#include <string>
#include <vector>

#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::test {

// Variables of a MAT file as the reader returns them, and MAT files of such variables that exist in memory only.

inline acquire::MatVariable mat_numbers(const std::string& name, const std::vector<std::size_t>& shape,
                                        const std::vector<double>& real) {
  return {.name = name, .shape = shape, .real = real};
}

inline acquire::MatVariable mat_text(const std::string& name, const std::string& content) {
  return {.name = name, .shape = {1, content.size()}, .text = content, .is_text = true};
}

inline acquire::MatFile mat_file_of(const std::vector<acquire::MatVariable>& variables) {
  return {.path = "x.mat", .bytes = 1000, .variables = variables};
}

/// The same with a further variable, the sampling rate fs = 1000 Hz.
inline acquire::MatFile mat_record_of(const std::vector<acquire::MatVariable>& variables) {
  acquire::MatFile file = mat_file_of(variables);
  file.variables.push_back(mat_numbers("fs", {1, 1}, {1000}));
  return file;
}

}  // namespace percuss::test
