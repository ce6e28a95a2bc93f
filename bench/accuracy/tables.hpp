#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "scaling.hpp"

namespace percuss::accuracy {

/// A table of Markdown. rows [rows][heads]; all columns but the first are to the right.
std::string markdown_table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows);

/// The figures of one case, a row each.
std::string case_table(const Family& family, const Case& one);

/// Every figure of the family, folded away.
std::string all_figures(const Family& family);

/// A row for each size range, with exponents.
std::string scaling_table(const std::vector<Scaling>& scalings);

/// Every point, folded away.
std::string all_scaling(const std::vector<Scaling>& scalings);

}  // namespace percuss::accuracy
