#pragma once
#include <optional>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// The FRFs of a MAT file (docs/reference/formats.md, "MAT"): a complex array [points, channels, lines], [lines, FRFs]
/// or [FRFs, lines]. The dimension as long as the vector of frequencies is frequency, else the longest one. The spacing
/// follows from the vector (frequency_lines()), else is options.read.df_Hz, else df in the file, else follows from the
/// sampling rate (the last line is at half of it). Returns nothing if the file holds no such array. Also returns
/// nothing if the file holds longer arrays that could be a time record, unless the FRFs are named or options.kind is
/// set.
/// errors  AmbiguousColumns: several arrays could be the FRFs (options.read.accel_channels names one), or there are no
/// frequencies.
std::optional<StoredFrfs> read_frf_mat(const MatFile& file, const FrfReadOptions& options);

}  // namespace percuss::acquire
