#pragma once
#include <string_view>

namespace percuss::acquire {

/// Returns fs_Hz.
/// errors  InputError at `where`: fs_Hz is not between 1e-3 and 1e9 Hz.
double checked_rate_Hz(double fs_Hz, std::string_view where);

}  // namespace percuss::acquire
