#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss::report {

struct PlotSelection {
  bool hits = true, frfs = true, stabilisation = true;
};

/// The data of the plots in src/report/html/page, as JSON in ASCII: {"frf": {first_hz, df_hz, of, curves: [{name, db,
/// phase_deg, coherence, sigma_db, fit_db}]}, "modes": [{hz, zeta, name, family, sensors}], "hits": [{name, accepted,
/// bandwidth_hz, force_n, response_mps2, spectrum_db, decay_db, noise_db}], "band_hz", "stabilisation"}. Curves
/// are quantised (quantised_curve). As many modes as `classifications`.
std::string analysis_plot_data(const pipeline::Analysis& analysis,
                               const std::vector<identify::ModeClassification>& classifications,
                               const PlotSelection& wanted = {});

}  // namespace percuss::report
