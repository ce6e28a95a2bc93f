#pragma once
#include <string>
#include <utility>

#include "frf/spectra.hpp"

namespace percuss::pipeline {

/// Lower end of the default band. Below it drift and the suspension dominate.
double default_low_Hz(double highest_Hz);

/// The band with a margin on both sides for modes just outside it.
std::pair<double, double> band_with_margin(double low_Hz, double high_Hz);

/// errors  InputError: the band is empty, begins below 0 Hz, or ends above half the sampling rate. Where the rate is
/// implausible for a hammer test (below 1 kHz, or half of it below the whole band), the message doubts the rate, not
/// the band.
void require_band(std::pair<double, double> band_Hz, double fs_Hz, const std::string& where);

/// errors  InputError at `where`, with the option "band": too few spectral lines in the band to find modes. Above 1 MHz
/// the message doubts the sampling rate, with the option "fs".
void require_lines(const acquire::LineRange& lines, double low_Hz, double high_Hz, const std::string& where,
                   const std::string& remedy);

}  // namespace percuss::pipeline
