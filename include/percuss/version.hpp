#pragma once
/// The version of the library that the program is linked with.
///
/// @code
/// #include <iostream>
/// #include <percuss/version.hpp>
///
/// int main() { std::cout << "percuss " << percuss::version() << '\n'; }
/// @endcode

namespace percuss {

/// "major.minor.patch". Before 1.0 a minor version may change the interface.
const char* version();

}  // namespace percuss
