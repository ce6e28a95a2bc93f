#pragma once
#include <optional>
#include <vector>

#include "identify/frf_set.hpp"
#include "identify/mode.hpp"

namespace percuss {

/// How much work goes into the modes. Run times are those of a whole analysis of five hits with a close pair, over that
/// of bare transforms of the same records; errors those of frequencies, over the Cramér–Rao bound.
enum class Effort {
  quick,     // each mode over its own lines; close pairs and hidden modes are looked for in three rounds: 12 times, 1.7
  standard,  // … in as many as it takes: no different where there are few
  best,      // … and all of them together: 32 times, 1.0
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
