#pragma once
#include "acquire/record/file_format.hpp"

namespace percuss::acquire {

extern const FileFormat kLvmFormat;
/// Columns of numbers. It detects every input and is therefore the registry's last entry.
extern const FileFormat kTextFormat;

}  // namespace percuss::acquire
