#pragma once
#include <optional>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The poles of a group as each impact point alone has them. Resonances move from hit to hit (temperature, the strength
/// of the blow, the hammer's or a roving sensor's mass), and then no poles common to all points fit.
struct PointFits {
  std::vector<LocalFit> fits;  // [points]; residues and noise of that point's channels, in their order
  double cost = 0;             // of all together, as LocalFit has it
  std::size_t degrees = 0;
};

/// What a window is fitted to: its lines with all other groups' shares subtracted (WindowedFit::remainder), and the
/// weights.
struct WindowData {
  std::vector<Eigen::VectorXcd> data;  // [channels][group.count]
  Eigen::VectorXd weight;              // [channels]
};

/// Fits modes to each point by itself, strongest first, over the group's window from the group's poles. Gives up (no
/// fits) once the cost is beyond `most`.
PointFits fit_each_point(const FrfDataset& set, const WindowData& window, const FitGroup& group, double most);

/// True when the poles of `one`, each point with its own, explain the window as well as the common poles of `more` (one
/// mode or several more) do: the points disagree about the frequency, and a further mode would only stand for that, to
/// first order exactly. Never for fewer than three points: two orthogonal modes of which each point sees one look the
/// same. `more` was fitted to this window.
bool explained_by_freq_scatter(const FrfDataset& set, const WindowData& window, const FitGroup& one,
                               const FitGroup& more);

/// The group's one pole, if it holds several that only stand for one that moves; otherwise nothing.
std::optional<Pole> merge_if_scattered(const WindowedFit& all, const FitGroup& group);

/// A mode as points that disagree about it give it: the mean over the points, each weighted with its own deviation and
/// the spread between them; deviations of that mean; residues as each point by itself has them.
/// theory (4.15)
struct ScatteredMode {
  Pole pole;
  double freq_std_Hz = 0, damping_std = 0;
  double freq_scatter_Hz = 0;                  // standard deviation between the points
  std::vector<Complex> residues;               // [channels]
  std::vector<std::optional<Pole>> own_poles;  // [channels] of points that see the mode
  std::vector<double> residue_std;             // [channels]
  Eigen::VectorXd noise;                       // [channels] rms per line of what is left
};

/// The group's modes, if its points disagree about their poles beyond doubt; otherwise nothing.
std::vector<ScatteredMode> scattered_modes(const WindowedFit& all, const FitGroup& group);

/// Takes what a mode's common pole leaves off a residual over all lines, [channels][lines]: there each point has its
/// own.
void subtract_freq_scatter(const FrfDataset& set, const FitGroup& group, std::size_t mode, const ScatteredMode& moving,
                           std::vector<Eigen::VectorXcd>& residual);

}  // namespace percuss::identify
