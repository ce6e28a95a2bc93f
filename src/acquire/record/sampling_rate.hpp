#pragma once
#include <string_view>

namespace percuss::acquire {

/// fs_Hz, if anything that is hit can ring between its limits, a thousandth of a Hz and a GHz; InputError at `where` if
/// not.
double checked_rate_Hz(double fs_Hz, std::string_view where);

}  // namespace percuss::acquire
