#pragma once
#include <optional>
#include <string>

#include "acquire/channels/stored_frfs.hpp"

namespace percuss::acquire {

/// The FRFs of an HDF5 file as percuss writes them (docs/reference/formats.md): /frequency_hz [lines], /frf {r, i}
/// [points, channels, lines], /frf_std and /coherence alike where present, /point [points]; attributes kind, unit,
/// estimator, averages, decay_per_s, and angle_deg and position_m of /frf. With one dimension fewer there is one point.
/// Returns nothing if the file has no /frf, or has a /force.
/// errors  InputError with file and data set.
std::optional<StoredFrfs> read_frf_hdf5(const std::string& path);

}  // namespace percuss::acquire
