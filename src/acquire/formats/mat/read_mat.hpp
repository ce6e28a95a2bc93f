#pragma once
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The time record in a MAT file (docs/reference/formats.md, "MAT"). The force and the accelerations are variables,
/// by name, by options or by the set-up: vectors [samples], matrices [hits, samples] or the other way round (the longer
/// dimension is time), accelerations also [hits, channels, samples] or [samples, channels, hits].
/// errors  AmbiguousColumns: the roles are unclear, so that an option must name variables of its list. InputError:
/// sizes contradict each other, no rate.
Record open_mat(MatFile file, const ReadOptions& options = {});

}  // namespace percuss::acquire
