#pragma once
#include <string_view>

namespace percuss {
inline namespace core {

/// Writes all bytes to a descriptor; repeats interrupted calls. Returns false, with errno set, on failure.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace core
}  // namespace percuss
