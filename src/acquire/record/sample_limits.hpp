#pragma once

namespace percuss::acquire {

/// No sensor says more, in N or m/s²: larger numbers mark gaps (instruments write 9.91e37) or come from damaged files,
/// and their squares would run over.
constexpr double kMaxSample = 1e30;

}  // namespace percuss::acquire
