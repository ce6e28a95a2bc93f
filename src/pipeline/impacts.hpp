#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Whether an impact has a deflection: it has a pulse, or the user accepts it; the user does not reject it. `index`: of
/// the hit.
bool is_usable_impact(const AnalysedHit& hit, const AnalysisOptions& options, std::size_t index);

/// The number of impacts that are left out although the user did not reject them.
std::size_t impacts_without_pulse(const std::vector<AnalysedHit>& impacts, const AnalysisOptions& options);

/// [impacts] The samples in which an acceleration is clipped after each impact, by the tests of grade_by_responses():
/// the largest count of all channels.
std::vector<std::size_t> clipped_samples_of(const acquire::Record& record, std::vector<AnalysedHit> impacts,
                                            std::size_t threads);

/// The record of `analysis` without its force, with a note that says so, where the force channel is idle: at every hit
/// it stays within ten times its noise, while a response moves at one hit or more. A ball strikes without a hammer, and
/// its deflections follow from the accelerations alone. Nothing for other records, and where the user states a trigger.
std::optional<acquire::Record> record_without_idle_force(const Analysis& analysis);

/// The impacts of a record without a force: each row is one. It begins when the first accelerometer begins to move.
std::vector<AnalysedHit> impacts_without_force(const acquire::Record& record);

/// The first sample of the signals of impact `h`, for a structure that rests before it. Where the user states a
/// pre-trigger, it is the hit's first. Otherwise it is the hit's first or earlier: up to 0.1 s before the gate, but not
/// before the last blow's force has ended, nor before the selected time.
std::size_t first_sample_of_impact(const acquire::Record& record, const acquire::HitOptions& options,
                                   const std::vector<AnalysedHit>& impacts, std::size_t h);

/// Whether enough rest precedes each of these `hits` of `impacts` to estimate the bias of the acceleration.
bool rest_recorded(double fs_Hz, const std::vector<AnalysedHit>& impacts, const std::vector<std::size_t>& hits);

}  // namespace percuss::pipeline
