#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace percuss::acquire {

/// Words, in lower case, by which columns of files are recognised.
using Words = std::span<const std::string_view>;

inline constexpr std::array<std::string_view, 10> kTimeWords{
    "time", "t", "times", "timestamp", "time stamp", "elapsed", "elapsed time", "x_value", "zeit", "temps"};
inline constexpr std::array<std::string_view, 13> kCountWords{
    "index", "sample", "samples", "n", "no", "no.", "nr", "nr.", "#", "i", "row", "line", "point no"};
inline constexpr std::array<std::string_view, 4> kForceWords{"force", "hammer", "impact", "kraft"};
inline constexpr std::array<std::string_view, 2> kAccelWords{"acc", "beschl"};

/// Whether the name, in lower case, is one of the words.
bool is_one_of(const std::string& name, Words words);
/// Whether the name, in lower case, contains one of the words.
bool has_one_of(const std::string& name, Words words);

/// Force or acceleration, by the words in a name in any letter case; nothing without such a word.
std::optional<Quantity> quantity_named(std::string_view name);

/// Whether the name, in lower case, stands for a spectrum or correlation other than an FRF.
bool is_other_spectrum(const std::string& name);

}  // namespace percuss::acquire
