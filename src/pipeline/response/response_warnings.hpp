#pragma once
#include <vector>

#include "pipeline/response/response_test.hpp"

namespace percuss::pipeline {

/// The warnings about a test without a force, most serious first:
///   no_force         what cannot be had without a force
///   no_free_decay    no impact can be used
///   tone             sinusoids that do not decay
///   and the notes of the reading, as input
std::vector<Warning> response_warnings(const ResponseTest& test);

}  // namespace percuss::pipeline
