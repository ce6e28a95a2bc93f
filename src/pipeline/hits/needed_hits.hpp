#pragma once
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Accepts hits with `double_hit` at points that have fewer than two accepted hits, and then hits with `force_clipped`.
/// The force channel saw both contacts, so H1 of the whole force is exact. A clipped force leaves frequencies and
/// damping right. The findings become warnings that say so. Hits that the user judged stay unchanged. So do hits whose
/// gate leaves out the second contact, and hits whose second contact is more than half as large as the first.
void accept_needed_hits(std::vector<AnalysedHit>& hits, double fs_Hz);

}  // namespace percuss::pipeline
