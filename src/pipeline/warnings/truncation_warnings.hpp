#pragma once
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// short_pretrigger: a row begins within the ringing of the anti-alias filter before its pulse, and the noise is low
/// enough for that to matter.
std::vector<Warning> pretrigger_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                         const identify::FrfDataset& set);

/// truncated_decay: modes that still rang when the samples ended, or where the transforms end before them.
/// `force_known`: false where the input is FRFs.
std::vector<Warning> truncation_warnings(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                                         double window_decay_per_s, bool force_known,
                                         const std::optional<DecayCut>& cut = {});

}  // namespace percuss::pipeline
