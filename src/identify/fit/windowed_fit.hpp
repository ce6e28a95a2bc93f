#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/fit/local_fit.hpp"
#include "identify/noise/line_noise.hpp"

namespace percuss::identify {

/// Poles that are fitted together over a window of spectral lines.
struct FitGroup {
  LocalFit fit;
  std::size_t first = 0, count = 0;  // the window
};

struct WindowedFitOptions {
  /// Half of a pole's window, in half-power bandwidths. Less than 0.1 % of a pole's information lies beyond 10.
  double window_widths = 10;
  /// A group is fitted again where its data changed by more than this, in standard deviations of the fitted values. A
  /// smooth change is disregarded, because the polynomial follows it.
  double change_tolerance = LocalFitOptions{}.change_tolerance;
};

/// The fit of a set of modes in groups of close modes. Each group is fitted over its own window of spectral lines, with
/// the other groups' contributions subtracted. A few sweeps over the groups reach the least-squares solution of one fit
/// over the whole band, at a fraction of the work.
class WindowedFit {
 public:
  /// `set` must outlive this object.
  explicit WindowedFit(const FrfDataset& set, const WindowedFitOptions& options = {});

  const std::vector<FitGroup>& groups() const { return groups_; }
  std::vector<Pole> poles() const;
  const FrfDataset& set() const { return set_; }
  /// [channels] rms noise in the group's window, from the FRFs' roughness (LineNoise).
  Eigen::VectorXd noise(const FitGroup& group) const { return noise_.over(group.first, group.count); }
  const LineNoise& line_noise() const { return noise_; }
  /// [channels] the largest |H| over the lines at which the force has energy.
  const Eigen::VectorXd& largest_magnitude() const { return largest_; }
  double width_Hz(const Pole& pole) const { return resolved_width_Hz(pole, set_.lines); }

  /// Replaces the poles. Known poles keep their residues; new poles have none until the next sweep.
  void replace(std::vector<Pole> poles);
  /// Fits the groups in turn, twice, each with the latest contributions of the other groups. A group whose data have
  /// not changed is not fitted again.
  void sweep();
  /// Fits again, over longer windows, the groups whose resonances have become broader than their windows.
  void widen();
  /// The FRFs in the group's window without the other groups' contributions, [channels][group.count].
  std::vector<Eigen::VectorXcd> data_without_other_modes(const FitGroup& group) const;
  /// The residual over all lines: the FRFs without any group's contribution, [channels][lines].
  std::vector<Eigen::VectorXcd> residual() const;
  /// A trial fit of the group's window from other poles.
  LocalFit fit(const FitGroup& group, const std::vector<Eigen::VectorXcd>& data, std::vector<Pole> start,
               const Eigen::VectorXd& noise_scale, double tolerance = LocalFitOptions{}.tolerance) const;
  /// [channels] rms noise in the window, from the fit's residual.
  Eigen::VectorXd residual_noise(const FitGroup& group) const;

  /// Tolerance of a trial fit, at which the residual has reached the noise.
  static constexpr double kTrialTolerance = 1e-3;
  /// The largest number of poles in a group.
  static constexpr std::size_t kMaxGroupSize = 4;

 private:
  // The distance of two poles in Hz, divided by the largest of their bandwidths and the line spacing.
  double gap(const Pole& below, const Pole& above) const;
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
  std::vector<std::vector<Eigen::VectorXcd>> fitted_to_;  // [groups] the data of the group's last fit; empty before it
};

}  // namespace percuss::identify
