#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// swapped_channels: no hit shows a hammer pulse, but a response does.
/// errors  InputError: samples that cannot be read.
std::vector<Warning> role_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
