#pragma once
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// Takes the time or frequency out of matrices that hold it in their first column (or row): [t x], [t x y …], [f H].
/// The abscissa becomes a variable "NAME.t" or "NAME.f", and the matrix loses the column. [f re im] of a variable that
/// is named as an FRF becomes complex. A first column stays if it does not rise evenly, if it counts by 1 and the rest
/// is no FRF, or if the matrix has fewer than 16 lines or more than 256 columns.
void split_abscissas(MatFile& file);

}  // namespace percuss::acquire
