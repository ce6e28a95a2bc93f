#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// swapped_channels: most hits show no hammer pulse, while a response shows one, and the force rings after it.
/// no_pulse: no hit shows a pulse, and no response shows one either. Not where the user states the trigger level, which
/// the findings of the hits name.
/// `options`: those of the search that found `hits`.
/// errors  InputError: samples that cannot be read.
std::vector<Warning> role_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                   const acquire::HitOptions& options);

}  // namespace percuss::pipeline
