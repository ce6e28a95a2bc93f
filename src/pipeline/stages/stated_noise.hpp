#pragma once
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// Widens the ± of modes of given FRFs to the standard deviations that were given with them. The fit takes the noise
/// from its residual; where the stated noise of the lines that move the pole is larger, the noise's part of the ± grows
/// by the ratio. If the residuals are far smaller than stated, near one mode in one FRF or in all together, the lines
/// share the stated deviations, because the averaged hits differ: the noise's part then follows from the residual near
/// the mode, and the gains of the modes that differ (stated_gain) go to the ± of the residues. The part of the hits
/// grows by the poles that differ between the hits (stated_pole_scatter). `set` holds the FRFs of `given` in the same
/// order.
void widen_to_stated_noise(const acquire::FrfRecord& given, const identify::FrfDataset& set,
                           std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
