#pragma once
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A place where a mode may be missing.
struct UnmodelledResonance {
  double freq_Hz = 0;
  double half_power_Hz = 0;  // bandwidth of the stable pole there; 0 for a peak without one
};

/// The unmodelled peaks, largest first, and the stable poles that no mode describes. Resonances near a mode are left
/// out, because the misfit of a mode has stable poles as well. `poles`: unmodelled_poles of the same modes.
std::vector<UnmodelledResonance> unmodelled_resonances(const FrfDataset& set, const std::vector<Mode>& modes,
                                                       const std::vector<Pole>& poles);

/// The modes at resonances where `modes` have none, in ascending frequency. The lines around each are analysed alone,
/// as in a narrow band: there, few modes with residual terms can fit data that the modes of the whole band do not fit.
/// Such modes may also describe tones: see whether their residues agree from hit to hit. theory, section 4, "Peaks
/// and stable poles of the residual"
std::vector<Mode> modes_at_frequencies(const FrfDataset& set, const std::vector<Mode>& modes,
                                       const std::vector<UnmodelledResonance>& resonances, Effort effort);

}  // namespace percuss::identify
