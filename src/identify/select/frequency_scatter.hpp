#pragma once
#include <optional>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The data of a window without the other groups' contributions (WindowedFit::data_without_other_modes), and the noise
/// scale of each FRF.
struct WindowData {
  std::vector<Eigen::VectorXcd> data;  // [channels][group.count]
  Eigen::VectorXd noise_scale;         // [channels] as in fit_locally()
  Eigen::VectorXd noise;               // [channels] rms noise per line (WindowedFit::noise)
};

/// The largest residual energy that separate poles at each point may leave if a frequency scatters. `further_mode` is
/// the residual energy with a further common mode, `noise` the energy of the noise, all in one unit. Above the noise,
/// the limit is 15 times `further_mode`: such a frequency also drifts during the decay, and a further common mode
/// follows this drift better than separate poles do. For a true pair the ratio is tens to thousands.
/// theory (4.31)
double max_scatter_energy(double further_mode, double noise);

/// Compares two fits of one window by modes common to all points: `one`, and `more`, which has additional modes and was
/// fitted to this window. True where the additional modes only describe the frequency scatter of the modes of `one`. To
/// first order, additional modes describe such scatter exactly. The test: separate poles of `one` at each point leave
/// at most max_scatter_energy() of `more`. If `one` has a single mode, its frequency must also scatter as widely as the
/// poles of `more` lie apart. Always false for fewer than three points, because two orthogonal modes look the same
/// there.
bool explained_by_freq_scatter(const FrfDataset& set, const WindowData& window, const FitGroup& one,
                               const FitGroup& more);

/// The strongest pole, where the group's other poles only describe its frequency scatter; otherwise nothing.
std::optional<Pole> merge_if_scattered(const WindowedFit& all, const FitGroup& group);

/// A mode whose frequency scatters between the points: the weighted mean of the separate fits, with the standard
/// deviation of that mean. The weights contain each fit's variance and the variance between the points. The residues
/// come from the separate fits at the points that observe the mode, and from the common fit at the other points.
/// theory (4.15)
struct ScatteredMode {
  Pole pole;
  double freq_std_Hz = 0, damping_std = 0;
  double freq_scatter_Hz = 0;                  // standard deviation of the frequency between the points
  std::vector<Complex> residues;               // [channels]
  std::vector<std::optional<Pole>> own_poles;  // [channels] for the points that observe the mode
  std::vector<double> residue_std;             // [channels]
  Eigen::VectorXd noise;                       // [channels] rms residual per line
};

/// The group's modes, where their frequencies scatter significantly between the points; otherwise empty.
std::vector<ScatteredMode> scattered_modes(const WindowedFit& all, const FitGroup& group);

/// Corrects a residual, [channels][lines], for the difference between a mode's common pole and its separate poles.
void subtract_freq_scatter(const FrfDataset& set, const FitGroup& group, std::size_t mode,
                           const ScatteredMode& scattered, std::vector<Eigen::VectorXcd>& residual);

}  // namespace percuss::identify
