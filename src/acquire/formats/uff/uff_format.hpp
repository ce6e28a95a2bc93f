#pragma once
#include "acquire/record/file_format.hpp"

namespace percuss::acquire {

extern const FileFormat kUffFormat;

}  // namespace percuss::acquire
