#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// The FRFs of a MAT file (docs/reference/formats.md, "MAT"): a complex array [points, channels, lines], [lines, FRFs]
/// or [FRFs, lines] (the longest dimension is frequency), with a vector of frequencies, a spacing (df), or
/// options.df_Hz. Nothing when the file holds no such array, or also longer arrays that could be a record of time
/// (options.kind selects the FRFs).
/// errors  AmbiguousColumns: several arrays could be the FRFs (options.read.accel_channels names one), or there are no
/// frequencies.
std::optional<StoredFrfs> read_frf_mat(const MatFile& file, const FrfReadOptions& options);

}  // namespace percuss::acquire
