#pragma once
#include <cstddef>
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The strongest FRF at each frequency, plotted with braille characters, `width` columns wide: levels in dB at the
/// left, the band's ends and the modes' numbers below. Empty when `width` is too small.
std::string frf_terminal_plot(const pipeline::Analysis& analysis, std::size_t width);

}  // namespace percuss::report
