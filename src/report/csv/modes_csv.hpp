#pragma once
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The modes as CSV, a line per mode, point and channel: mode, frequency_hz, frequency_std_hz, damping_ratio,
/// damping_ratio_std, family, order (empty if unknown), point, channel, residue_re, residue_im, residue_std (in 1/kg).
/// Several tests: a first column `test`, and a last column `file`, the path of the test's first file, with "and 3 more"
/// for further files. A test without usable hits has no lines.
std::string modes_csv(const std::vector<NumberedAnalysis>& tests);

/// The same for tests without a force. Their residues are ratios to the reference channel, without a unit. The tests
/// count from 0.
std::string modes_csv(const std::vector<pipeline::ResponseTest>& tests);

}  // namespace percuss::report
