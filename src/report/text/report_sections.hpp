#pragma once
#include <set>
#include <string>
#include <vector>

namespace percuss {

/// Parts of an analysis that a report can hold; naming them is the demand that computes them.
enum class Section { hits, frf, coherence, modes, classes, deflection };

/// The sections named in a list such as {"hits", "modes"}; UsageError names the known ones.
std::set<Section> parse_sections(const std::vector<std::string>& names);
/// All but the deflection, which is a question of its own.
std::set<Section> all_sections();

}  // namespace percuss
