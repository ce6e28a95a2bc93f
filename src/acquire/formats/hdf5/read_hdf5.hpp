#pragma once
#include <string>
#include <string_view>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

inline constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1a\n";

/// Whether the file has the signature of HDF5 (at byte 0, 512, 1024, 2048 …). Reads nothing else. False for a path that
/// cannot be opened.
bool is_hdf5(const std::string& path);

/// Opens a record in percuss's own HDF5 layout (docs/reference/formats.md) and describes it. Samples are read by
/// hyperslab, on request. The file stays open during the lifetime of the record and its copies.
/// shapes  /force [hits, samples] or [samples]; /accel [hits, channels, samples], or fewer dimensions for one hit or
/// one channel. options.force_channel and options.accel_channels may name other data sets by their paths.
/// units   as the attribute unit_str states (absent: N and m/s²). The set-up overrides the file, and explicit options
/// override the set-up.
/// errors  InputError with file and data set: missing, damaged or contradictory parts. The read functions throw it for
/// samples that are too large or not finite, and for storage that cannot be decoded.
Record open_hdf5(const std::string& path, const ReadOptions& options = {});

}  // namespace percuss::acquire
