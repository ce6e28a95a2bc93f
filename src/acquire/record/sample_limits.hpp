#pragma once

namespace percuss::acquire {

/// The largest plausible sample, in N or m/s². Larger numbers mark gaps (instruments write 9.91e37) or come from
/// damaged files; their squares could overflow.
constexpr double kMaxSample = 1e30;

}  // namespace percuss::acquire
