#pragma once
#include <string>

#include "acquire/formats/uff/read_uff.hpp"
#include "support/files/csv_text.hpp"

namespace percuss::test {

/// The record of a UFF file with this text.
/// errors  InputError as of open_uff
inline acquire::Record opened_uff(const std::string& text, const acquire::ReadOptions& options = {}) {
  return acquire::open_uff(csv_bytes(text), options);
}

}  // namespace percuss::test
