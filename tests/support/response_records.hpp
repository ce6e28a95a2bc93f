#pragma once
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::test {

/// A record without a force. accel [rows][channels][samples] gets noise of the standard deviation `noise`.
acquire::Record response_record(double fs_Hz, std::vector<std::vector<std::vector<double>>> accel, double noise,
                                bool continuous);

}  // namespace percuss::test
