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
/// bandwidth_hz, force_n, response_mps2, spectrum_db, decay_db, noise_db}], "of_hits", "band_hz", "stabilisation"}.
/// "of" is the number of all FRFs, "of_hits" the number of all hits. "modes" has an element for each of
/// `classifications`. Curves are quantised (quantised_curve). `modes`: in place of the analysis's own.
std::string analysis_plot_data(const pipeline::Analysis& analysis,
                               const std::vector<identify::ModeClassification>& classifications,
                               const PlotSelection& wanted = {}, const std::vector<identify::Mode>* modes = nullptr);

}  // namespace percuss::report
