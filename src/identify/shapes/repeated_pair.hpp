#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// The part of a mode's residues [points × channels] that is not of rank one.
struct RankTest {
  double chi2 = 0;             // of the residues about their rank-one fit (5.1), each part over its standard deviation
  double freedom = 0;          // degrees of freedom of chi2
  double deviate = 0;          // chi2 as a standard normal deviate
  double second_singular = 0;  // second singular value over the first
  bool two_modes() const;      // the second singular value is significant and large
};

/// Tests whether the residues of one mode are of rank one, as φ_p φ_c is. Two modes of one frequency have residues of
/// rank two at their common pole. Fewer than two points or two channels are always of rank one.
/// theory (5.12)
RankTest test_rank(const Mode& mode);

/// Two modes whose residues were identified as those of one mode.
struct RepeatedPair {
  Mode first, second;     // by frequency; the residues of each are of rank one
  bool resolved = false;  // the frequencies or damping ratios differ significantly
  double split_Hz = 0, split_std_Hz = 0;
};

/// The two modes at mode `m` of a test with a roving hammer, if test_rank() finds two.
///   resolved       the poles and the residues from the residues' change with the pole (5.13)
///   not resolved   both modes have the pole of mode m. Any combination of their shapes is a mode, too. With a driving
///                  point d, the first mode has all of its sensor's motion, A¹_pc = A_pd A_dc/A_dd, and the second has
///                  none; otherwise, both are singular vectors. The ± of the frequencies includes the split that the
///                  data allow.
/// Nothing if the residues are of rank one, if an FRF of some point and channel is missing, or if another mode lies
/// within half a bandwidth: the two are then modes of their own already.
/// modes, driving  with points as indices into set.points; the residues in the order of set.channels
/// theory (5.12), (5.13)
std::optional<RepeatedPair> repeated_pair(const FrfDataset& set, const std::vector<Mode>& modes, std::size_t m,
                                          const std::vector<DrivingPoint>& driving);

}  // namespace percuss::identify
