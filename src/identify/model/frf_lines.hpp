#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The spectral lines first … first + count − 1 of all FRFs and of their forces.
FrfDataset lines_of(const FrfDataset& set, std::size_t first, std::size_t count);

/// One point with its FRF channels, whose values stay empty: for fits that take the data of their window.
struct PointSet {
  FrfDataset set;
  std::vector<std::size_t> channels;  // indices into the whole set
};
PointSet set_of_point(const FrfDataset& all, std::size_t point);

}  // namespace percuss::identify
