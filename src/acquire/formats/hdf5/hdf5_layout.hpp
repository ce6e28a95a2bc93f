#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"

namespace percuss::acquire::hdf5 {

/// The dimensions of a record, as the shapes of the force and the accelerations state them.
struct Layout {
  std::size_t rows = 0, channels = 0, samples = 0;
  bool force_has_rows = false;  // false: [samples]
  bool accel_has_rows = false, accel_has_channels = false;
};

/// errors  InputError: a shape is empty or has too many dimensions, or the shapes contradict each other.
Layout layout_of(const InputDataSet& force, const InputDataSet& accel, const InputHdf5& file);
/// As above without a force: two dimensions are [channels, samples].
Layout layout_of(const InputDataSet& accel);

/// "[5, 2, 1000]"
std::string shape_text(std::span<const std::size_t> shape);

}  // namespace percuss::acquire::hdf5
