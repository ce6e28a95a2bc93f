#pragma once
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_function.hpp"

namespace percuss::acquire {

/// Functions of one row; the first is the force where one is known.
using UffRow = std::vector<const UffFunction*>;

/// Groups time records that were sampled together. `is_force[i]` belongs to functions[i]. Uses the first order that
/// fits:
///   each force begins a row;
///   each force ends a row;
///   each force has a row; of the responses with the same degree of freedom and quantity, the k-th belongs to the k-th
///   force.
/// Without forces all functions are one row.
/// errors  InputError: the responses do not divide evenly among the forces, lengths differ within a row, or steps
/// differ between any two functions.
std::vector<UffRow> uff_rows(const std::vector<const UffFunction*>& functions, const std::vector<bool>& is_force,
                             const std::string& file);

}  // namespace percuss::acquire
