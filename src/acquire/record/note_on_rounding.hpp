#pragma once
#include <string>

#include "core/error.hpp"

namespace percuss::acquire {

/// `text` says that a sampling rate or a spacing was rounded in the file, and which one was taken. The note adds by how
/// much all frequencies may be off. Below 100 ppm, which the clocks of recorders reach as well, it is information.
/// largest_error  of the rate or the spacing, relative
/// option         states the exact value
Message note_on_rounding(const std::string& text, double largest_error, const OptionId& option);

}  // namespace percuss::acquire
