#pragma once
#include <optional>
#include <vector>

#include "identify/frf_set.hpp"
#include "identify/mode.hpp"

namespace percuss {

/// How much work goes into the modes; docs/accuracy.md gives the run time and the error of each.
enum class Effort {
  quick,     // peaks, each fitted over its own window
  standard,  // … also modes that show no peak of their own: close pairs, weak ones
  best,      // … and all of them together at the statistical limit
};
const char* name_of(Effort effort);

struct IdentifyOptions {
  Effort effort = Effort::best;
  std::optional<std::size_t> modes;  // keep this many, the most significant ones
  std::vector<double> start_Hz;      // these and no others
};

/// The modes of a set of FRFs with one standard deviation on everything, in ascending frequency.
std::vector<Mode> identify_modes(const FrfSet& set, const IdentifyOptions& options = {});

}  // namespace percuss
