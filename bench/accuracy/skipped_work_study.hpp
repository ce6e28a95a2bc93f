#pragma once
#include <string>
#include <vector>

#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// The saving of skipped work: the time of one test from its file to a result, with that work and without.
struct Saving {
  std::string what;   // the skipped work
  std::string when;   // the condition or the option, and the reason
  double with_s = 0;  // processor time
  double without_s = 0;
  double factor() const { return with_s / without_s; }
};

std::vector<Saving> study_skips(Extent extent, const TimingOptions& timing);

}  // namespace percuss::accuracy
