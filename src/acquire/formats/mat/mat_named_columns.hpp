#pragma once

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Turns the columns of a matrix into variables of the names that a list beside it states: texts in the cells or rows
/// of a variable names, labels, channels, …, one per column (`data` with `names`), one of them a force or acceleration.
/// A list of units of the same length states their units. The file is left unchanged if it holds FRFs, if several
/// matrices have this number of columns, if a name is taken, or if the options name the matrix or a column of it
/// ("data(:,2)").
void split_named_columns(MatFile& file, const ReadOptions& options);

}  // namespace percuss::acquire
