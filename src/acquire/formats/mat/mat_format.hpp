#pragma once
#include "acquire/record/file_format.hpp"

namespace percuss::acquire {

extern const FileFormat kMatFormat;

}  // namespace percuss::acquire
