#pragma once
#include <string>
#include <vector>

#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// What leaving something out saves: one test from its file to a result, with it and without.
struct Saving {
  std::string what;   // is left out
  std::string when;   // … and why that loses nothing, or who says so
  double with_s = 0;  // processor time
  double without_s = 0;
  double factor() const { return with_s / without_s; }
};

std::vector<Saving> study_skips(Extent extent, const TimingOptions& turns);

}  // namespace percuss::accuracy
