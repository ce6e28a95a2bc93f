#pragma once
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss {

/// What a page says of how it came about; nothing else on it depends on when and where.
struct Provenance {
  std::string command;  // the command line
  std::string made_at;  // UTC, "2026-11-22 21:45"
};

/// The analysis as a page of one file: what was found in a sentence, the modes with their deviations, warnings, then
/// FRFs, hits, the stabilisation diagram and the barrel's movement as pictures, and how it came about.
std::string analysis_page(const Analysis& analysis, const Provenance& provenance);

}  // namespace percuss
