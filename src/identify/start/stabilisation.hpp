#pragma once
#include <cstddef>
#include <vector>

#include "identify/start/lscf.hpp"

namespace percuss::identify {

/// A pole compared with the nearest pole of the previous order.
enum class Stability { fresh, frequency, damping, stable };
/// new, frequency, damping, stable
const char* name_of(Stability stability);

/// theory (4.7)
struct StabilisationOptions {
  LscfOptions lscf;
  double frequency_bandwidths = 0.1;  // largest change of a stable frequency, in half-power bandwidths
  double damping = 0.1;               // largest relative change of a stable damping ratio
  std::size_t min_stable = 6;         // a candidate is stable at this many orders or more
};

struct StabilisationPole {
  std::size_t order = 0;
  Pole pole;
  Stability stability = Stability::fresh;
};

/// The stabilisation diagram: the poles of every model order, by ascending order, then frequency.
struct Stabilisation {
  double low_Hz = 0, high_Hz = 0;  // the range of the spectral lines used
  std::vector<StabilisationPole> poles;
};
Stabilisation stabilise(const FrfDataset& set, const StabilisationOptions& options = {});

/// Poles of different orders that represent one mode.
struct PoleCluster {
  Pole pole;                  // medians over the stable members
  std::size_t stable = 0;     // number of stable members
  double freq_spread_Hz = 0;  // of the stable frequencies: median absolute deviation × 1.48
  double damping_spread = 0;  // … of the damping ratios
};

/// Clusters of poles over the orders. Each pole joins the nearest cluster within half a bandwidth, one pole per order
/// and cluster. Only clusters with at least `min_stable` stable members, in ascending frequency. source  [11] in
/// docs/theory/sources.md for the diagram, [2] for the spread.
std::vector<PoleCluster> cluster_poles(const Stabilisation& diagram, const StabilisationOptions& options = {});

/// First poles for a fit, in ascending frequency. The band is divided into short overlapping segments, each with few
/// modes; a cluster is taken from the segment in whose middle it lies.
std::vector<Pole> stabilised_candidates(const FrfDataset& set);

}  // namespace percuss::identify
