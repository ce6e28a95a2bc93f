#pragma once
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Removes the modes that are remainders of hum: narrower than a spectral line, at a harmonic of a tone of the mains,
/// and with a coherence so small that it may come from chance, if the phases at the hits are independent. The removal
/// of a harmonic from responses with noise leaves such a remainder, because the harmonic's frequency has an error.
/// theory (1.10)
void remove_mains_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                        const acquire::LineRange& lines, const std::vector<acquire::PointFrf>& frfs);

}  // namespace percuss::pipeline
