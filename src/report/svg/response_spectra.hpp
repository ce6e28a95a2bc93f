#pragma once
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// The name of a channel; "channel 2" for one without a name.
std::string channel_label(const pipeline::ResponseTest& test, std::size_t channel);

/// For each channel, up to six: the spectrum (magnitude) of the free decays over the band, and the spectrum of the
/// fitted modes and tones; RMS over the accepted hits, in dB re the largest measured line. Empty without a mode.
std::vector<LineChart> response_spectra(const pipeline::ResponseTest& test);

}  // namespace percuss::report
