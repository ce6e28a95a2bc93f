#pragma once
#include <cstddef>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/hits/response_grade.hpp"
#include "identify/model/modal_model.hpp"

namespace percuss::pipeline {

/// A hit with everything the analysis found out about it.
struct AnalysedHit {
  acquire::Hit hit;
  int point = 0;
  bool accepted = false;
  bool by_user = false;                           // accepted or rejected by the user's word
  std::vector<acquire::ResponseGrade> responses;  // [channels]; empty when the accelerations were not read
};

/// A mode as one hit alone shows it.
struct HitMode {
  std::size_t hit = 0;
  std::size_t mode = 0;
  identify::Pole pole;
  double freq_std_Hz = 0;
  double damping_std = 0;
};

}  // namespace percuss::pipeline
