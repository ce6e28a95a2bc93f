#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/math/fft.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// Fewer hits of a point cannot outvote an outlier.
inline constexpr std::size_t kMinHitsToFindOutlier = 4;

/// Spectra of one hit, [lines]; empty for hits that are not compared.
struct ComparedHit {
  std::span<const Complex> force;
  std::vector<std::span<const Complex>> accel;  // [channels]
};

/// Spectra of the accepted hits, [hits]; refers to `force` and `responses`.
std::vector<ComparedHit> spectra_of_hits(const std::vector<AnalysedHit>& hits, const std::vector<frf::Spectrum>& force,
                                         const HitResponses& responses, std::size_t lines);

/// Whether the hits of one point come from several files that may be tests of their own. In a survey, files that hold
/// only this point are parts of one test. of_point: indices of the point's hits
bool may_be_several_tests(const std::vector<acquire::RowInfo>& rows, const std::vector<AnalysedHit>& hits,
                          const std::vector<std::size_t>& of_point);

/// Compares the accepted hits of each point with one another. Adds `outlier` where one hit disagrees with the others
/// far more than they do among themselves, and rejects this hit unless the user accepted it. Adds `low_coherence` where
/// the others explain less than 90 % of a hit's response. `rows` are the record's; they tell whether the hits of a
/// point may be several tests.
void grade_agreement(std::vector<AnalysedHit>& hits, const std::vector<ComparedHit>& spectra,
                     const std::vector<acquire::RowInfo>& rows = {});

/// Takes a vote of each point's accepted hits on the direction in which a channel first moves, relative to the push.
/// Outvoted hits lose their `polarity` and `delay_s`; all hits do when more than a fifth of them disagree, or
/// when more than half of the hits show no clear direction.
void vote_first_motion(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
