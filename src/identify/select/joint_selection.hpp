#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Lines around a mode: five half-power bandwidths, and at least eight lines, on either side.
struct JointWindow {
  Eigen::Index first = 0, count = 0;
};
JointWindow joint_window(const FrfDataset& set, const Pole& pole);

/// The significance that a mode of a joint fit needs (ModeSignificance::significance): its clearest residue, in
/// standard deviations.
inline constexpr double kJointSignificance = 6;

/// True for two poles at one place, which a fit has merged: their residues cancel.
bool are_merged(const FrfDataset& set, const Pole& a, const Pole& b);

/// Misfit counts against a mode only once no mode is missing: the residual of a missing mode looks like misfit.
enum class Misfit { ignored, counted };

/// How far a mode of a joint fit stands out of the residual around it.
struct ModeSignificance {
  double significance = 0;      // of its clearest residue, in standard deviations
  double peak_to_residual = 0;  // largest over the FRFs
};
ModeSignificance significance_of(const FrfDataset& set, const JointFit& fit, std::size_t mode, Misfit misfit);

/// The poles that are modes. Of neighbours that are no modes, only the weakest is removed, because the others may be
/// modes without it.
std::vector<Pole> without_weakest(const FrfDataset& set, const JointFit& fit, Misfit misfit);

/// A residual with, or without, the part that the residual terms of a local fit describe: the tails of other modes,
/// which do not disturb a mode.
enum class Tails { kept, removed };

/// How far the residual around a mode is from noise, in standard deviations of its roughness; the worst FRF.
double misfit_of(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual, const Pole& pole,
                 Tails tails = Tails::kept);

/// The misfit of a mode that needs a search, in standard deviations.
inline constexpr double kMinMisfit = 6;

/// True where the residual around a mode is material: in some FRF it is large enough, relative to the FRF, to disturb
/// the mode. A residual that rounding errors, or the gain error from the noise of the force, can explain is not
/// material.
bool is_material(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual, const Pole& pole,
                 Tails tails = Tails::kept);

/// Twice the logarithm of the likelihood ratio of two residuals. Its degrees of freedom are the independent lines of
/// the second residual: a smooth misfit has few. theory (4.21)
double likelihood_ratio_statistic(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& before,
                                  const std::vector<Eigen::VectorXcd>& after);

/// Real unknowns of one mode: its pole and its complex residues.
std::size_t unknowns_per_mode(const FrfDataset& set);

/// The limit that the statistic of a fit with `unknowns` additional unknowns must exceed. The limit per
/// unknown is 150/unknowns_per_mode(), within 8 … 25: the more FRFs, the less each unknown needs to gain.
double min_gain(const FrfDataset& set, std::size_t unknowns);

/// Poles, and the residual of their fit.
struct KnownModes {
  const std::vector<Pole>& poles;
  const std::vector<Eigen::VectorXcd>& residual;
};

/// The clear modes of a fit beside the known ones. A clear mode is twice as significant as necessary, lies a bandwidth
/// from every other mode, stands 20 dB above the residual, and raises the likelihood of the lines around it. If it
/// raises the likelihood much, 14 dB suffice. Clear modes need a rule of their own: beside the misfit of strong modes,
/// they gain little in the likelihood ratio of the whole band.
std::vector<Pole> clear_modes(const FrfDataset& set, const KnownModes& known, const JointFit& fit);

/// As min_gain() for `unknowns` additional unknowns, without the unknowns of `clear` clear modes.
double min_gain_beside(const FrfDataset& set, std::size_t unknowns, std::size_t clear);

}  // namespace percuss::identify
