#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/lazy.hpp"
#include "core/trace.hpp"
#include "core/uninitialized_array.hpp"
#include "frf/estimators.hpp"
#include "frf/formats/frf_record.hpp"
#include "identify/classify/classify.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/model/mode.hpp"
#include "identify/start/stabilisation.hpp"
#include "pipeline/analysed_hit.hpp"
#include "pipeline/analysis_options.hpp"

namespace percuss::pipeline {

struct Warning {
  std::string code;
  std::string message;
};

/// One test, from record to named modes, computed as far as asked and kept. Inputs are immutable: other options are
/// another Analysis. Accessors call the stages they need and nothing else; trace() tells which ran. Not for use by
/// several threads at once.
class Analysis {
 public:
  Analysis(acquire::Record record, AnalysisOptions options);
  /// A test of which only the FRFs are left: no hits, and what a force would tell is not known.
  Analysis(frf::FrfRecord frfs, AnalysisOptions options);

  const acquire::Record& record() const { return record_; }
  const AnalysisOptions& options() const { return options_; }
  /// The FRFs it was given in place of a record; nullptr otherwise.
  const frf::FrfRecord* given_frfs() const { return given_ ? &*given_ : nullptr; }
  Trace& trace() const { return trace_; }
  /// The numbers of the points that were hit, or that the FRFs given are of.
  std::set<int> points() const;

  /// Hits graded by their force alone: reads nothing else. Index i is the user's hit number.
  const std::vector<AnalysedHit>& force_hits() const;
  /// … and by their responses and by how well they agree with one another.
  const std::vector<AnalysedHit>& hits() const;
  /// False when no hit can be used: FRFs and modes cannot be had then.
  bool possible() const;

  std::pair<double, double> band_Hz() const;
  /// The lines of the FRFs: the band and a margin for modes just outside, as far as the force reaches.
  const frf::LineRange& lines() const;
  double window_decay_per_s() const;
  /// The points with an accepted hit, or of the FRFs given: those of frfs(), ascending.
  std::vector<int> frf_points() const;
  /// Averaged FRFs over lines(), [points × channels], point by point, with the estimator asked for.
  const std::vector<frf::PointFrf>& frfs() const;
  /// H1 of the accepted hits, as the modes were fitted to it; points ascending by number.
  const identify::FrfDataset& fitted_frfs() const;
  /// Modes within the band, ascending.
  const std::vector<identify::Mode>& modes() const;
  /// Computes modes() and frfs() in the order that takes less time.
  void compute_modes_and_frfs() const;
  const std::vector<identify::ModeClassification>& classifications() const;
  /// Every mode as each accepted hit alone shows it: repeatability, drift, dependence on the force.
  const std::vector<HitMode>& modes_per_hit() const;
  /// The stabilisation diagram of the FRFs that the modes are fitted to; poles within the band. No mode needs it.
  const identify::Stabilisation& stabilisation() const;
  std::vector<Warning> warnings() const;

 private:
  struct Response {
    acquire::ResponseGrade grade;
    std::span<const Complex> spectrum;
  };
  struct Responses {
    std::vector<std::vector<Response>> of;  // [hits][channels]; empty for hits rejected by their force
    UninitializedArray<Complex> lines;      // where the spectra are
  };
  struct FrfHits {  // what one FRF is averaged over
    int point = 0;
    std::size_t channel = 0;
    std::vector<std::size_t> hits;
  };
  std::vector<AnalysedHit> find() const;
  std::vector<AnalysedHit> graded() const;
  frf::LineRange choose_lines() const;
  std::size_t block_samples() const;  // the common length of the hits' transforms
  std::size_t longest_decay() const;  // of the accepted hits of a continuous record, over all channels
  const std::vector<std::vector<Response>>& responses() const;
  Responses read_responses() const;
  const std::vector<frf::Spectrum>& force_spectra() const;  // [hits]; nullptr for those not used
  std::vector<FrfHits> frf_hits() const;
  frf::PointFrf average(const FrfHits& of) const;
  identify::FrfDataset frf_set(const std::vector<std::size_t>& hits) const;  // H1 of these hits, by point
  std::vector<std::size_t> accepted_hits() const;
  std::vector<identify::ModeClassification> classify_modes() const;
  std::vector<HitMode> identify_per_hit() const;
  // The same from FRFs that were given (analysis_frfs.cpp).
  std::pair<double, double> given_band_Hz() const;
  frf::LineRange given_lines() const;
  std::vector<frf::PointFrf> given_within_lines() const;
  identify::FrfDataset given_set() const;
  void warn_of_truncation(std::vector<Warning>& out) const;
  void warn_of_unmodelled_peaks(std::vector<Warning>& out) const;
  void warn_of_freq_scatter(std::vector<Warning>& out) const;

  acquire::Record record_;
  std::optional<frf::FrfRecord> given_;
  AnalysisOptions options_;
  mutable Trace trace_;
  Lazy<std::vector<AnalysedHit>> force_hits_, hits_;
  Lazy<frf::LineRange> lines_;
  Lazy<std::size_t> longest_decay_;
  Lazy<Responses> responses_;
  Lazy<std::vector<frf::Spectrum>> force_spectra_;
  Lazy<std::vector<frf::PointFrf>> frfs_;
  Lazy<identify::FrfDataset> fitted_frfs_;
  Lazy<std::vector<identify::Mode>> modes_;
  Lazy<std::vector<identify::ModeClassification>> verdicts_;
  Lazy<std::vector<HitMode>> modes_per_hit_;
  Lazy<identify::Stabilisation> stabilisation_;
};

/// The runs of a record (repeated tests in one file) as records of their own, ascending by run.
std::vector<std::pair<int, acquire::Record>> split_runs(const acquire::Record& record);

}  // namespace percuss::pipeline
