#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identify/model/frf_synthesis.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/survey.hpp"

namespace percuss::report {

/// Lines of the band at which curves are drawn: all, or up to `limit` of them. At least half of these are spread
/// evenly; the others lie around the modes and the peaks that no mode explains. The lines at the tops of the modes and
/// peaks are always added. Ascending, with the first and the last line.
std::vector<std::size_t> drawn_lines(const acquire::LineRange& band, const std::vector<identify::Mode>& modes,
                                     const std::vector<identify::UnmodelledPeak>& peaks, std::size_t limit);

/// The data of the plot "fit": every measured FRF against the FRF synthesised from the modes.
///   {first_hz, df_hz, count, of, lines, channels: [names], points: [numbers], places: [[x, y, z] or null] (surveys),
///    frfs: [{point, channel, frac, bits}], peaks: [{hz, db}]}
/// `count` is the number of drawn lines, `of` the number of lines in the band. `point` and `channel` are indices.
/// `lines` and `bits` are Rice codes (rice_code.hpp): `lines` are indices from first_hz on. `bits` are the measured
/// level and phase; where modes exist, also synthesised less measured level and phase, and the level of the residual.
/// Steps: 0.1 dB, 1/512 turn, 1 dB for the residual. `survey`: nullptr for a test without geometry.
nlohmann::ordered_json fit_plot_json(const pipeline::Analysis& analysis, const pipeline::Survey* survey);

/// The data of the plot "indicator": {first_hz, df_hz, values, mif}. `values` are the curves of the CMIF's
/// three largest singular values in dB.
nlohmann::ordered_json indicator_plot_json(const pipeline::Analysis& analysis, const Eigen::MatrixXd& cmif);

}  // namespace percuss::report
