#pragma once
#include <cstddef>
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The strongest FRF at every frequency as a drawing of characters (braille dots), `width` columns wide: levels in dB
/// at the left, the band's ends and the modes' numbers below. Nothing where there is no room for it.
std::string frf_terminal_plot(const pipeline::Analysis& analysis, std::size_t width);

}  // namespace percuss::report
