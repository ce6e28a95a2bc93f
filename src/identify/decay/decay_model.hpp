#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "identify/decay/decay_group_fit.hpp"
#include "identify/decay/decay_spectra.hpp"

namespace percuss::identify {

/// The width of a mode's window on either side of its frequency: the larger of `half_power_bandwidths` and `lines`, at
/// most `max_lines`. A group is fitted over the windows of its modes.
struct DecayWindows {
  double half_power_bandwidths = 40;
  double lines = 60;
  double max_lines = 4000;
  DecayAccuracy accuracy = DecayAccuracy::full;
};

/// A mode of a DecayModel, with the result of its last group fit.
struct FittedDecay {
  DecayRate rate;
  Eigen::RowVectorXcd amplitude;          // [hits × channels] at the first sample
  Eigen::Matrix2d covariance;             // of (Re s, Im s)
  Eigen::Matrix2d inverse_gram;           // covariance of an amplitude's (Re, Im), divided by `noise`
  Eigen::VectorXd noise;                  // [hits × channels] variance of a line's real and imaginary part
  std::vector<Eigen::Vector2d> hit_step;  // [hits] of (Re s, Im s), by each hit alone
  std::vector<Eigen::Matrix2d> hit_covariance;
  double misfit = 1;
  bool converged = false;
  std::optional<DecayAccuracy> settled;  // accuracy of the last fit; none: a mode nearby changed since, or it failed
  /// Two modes at these frequencies fit about as well as this one with a frequency that differs between the hits.
  std::optional<std::pair<double, double>> alternative_pair_Hz{};
};

/// Decays fitted to spectra, group by group: modes whose windows overlap are fitted together, at most eight, and the
/// other groups are subtracted. The groups are fitted in turn until the rates no longer change. A group in which, and
/// near which, nothing changed since its last fit is not fitted again.
class DecayModel {
 public:
  explicit DecayModel(const DecaySpectra& measured) : measured_(&measured) {}

  const std::vector<FittedDecay>& modes() const { return modes_; }  // ascending in frequency
  void add(const DecayRate& rate);
  void remove(std::size_t mode);
  void set_alternative_pair(std::size_t mode, const std::pair<double, double>& alternative_pair_Hz) {
    modes_[mode].alternative_pair_Hz = alternative_pair_Hz;
  }
  /// Sets the noise power of each hit, divided by the geometric mean over the hits of its channel, and the spectrum of
  /// the noise, averaged over channels and octaves. `noise`: E|R|² of a residual [lines, hits × channels]. If a ratio
  /// changes by more than 10 %, all groups are fitted again.
  void set_noise(const Eigen::MatrixXd& noise);
  /// Fits all groups in turn, `sweeps` times at most.
  void fit(int sweeps, const DecayWindows& windows);
  /// The measured spectra minus all modes.
  DecaySpectra residual() const;

 private:
  /// Fits a group. Returns whether the fit converged without a change of the rates.
  bool fit_unsettled(const std::vector<std::size_t>& members, const DecayWindows& windows);
  void unsettle_near(const DecayRate& rate);
  bool is_settled(const std::vector<std::size_t>& members, DecayAccuracy accuracy) const;
  void fit_group(const std::vector<std::size_t>& members, const DecayWindows& windows);
  /// DecayGroup::windows of a group.
  std::vector<std::pair<std::size_t, std::size_t>> windows_of(const std::vector<std::size_t>& members,
                                                              const DecayWindows& windows) const;
  /// The measured lines of a group's windows without the modes of the other groups, [lines, hits × channels].
  Eigen::MatrixXcd data_of(const std::vector<std::pair<std::size_t, std::size_t>>& windows,
                           const std::vector<std::size_t>& members) const;
  /// DecayGroup::line_std for these windows, which hold `lines` lines.
  Eigen::VectorXd line_std_of(const std::vector<std::pair<std::size_t, std::size_t>>& windows,
                              Eigen::Index lines) const;
  /// Stores the results of a group's fit in its modes.
  void store(const DecayGroupFit& fitted, const std::vector<std::size_t>& members);
  /// The variance of the noise near a mode, relative to lines where line_std_ is 1.
  double variance_at(const DecayRate& rate) const;
  void subtract(const FittedDecay& mode, std::size_t first, Eigen::Ref<Eigen::MatrixXcd> lines) const;

  const DecaySpectra* measured_;
  std::vector<FittedDecay> modes_;
  Eigen::VectorXd level_;     // DecayGroup::level
  Eigen::VectorXd line_std_;  // [lines] as of smooth_noise_std(); empty: all 1
};

}  // namespace percuss::identify
