#pragma once
#include <span>
#include <vector>

#include "core/math/fft.hpp"

namespace percuss::frf {

/// Leave-one-out error of each hit: the FRFs of the other hits predict its responses from its force. The result is the
/// residual energy over the response's energy: 0 for a perfect prediction, possibly above 1; zeros for fewer than two
/// hits. At most 1024 evenly spaced lines are compared.
/// shapes  force [hits][lines]; accel [hits][channels][lines]; result [hits].
/// theory (2.9)
std::vector<double> leave_one_out_error(std::span<const std::span<const Complex>> force,
                                        std::span<const std::vector<std::span<const Complex>>> accel);

}  // namespace percuss::frf
