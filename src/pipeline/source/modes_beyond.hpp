#pragma once
#include <span>
#include <utility>
#include <vector>

#include "acquire/record/line_range.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// Where spectral lines that would end at `end_Hz` should end, so that no strong mode just beyond them is known by its
/// flank only: the residual terms of a fit do not follow a flank that rises towards the end. A peak counts if it lies
/// less than its half-power bandwidth below the end, or up to a tenth of the band's width beyond it, reaches a fifth of
/// the largest amplitude of the band, and stands out of the other lines. The lines then end five bandwidths beyond it;
/// further peaks may follow. `end_Hz` without such a peak.
/// power  [lines.count] squared magnitude of the FRFs, over all channels.
/// lines  from the band to the highest possible end.
double end_past_modes(double end_Hz, std::pair<double, double> band_Hz, const acquire::LineRange& lines,
                      std::span<const double> power);

/// The highest end that end_past_modes() may take.
double furthest_end_Hz(double end_Hz, std::pair<double, double> band_Hz);

/// [lines.count] squared magnitude of the FRFs of a few accepted hits, of different points where there are several.
/// A force more than 20 dB below its largest line counts as 20 dB below it.
std::vector<double> response_power(const std::vector<AnalysedHit>& hits, const HitResponses& responses,
                                   const TransformOptions& options);

/// Removes the lines beyond end_past_modes() from the spectra of `responses`, and returns the remaining lines.
acquire::LineRange end_spectra_past_modes(HitResponses& responses, const std::vector<AnalysedHit>& hits,
                                          std::pair<double, double> band_Hz, double end_Hz,
                                          const TransformOptions& options);

}  // namespace percuss::pipeline
