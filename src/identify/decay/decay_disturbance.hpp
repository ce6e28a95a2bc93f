#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/decay/decay_start.hpp"

namespace percuss::identify {

/// Where the motion after a hit is no free decay: another blow, a knock, a contact. There the residual of the fit rises
/// far above the noise. The residual's prediction errors (noise_prediction()) are white without a disturbance. In the
/// first disturbed block of 10 ms (at least 64 samples), their mean square exceeds ten times the smallest of up to four
/// blocks before it, and ten times the median of all blocks, in one channel or more.
/// result [hits]: the first sample of that block, from the first sample of `whole`; nothing without a disturbance.
std::vector<std::optional<std::size_t>> decay_disturbances(const FreeDecays& whole, const StartedFit& fit);

}  // namespace percuss::identify
