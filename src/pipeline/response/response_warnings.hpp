#pragma once
#include <vector>

#include "pipeline/response/response_test.hpp"

namespace percuss::pipeline {

/// The warnings about a test without a force, sorted with the most serious first. In no order here:
///   hammer_as_response  a response looks like the hammer
///   no_force         results that need a force are missing
///   response_clipped, cut_decay, disturbed_decay  the decays are used in part
///   disturbed_decay  also where the motion is no sum of free decays
///   uneven_decay     a mode whose decay is not exponential, or three modes or more that may be such a decay
///   tone             sinusoids that do not decay
///   pair_or_scatter  one mode whose frequency differs between the hits, or two close modes
///   and AnalysisOptions::known, the reader's notes (input_warnings), missing_result_warnings, and object_warnings
/// One remark replaces the reader's notes on units that are not stated, because frequencies and damping ratios do not
/// depend on them.
std::vector<Warning> response_warnings(const ResponseTest& test);

}  // namespace percuss::pipeline
