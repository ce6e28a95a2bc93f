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
std::vector<Warning> truncation_warnings(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                                         double window_decay_per_s, const std::optional<DecayCut>& cut = {});

/// truncated_decay of given FRFs. before_blow_s  time_before_blow_s() of blow_time.hpp.
std::vector<Warning> frf_truncation_warnings(const std::vector<identify::Mode>& modes, const acquire::LineRange& lines,
                                             double window_decay_per_s, const std::optional<double>& before_blow_s);

}  // namespace percuss::pipeline
