#pragma once
#include <string>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// Mode shapes as CSV, one line per mode and place: mode (from 0), frequency_hz, damping_ratio, family, order, point,
/// channel, position_m, angle_deg, x_m, y_m, z_m (empty where not known), re, im, std, scale_std.
std::string shapes_csv(const pipeline::Survey& survey);

/// The mode indicator as CSV: frequency_hz, then the singular values, largest first.
std::string cmif_csv(const pipeline::Survey& survey);

/// Shapes, MAC and mode indicator as HDF5: /frequency_hz [modes], /damping_ratio [modes], /shape {r,i} [modes, places],
/// /shape_std, /scale_std [modes], /point and /channel [places], /xyz_m [places, 3] (NaN where not known), /auto_mac
/// [modes, modes], /auto_mac_std, /cmif_frequency_hz [lines], /cmif [lines, values]; attribute `normalisation` of the
/// root. Without modes, only the frequencies, damping ratios (both empty) and the mode indicator.
/// errors  InputError: the file exists (without `force`) or cannot be written.
void write_survey_hdf5(const std::string& path, const pipeline::Survey& survey, bool force);

}  // namespace percuss::report
