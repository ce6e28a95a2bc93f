#pragma once
#include <cstddef>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The spectral lines first … first + count − 1 of all FRFs and of their forces.
FrfDataset lines_of(const FrfDataset& set, std::size_t first, std::size_t count);

}  // namespace percuss::identify
