#pragma once
#include <cstddef>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/hits/response_grade.hpp"

namespace percuss::pipeline {

/// A hit, its findings and whether the analysis uses it.
struct AnalysedHit {
  acquire::Hit hit;
  int point = 0;
  bool accepted = false;
  bool by_user = false;                           // the user accepted or rejected this hit
  std::vector<acquire::ResponseGrade> responses;  // [channels]; empty when the accelerations were not read
};

/// Indices of the accepted hits, ascending.
std::vector<std::size_t> accepted_hits(const std::vector<AnalysedHit>& hits);
bool any_accepted(const std::vector<AnalysedHit>& hits);

/// Whether the user may accept a hit despite its findings: it has a pulse of the force, which an FRF needs.
inline bool can_be_accepted(const AnalysedHit& hit) { return !hit.hit.gated_N.empty(); }
/// Whether samples of a hit's pulse, or just beside it, are missing.
bool lacks_samples_of_pulse(const AnalysedHit& hit);
/// Whether a rejected hit can be accepted despite its findings, and its pulse is whole, so that the results hold.
bool can_accept_more(const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
