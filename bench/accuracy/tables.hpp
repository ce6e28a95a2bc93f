#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "scaling.hpp"

namespace percuss::accuracy {

/// A Markdown table with all columns but the first right-aligned. Each row has one cell per head.
std::string markdown_table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows);

/// A table of the figures of one case.
std::string case_table(const TaskFigures& task, const Case& one);

/// A collapsed table of every figure of the task.
std::string all_figures(const TaskFigures& task);

/// A table of each size range, with exponents.
std::string scaling_table(const std::vector<Scaling>& scalings);

/// A collapsed table of every point.
std::string all_scaling(const std::vector<Scaling>& scalings);

}  // namespace percuss::accuracy
