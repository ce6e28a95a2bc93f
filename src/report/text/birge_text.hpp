#pragma once
#include <cstddef>
#include <string>

namespace percuss::report {

/// A line that says by how much the standard deviations of a fit were enlarged (core::birge_ratio), and why; empty
/// where they were not.
std::string birge_text(double chi2, std::size_t degrees);

}  // namespace percuss::report
