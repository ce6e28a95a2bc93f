#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/fit/local_fit.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {

/// Poles fitted together over a window of lines.
struct FitGroup {
  LocalFit fit;
  std::size_t first = 0, count = 0;  // the window
};

struct WindowedFitOptions {
  /// Half-power bandwidths on either side of a pole that its window holds: beyond 10 lies under 0.1 % of what the lines
  /// tell of it.
  double window_widths = 10;
  /// Data that change by less, beside the smooth background that is fitted with them, leave a fit as it is: in
  /// deviations of what is fitted.
  double change = LocalFitOptions{}.change;
};

/// A set of modes fitted piece by piece: close ones together, each piece over a window of its own lines with the shares
/// of all others subtracted. A few sweeps over the pieces come to the same least-squares solution as one fit over the
/// whole band, at a fraction of the work.
class WindowedFit {
 public:
  /// `set` must outlive this object.
  explicit WindowedFit(const FrfDataset& set, const WindowedFitOptions& options = {});

  const std::vector<FitGroup>& groups() const { return groups_; }
  std::vector<Pole> poles() const;
  const FrfDataset& set() const { return set_; }
  /// Per channel: deviation of the noise in the group's window as all lines tell it (LineNoise).
  Eigen::VectorXd noise(const FitGroup& group) const { return noise_.over(group.first, group.count); }
  const LineNoise& line_noise() const { return noise_; }
  /// Per channel: the largest line that the force reached.
  const Eigen::VectorXd& largest() const { return largest_; }
  /// Half-power bandwidth, at least half a line.
  double width_Hz(const Pole& pole) const;

  /// Other poles: residues of those already known stay; new ones count as 0 until the next sweep.
  void replace(std::vector<Pole> poles);
  /// Fits every group in turn, twice over, the second time with the final shares of its neighbours; one whose data have
  /// not changed since is left alone.
  void sweep();
  /// Fits once more, over a longer window, what began as a narrow resonance and has become a broad one.
  void widen();
  /// What is left in the group's window when all other groups' shares are subtracted, [channels][group.count].
  std::vector<Eigen::VectorXcd> data_without_other_modes(const FitGroup& group) const;
  /// … and over all lines when every group's share is.
  std::vector<Eigen::VectorXcd> residual() const;
  /// The group's window fitted anew with these poles; for trials.
  LocalFit fit(const FitGroup& group, const std::vector<Eigen::VectorXcd>& data, std::vector<Pole> start,
               const Eigen::VectorXd& weight, double tolerance = LocalFitOptions{}.tolerance) const;
  /// The noise of each channel in the window as the fit's residual tells it.
  Eigen::VectorXd weights_from(const FitGroup& group) const;

  /// Tolerance that is near enough to see the noise.
  static constexpr double kTrialTolerance = 1e-3;
  /// No more than this many are fitted together.
  static constexpr std::size_t kMaxGroupSize = 4;

 private:
  double gap(const Pole& below, const Pole& above) const;  // bandwidths, or lines
  void add_groups(std::span<const Pole> poles);
  void place_window(FitGroup& group) const;
  bool same_window(const FitGroup& before, const FitGroup& group) const;
  void fit_all();
  bool has_outgrown_window() const;
  bool unchanged(std::size_t group, const std::vector<Eigen::VectorXcd>& data) const;
  void subtract(const LocalFit& fit, std::size_t mode, const FitGroup& window,
                std::vector<Eigen::VectorXcd>& data) const;

  const FrfDataset& set_;
  WindowedFitOptions options_;
  LineNoise noise_;
  Eigen::VectorXd largest_;
  std::vector<FitGroup> groups_;
  std::vector<std::vector<Eigen::VectorXcd>> fitted_to_;  // [groups] the data of the last fit; none before it
};

}  // namespace percuss::identify
