#pragma once
#include <cstddef>
#include <set>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/findings/tones.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/stages/earlier_ringing.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// rejected_hits, hits_disagree, polarity, implausible_force, low_bandwidth. `noisy`: hits whose responses, or the
/// parts of them that the other hits do not explain, are only noise; hits_disagree does not name them.
std::vector<Warning> hit_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                  const PointNames& names, const std::set<std::size_t>& noisy = {});

/// accept_refused: hits that the user accepts, by index or kEveryHit, but that have no pulse. `rejects`: the hits that
/// the user rejects.
std::vector<Warning> refused_hit_warnings(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& accepts,
                                          const std::vector<std::size_t>& rejects);

/// not_at_rest, and earlier_ringing for the ringing that was subtracted. With hum of the mains among the tones,
/// not_at_rest names it as a possible cause.
std::vector<Warning> rest_warnings(const std::vector<AnalysedHit>& hits, const std::vector<EarlierRinging>& ringing,
                                   const std::vector<Tone>& tones);

}  // namespace percuss::pipeline
