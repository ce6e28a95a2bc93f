#pragma once
#include <cstddef>

#include "identify/frf_set.hpp"

namespace percuss {

/// The outputs of a large set mixed into few: real orthogonal sums of the outputs over their noise, those that hold
/// what stands out of it. A set of m modes spans m of them, so that next to nothing of what the outputs know of the
/// poles is lost; real residues stay real. The mixed outputs count as answers to one point whose force is without noise
/// and whose records hold the whole decay. No more than `most`.
FrfSet principal_outputs(const FrfSet& set, std::size_t most);

}  // namespace percuss
