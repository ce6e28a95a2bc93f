#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::report {

struct PlotSelection {
  bool hits = true, frfs = true, stabilisation = true;
};

/// What src/report/page draws of an analysis, as JSON in ASCII: {"frf": {first_hz, df_hz, of, curves: [{name, db,
/// phase_deg, coherence, sigma_db, fit_db}]}, "modes": [{hz, zeta, name, family, sensors}], "hits": [{name, accepted,
/// bandwidth_hz, force_n, response_mps2, spectrum_db, decay_db, noise_db}], "band_hz", "stabilisation"}. Numbers as
/// quantised_curve. Modes as many as verdicts.
std::string analysis_plot_data(const pipeline::Analysis& analysis,
                               const std::vector<identify::ModeClassification>& classifications,
                               const PlotSelection& wanted = {});

}  // namespace percuss::report
