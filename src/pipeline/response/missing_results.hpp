#pragma once
#include <vector>

#include "core/error.hpp"
#include "pipeline/response/response_test.hpp"

namespace percuss::pipeline {

/// Why a test without a force has no results, or fewer than it could. In no order here:
///   dead_channel   a channel is constant
///   no_modes       no impact, or no mode in the band
///   no_free_decay  no impact can be used
std::vector<Warning> missing_result_warnings(const ResponseTest& test);

/// The reason why the test is not possible(): the message of one of its warnings, empty without one.
Message why_impossible(const ResponseTest& test);

}  // namespace percuss::pipeline
