#pragma once
#include <string>
#include <utility>

#include "frf/spectra.hpp"

namespace percuss::pipeline {

/// Where a band begins whose user names none: below it drift and the suspension rule.
double default_low_Hz(double highest_Hz);

/// The band, and on either side what it takes to see the modes just outside it.
std::pair<double, double> band_with_margin(double low_Hz, double high_Hz);

/// errors  InputError at `where`: fewer lines in the band than modes can be found in.
void require_lines(const frf::LineRange& lines, double low_Hz, double high_Hz, const std::string& where,
                   const std::string& remedy);

}  // namespace percuss::pipeline
