#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Whether the file starts as an HDF5 file does (signature at byte 0, 512, 1024, 2048 …). Nothing else of it is read; a
/// path that cannot be opened is not HDF5.
bool is_hdf5(const std::string& path);

/// Opens a record in percuss's own HDF5 layout (docs/reference/formats.md) and describes it. Samples are read by
/// hyperslab when asked for: what nobody asks for is not read. The file stays open while the record or a copy of it
/// lives. shapes /force [hits, samples] or [samples]; /accel [hits, channels, samples] or one dimension fewer. units as
/// the attribute unit_str says (absent: N and m/s²), or as `options` say: those win, the command line's own over a
/// set-up's. errors  InputError, one line with file and data set, for whatever is missing, damaged or contradictory;
/// the record's read
///         functions throw it for samples that are not finite and for storage that cannot be decoded.
Record open_hdf5(const std::string& path, const ReadOptions& options = {});

}  // namespace percuss::acquire
