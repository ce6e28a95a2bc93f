#pragma once
#include <cstddef>

#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// The sizes and strides of an array of FRFs.
struct MatFrfLayout {
  std::size_t points = 1, channels = 1, lines = 0;
  std::size_t point_stride = 0, channel_stride = 0, line_stride = 1;
  std::size_t at(std::size_t point, std::size_t channel, std::size_t line) const {
    return point * point_stride + channel * channel_stride + line * line_stride;
  }
};

/// The dimension of the lines is as long as the vector of frequencies. If several dimensions fit, it is the third one
/// if that fits, otherwise the first. If none fits, it is the longest. The other dimensions are points, then channels.
MatFrfLayout frf_layout(const MatVariable& variable, std::size_t frequencies);

}  // namespace percuss::acquire
