#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A peak of the FRFs without an identified mode.
struct UnmodelledPeak {
  double freq_Hz = 0;
  double level_dB = 0;  // of Σ|H|² over the FRFs, relative to its largest line
};

/// Prominent peaks (prominent_lines) farther than three half-power bandwidths, and three lines, from every mode. The
/// residual has a resonance there that holds at least a quarter of the FRFs' energy around it. Only peaks within the
/// force's bandwidth and within `range_dB` of the largest line. Ascending.
/// beyond  modes of the margin that the residual is without as well. If the residual held a strong one, its residual
///         terms would follow this mode, and would be wrong throughout the band.
std::vector<UnmodelledPeak> unmodelled_peaks(const FrfDataset& set, const std::vector<Mode>& modes, double range_dB,
                                             const std::vector<Mode>& beyond = {});

/// The peaks that stand clearly out of the noise (the larger of LineNoise and LineNoise::local): √Σ|H|² falls from the
/// peak to its higher saddle by at least six standard deviations of the difference of two lines. Near the end of the
/// force's spectrum, noise makes prominent lines on the tails of modes beyond it. A search for modes may start from
/// such lines, but no warning names them.
std::vector<UnmodelledPeak> clear_of_noise(const FrfDataset& set, std::vector<UnmodelledPeak> peaks);

/// Stable poles (stable_poles) within the force's bandwidth and farther than a half-power bandwidth, and one line, from
/// every mode. The residual has a resonance there that holds at least a quarter of the FRFs' energy around it.
/// Ascending.
std::vector<Pole> unmodelled_poles(const FrfDataset& set, const std::vector<Mode>& modes);
/// The same poles, from modal_sums() of the set and the modes.
std::vector<Pole> unmodelled_poles(const FrfDataset& set, const std::vector<Mode>& modes,
                                   const std::vector<Eigen::VectorXcd>& sums);

}  // namespace percuss::identify
