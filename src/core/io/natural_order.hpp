#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {
inline namespace core {

/// Whether `a` comes before `b` where numbers in names compare by their value: "hit2.csv" before "hit10.csv".
bool comes_first_naturally(const std::string& a, const std::string& b);

/// The intended order of names, some of which a shell may have expanded from a pattern ("p1 p10 p2"). Neighbours that
/// differ only in whole numbers, and stand in the order of their characters, are put into natural order. Other names
/// keep their places: any other order is the user's choice, and decimal numbers ("p0.25", "p0.5") are in order already.
/// returns  result[i]: the index in `names` of the name that comes i-th.
std::vector<std::size_t> intended_order(const std::vector<std::string>& names);

/// The texts of a name and the runs of digits between them, in turn. The first part is a text, perhaps an empty one.
using NameParts = std::vector<std::string>;
NameParts texts_and_numbers(std::string_view name);

/// The indices of the numbers in which the names differ. Nothing if they differ in a text or in their number of parts.
std::optional<std::set<std::size_t>> differing_numbers(const std::vector<NameParts>& names);

}  // namespace core
}  // namespace percuss
