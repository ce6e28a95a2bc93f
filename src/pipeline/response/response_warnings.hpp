#pragma once
#include <vector>

#include "pipeline/response/response_test.hpp"

namespace percuss::pipeline {

/// The warnings about a test without a force, most serious first:
///   no_force         results that need a force are missing
///   no_free_decay    no impact can be used
///   tone             sinusoids that do not decay
///   and the options' known warnings, the notes of the reading as input, and object_warnings
std::vector<Warning> response_warnings(const ResponseTest& test);

}  // namespace percuss::pipeline
