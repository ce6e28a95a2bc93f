#pragma once
#include <string>
#include <utility>

#include "frf/spectra.hpp"

namespace percuss::pipeline {

/// Lower end of the default band. Below it drift and the suspension dominate.
double default_low_Hz(double highest_Hz);

/// The band with a margin on both sides for modes just outside it.
std::pair<double, double> band_with_margin(double low_Hz, double high_Hz);

/// errors  InputError at `where`, with the option "band": too few spectral lines in the band to find modes.
void require_lines(const acquire::LineRange& lines, double low_Hz, double high_Hz, const std::string& where,
                   const std::string& remedy);

}  // namespace percuss::pipeline
