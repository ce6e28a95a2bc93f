#pragma once
#include <cstddef>
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// Per acceleration channel, over the accepted hits: which way it moves first and how long after the force (medians): a
/// sensor mounted the wrong way round, a swapped channel or a recorder that samples channels one after the other shows
/// here. Channels whose hits disagree about the direction are said to. Empty when no response was seen.
std::string responses_text(const pipeline::Analysis& analysis, std::size_t width);

}  // namespace percuss::report
