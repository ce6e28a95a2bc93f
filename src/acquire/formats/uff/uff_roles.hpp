#pragma once
#include <optional>
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_function.hpp"
#include "acquire/record/record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

/// Force or acceleration, by the unit, else by the type of data, else (types 0 and 1) by a word in the axis label;
/// nothing for other quantities.
std::optional<Quantity> quantity_of_axis(const UffAxis& axis);

/// Whether each time record is a force, [functions]. The first of these rules that finds a force applies:
///   the name that the options or the set-up give, in any letter case;
///   the axis (quantity_of_axis);
///   a word for a force in the name of functions without a quantity, if all these functions have the same name.
std::vector<bool> force_functions(const std::vector<const UffFunction*>& functions, const ReadOptions& options);

/// The options with the names of functions in place of their numbers. Rows are made from the names of the forces, so a
/// force given by its number needs its name first. Changes nothing if a unit or a type states the forces, for a single
/// row, or if the name of the numbered force does not occur once per row.
ReadOptions with_names(const ReadOptions& options, const std::vector<const UffFunction*>& functions);

/// Names unnamed responses by the first ID line of their functions, if these lines name signals: all functions of one
/// node and direction have the same line, and no two nodes or directions share a line.
void name_by_id_lines(const std::vector<UffFunction*>& functions);

/// The name of a degree of freedom: "force", "accel 1"; if it is unnamed, its node and direction: "12+Z".
std::string uff_dof_name(const UffDof& dof);

}  // namespace percuss::acquire
