#pragma once
#include <cstddef>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// An impact that the responses alone show.
struct ResponseImpact {
  std::size_t row = 0;
  std::size_t first = 0;    // sample of the row at which the structure begins to move
  std::size_t end = 0;      // one past the last sample: just before the next impact, or the end of the selected time
  bool whole_pulse = true;  // false: the row begins after the impact, or has no impact
  bool quiet = false;       // only without a whole pulse: nothing in the row stands out of the noise
};

/// The impacts of a record without a force, row by row. At an impact, the power of the difference between successive
/// samples (or means of samples), summed over the channels, rises within 1.5 ms above ten times its largest value in
/// the 20 ms before. If a row has no such rise, the power of the responses is searched instead. The differences are
/// also searched in blocks 4 and 16 times as long, in which a weak blow stands out of the noise. A row without any rise
/// may begin within a decay. It is quiet if the power of its longest blocks nowhere exceeds ten times their 20 %
/// quantile. A constant row has no impact.
/// errors  InputError: no samples in the selected time.
std::vector<ResponseImpact> response_impacts(const acquire::Record& record, const acquire::HitOptions& options);

}  // namespace percuss::pipeline
