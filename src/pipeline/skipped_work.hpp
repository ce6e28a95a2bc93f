#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

/// Work that an analysis did not do.
struct SkippedWork {
  std::string code;             // "silence"
  std::string what;             // "accelerations between the hits"
  std::string why;              // a sentence for people
  std::optional<double> share;  // of the samples or lines of its kind, 0 … 1; absent: all of that stage
};

/// The work that the analysis skipped so far. Computes nothing. Shares under 0.1 % are left out. Codes: channels (only
/// the force was read), rejected, silence, tail, force_zeros, lines, modes, classes, stabilisation, per_hit.
std::vector<SkippedWork> skipped_work(const Analysis& analysis);

}  // namespace percuss::pipeline
