#pragma once
#include <optional>
#include <vector>

#include "identify/classify/classify.hpp"

namespace percuss::identify {

/// Modes of sure type below the modes that allow_three_waves() judges, in ascending frequency.
struct LowerTubeModes {
  std::optional<double> lowest_hoop_Hz;
  std::vector<double> bending_Hz;  // one for each order, without gaps up to the lowest order of the judged modes
};

/// Lets bending modes above twice the lowest sure hoop mode (n = 2) be modes of three waves around the barrel (n = 3).
/// A ring has them from 2.8 times this frequency on, a barrel from 2.2 times. Sensors at right angles cannot tell the
/// two by the ratio of residues. Both are equally probable at first. The frequencies decide, if three bending orders
/// or more lie below: √f of successive orders rises by equal steps (within 3 % of f), and an order is rarely missing.
/// The densities of ln f are normal for bending, and uniform from 2 to 6 times the lowest hoop frequency for n = 3;
/// the probabilities are sums over all assignments of the orders above twice this frequency.
/// A mode with a probability of more than 3 % for three waves is marked. Its confidence is multiplied by the
/// probability of bending. If the result is below kMinTypeProbability, its type becomes unknown, and later bending
/// orders are numbered without it. A bending mode whose order is then uncertain is marked, too. If there is no sure
/// hoop mode, nothing changes: the lowest hoop mode then lies above the band or is not excited, and modes of three
/// waves lie even higher. Modes below twice the lowest hoop frequency never change.
/// three_over_bending [modes]: likelihood of the ratio for n = 3 over the one for bending in any plane. theory (6.9)
void allow_three_waves(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                       const std::vector<double>& three_over_bending, const LowerTubeModes& lower = {});

/// The LowerTubeModes among the modes `below` the band. `lower`: the orders that lower_orders() counted there.
LowerTubeModes lower_tube_modes(const std::vector<Mode>& below, const std::vector<ModeClassification>& below_types,
                                const LowerOrders& lower, const ClassifyOptions& options);

/// three_over_bending of modes seen by two sensors; 1 where neither sees the mode.
std::vector<double> three_over_bending(const std::vector<Mode>& modes, const SensorPair& sensors,
                                       const ClassifyOptions& options);

}  // namespace percuss::identify
