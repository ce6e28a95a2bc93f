#pragma once
#include <span>
#include <vector>

#include "core/math/fft.hpp"

namespace percuss::frf {

/// How well each hit's responses follow from its force by the FRFs of the other hits (leave one out): the part of its
/// energy that they leave unexplained, 0 … 1 and above. shapes  force [hits][lines]; accel [hits][channels][lines];
/// result [hits]. Fewer than two hits: zeros.
/// theory (2.9)
std::vector<double> leave_one_out_error(std::span<const std::span<const Complex>> force,
                                        std::span<const std::vector<std::span<const Complex>>> accel);

}  // namespace percuss::frf
