#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Faults while the record was captured: `capture_lost_samples`, `capture_clock`, `capture_ended`. The capture rejected
/// the blows concerned.
std::vector<Warning> capture_warnings(const acquire::Record& record);

}  // namespace percuss::pipeline
