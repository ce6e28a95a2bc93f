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
};

struct StabilisationPole {
  std::size_t order = 0;
  Pole pole;
  Stability stability = Stability::fresh;
};

/// The stabilisation diagram: the poles of every model order, by ascending order, then frequency. Reports show the
/// diagram of the whole band. stable_poles() takes its poles from diagrams of sections of the band.
/// source  [11] in docs/theory/sources.md.
struct Stabilisation {
  double low_Hz = 0, high_Hz = 0;  // the range of the spectral lines used
  std::vector<StabilisationPole> poles;
};
Stabilisation stabilise(const FrfDataset& set, const StabilisationOptions& options = {});

}  // namespace percuss::identify
