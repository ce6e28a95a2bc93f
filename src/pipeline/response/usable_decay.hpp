#pragma once
#include <cstddef>

#include "acquire/record/record.hpp"
#include "pipeline/response/response_impacts.hpp"

namespace percuss::pipeline {

/// The part of the motion after an impact that a recorder kept as it was.
struct UsableDecay {
  std::size_t first = 0, end = 0;  // samples of the row: first … end − 1
  bool clipped = false;            // the samples before `first` reach a limit of the recorder (clipping.hpp)
  bool gated = false;              // from `end` on, the samples are constant though the motion had not died out
};

UsableDecay usable_decay(const acquire::Record& record, const ResponseImpact& impact);

}  // namespace percuss::pipeline
