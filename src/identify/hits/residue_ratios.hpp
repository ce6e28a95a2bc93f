#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/variable_projection.hpp"
#include "identify/hits/hit_frfs.hpp"

namespace percuss::identify {

/// A mode's residue in one hit over its residue in the test, and the weight of that ratio, one over its variance. A
/// weight of 0: the hit does not determine it.
struct ResidueRatio {
  double sum = 0, weight = 0;
  double value() const { return sum / weight; }
};

/// A residue of a mode in one hit.
struct HitResidue {
  std::size_t residue = 0;  // index in Mode::residues
  Complex value;
  double std = 0;    // of the real part and of the imaginary part
  double share = 0;  // part of this residue in the weight of the hit's ratio
};

/// The residues of the single hits, from a fit of their FRFs over a window at the modes' poles. The arguments must
/// outlive this object.
class HitResidues {
 public:
  /// state    the fit
  /// freedom  degrees of freedom of a channel's residual
  HitResidues(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes, const ModeWindow& window,
              const ProjectedState& state, double freedom)
      : hits_(hits),
        modes_(modes),
        window_(window),
        state_(state),
        residue_of_(residue_indices(set, hits)),
        freedom_(freedom) {}

  /// The ratios of a mode of the window, [hits]: real, and common to all channels. A hit beside its place, in another
  /// direction or with another gain of the force changes the residues of all channels by one factor.
  std::vector<ResidueRatio> ratios(std::size_t mode) const;

  /// The residues of a mode of the window, [hits][channels]. `ratios`: of this mode.
  std::vector<std::vector<HitResidue>> residues(std::size_t mode, const std::vector<ResidueRatio>& ratios) const;

  /// The difference between two modes' ratios, [hits]: an error of the force's gain is common to both.
  std::vector<ResidueRatio> contrasts(std::size_t mode, std::size_t other) const;

 private:
  void add_ratio_equations(const ProjectedPart& part, std::vector<Eigen::MatrixXd>& matrix,
                           std::vector<Eigen::VectorXd>& right) const;
  const Residue& expected(std::size_t mode, std::size_t channel) const {
    return modes_[window_.modes[mode]].residues[residue_of_[channel]];
  }

  const HitFrfs& hits_;
  const std::vector<Mode>& modes_;
  const ModeWindow& window_;
  const ProjectedState& state_;
  std::vector<std::size_t> residue_of_;
  double freedom_;
};

/// Whether the values of the hits, from ratios() or from contrasts(), scatter significantly, and by more than errors of
/// the gain explain.
/// points  [hits] compares the hits of each point with their own mean: the misfit of the model also makes the values of
///         points differ. Empty: compares all hits.
bool scatter_clearly(const std::vector<ResidueRatio>& ratios, const std::vector<std::size_t>& points = {});

}  // namespace percuss::identify
