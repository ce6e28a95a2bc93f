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

}  // namespace percuss::pipeline
