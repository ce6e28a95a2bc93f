#pragma once
#include <cstddef>
#include <string>

namespace percuss::report {

/// A line that says by how much birge_ratio() enlarged the standard deviations of a fit, and why; empty if it did not.
/// degrees  of freedom
std::string birge_text(double chi2, std::size_t degrees);

}  // namespace percuss::report
