#pragma once
#include <string_view>

namespace percuss {
inline namespace core {

/// Writes all bytes to a descriptor; goes on after signals. False with errno where it cannot.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace core
}  // namespace percuss
