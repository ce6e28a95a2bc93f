#pragma once
#include <cstddef>

#include "core/warning.hpp"

namespace percuss::pipeline {

using warnings::Warning;
using warnings::with_remedy;

/// Bytes of a channel's name that a warning quotes.
inline constexpr std::size_t kMaxNameBytes = 40;

}  // namespace percuss::pipeline
