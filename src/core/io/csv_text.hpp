#pragma once
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

/// `text` as UTF-8: unchanged if it is valid, otherwise converted from Latin-1.
std::string to_utf8(std::string_view text);

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

}  // namespace core
}  // namespace percuss
