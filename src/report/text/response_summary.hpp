#pragma once
#include <cstddef>
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// For each acceleration channel: the direction of its first motion and its median delay after the force, over the
/// accepted hits. Reveals a sensor mounted the wrong way round, swapped channels, and a recorder that samples channels
/// one after the other. Names channels whose hits show no clear direction, and leaves out those whose points
/// differ. Empty when no channel has a direction.
std::string responses_text(const pipeline::Analysis& analysis, std::size_t width);

}  // namespace percuss::report
