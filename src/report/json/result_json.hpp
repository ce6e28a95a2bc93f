#pragma once
#include <optional>
#include <string>

#include "pipeline/analysis.hpp"

namespace percuss::report {

// Members of the document percuss/analysis/1, each as JSON text. Precondition: the analysis has computed the results
// that they show.

/// The hit with index `i`.
std::string hit_json(const acquire::Record& record, std::size_t i, const pipeline::AnalysedHit& hit);
struct ModeJson {
  double window_decay_per_s = 0;
  const identify::ModeClassification* classification = nullptr;  // nullptr for modes that are not classified
  std::optional<double> frac{};  // over the lines around the mode; only of modes fitted to FRFs
};
std::string mode_json(const identify::Mode& mode, std::size_t m, const ModeJson& of);
/// Each FRF's agreement with the modes, and its residual terms.
std::string fit_json(const pipeline::Analysis& analysis);
/// Peaks within the band and its margin that no mode models, the largest first.
std::string unexplained_peaks_json(const pipeline::Analysis& analysis);
/// The corrected delays of the channels, and the delays that remain.
std::string delays_json(const pipeline::Analysis& analysis);
std::string frf_json(const pipeline::Analysis& analysis);
std::string coherence_json(const pipeline::Analysis& analysis);
std::string modes_per_hit_json(const pipeline::Analysis& analysis);
std::string stabilisation_json(const identify::Stabilisation& diagram);

}  // namespace percuss::report
