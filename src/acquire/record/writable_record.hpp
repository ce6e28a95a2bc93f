#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// errors  InputError at `path`: the record has no hit or no acceleration to write.
void require_contents(const Record& record, const std::string& path);

/// For formats that store all hits in one matrix. errors  InputError at `path`: as require_contents; hits differ in
/// length.
void require_equal_lengths(const Record& record, const std::string& path);

}  // namespace percuss::acquire
