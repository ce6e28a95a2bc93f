#pragma once
#include <cstddef>
#include <vector>

#include "identify/start/lscf.hpp"

namespace percuss::identify {

/// How a pole compares with the nearest one of the order before.
enum class Stability { fresh, frequency, damping, stable };
/// new, frequency, damping, stable
const char* name_of(Stability stability);

/// theory (4.7)
struct StabilisationOptions {
  LscfOptions lscf;
  double frequency_bandwidths = 0.1;  // a frequency is stable when it moves by no more than this part of the bandwidth
  double damping = 0.1;               // … a damping ratio, by no more than this part of itself
  std::size_t least_stable = 6;       // orders at which a pole must be stable to be a candidate
};

struct StabilisationPole {
  std::size_t order = 0;
  Pole pole;
  Stability stability = Stability::fresh;
};

/// The stabilisation diagram: the poles of every model order, by ascending order, then frequency.
struct Stabilisation {
  double low_Hz = 0, high_Hz = 0;  // of the lines used
  std::vector<StabilisationPole> poles;
};
Stabilisation stabilise(const FrfDataset& set, const StabilisationOptions& options = {});

/// Poles of different orders that are one and the same.
struct PoleCluster {
  Pole pole;                  // medians over the stable members
  std::size_t stable = 0;     // members that are stable
  double freq_spread_Hz = 0;  // deviation of their frequencies from the median, median absolute × 1.48
  double damping_spread = 0;  // … of their damping ratios
};

/// Poles that stay from order to order: each order's poles join the nearest cluster within half a bandwidth, one pole
/// per order and cluster; clusters with at least `least_stable` stable members, ascending frequency.
/// source  [11] in docs/theory/sources.md for the diagram, [2] for the spread.
std::vector<PoleCluster> cluster_poles(const Stabilisation& diagram, const StabilisationOptions& options = {});

/// First poles for a fit, in ascending frequency: the clusters of short overlapping stretches of lines, over which few
/// modes share the orders, each taken from the stretch in whose middle it lies.
std::vector<Pole> stabilised_candidates(const FrfDataset& set);

}  // namespace percuss::identify
