#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// swapped_channels: most hits show no hammer pulse, while a response shows one, and the force rings after it.
/// no_pulse: neither the force nor a response shows a pulse at any hit. Left out if the user states the trigger level:
/// the findings of the hits then name this level.
/// `options`: the options of the search that found `hits`.
/// errors  InputError: samples that cannot be read.
std::vector<Warning> role_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                   const acquire::HitOptions& options);

}  // namespace percuss::pipeline
