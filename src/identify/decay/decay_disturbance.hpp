#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/decay/decay_start.hpp"

namespace percuss::identify {

/// Where the motion after a hit is no free decay: another blow, a knock, a contact. There the residual of the fit rises
/// far above the noise. The residual's prediction errors (noise_prediction()) are white without a disturbance. They are
/// squared and averaged in blocks of 10 ms (at least 64 samples). A block is disturbed if, in one channel or more, its
/// mean square exceeds two limits: ten times the smallest of up to four blocks before it, and ten times the median of
/// all blocks.
/// result [hits]: the first sample of the first disturbed block, from the first sample of `whole`; nothing without one.
std::vector<std::optional<std::size_t>> decay_disturbances(const FreeDecays& whole, const StartedFit& fit);

}  // namespace percuss::identify
