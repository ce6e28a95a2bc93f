#pragma once

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Turns the columns of a matrix into variables, named by a list beside it (`data` with `names`). The list is a
/// variable called names, labels, channels, … whose cells or rows hold one text per column; one of the texts names a
/// force or an acceleration. A list of units of the same length states their units. The file is left unchanged if it
/// holds FRFs, if several matrices have this number of columns, if a name is taken, or if the options name the matrix
/// or a column of it ("data(:,2)").
void split_named_columns(MatFile& file, const ReadOptions& options);

}  // namespace percuss::acquire
