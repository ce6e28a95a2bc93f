#pragma once
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The time record in a MAT file (docs/reference/formats.md, "MAT"). Options, set-up or names determine which variables
/// are the force and the accelerations. A variable is a vector [samples], or a matrix [hits, samples] or [samples,
/// hits] whose longer dimension is time. Accelerations may also be [hits, channels, samples] or [samples, channels,
/// hits]. For a single hit, a matrix of accelerations is [channels, samples] or [samples, channels].
/// errors  AmbiguousColumns: the roles are unclear; an option must name variables of the error's list. InputError:
/// sizes contradict each other, no rate.
Record open_mat(MatFile file, const ReadOptions& options = {});

}  // namespace percuss::acquire
