#pragma once
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/record.hpp"
#include "core/trace.hpp"
#include "pipeline/stages/frf_averages.hpp"

namespace percuss::pipeline {

/// The inputs to the choice of an analysis's spectral lines.
struct LineRequest {
  std::pair<double, double> band_Hz;
  bool band_given = false;          // by the user; else the source's own band
  bool length_given = false;        // of the hits, by the user
  std::size_t missing_samples = 0;  // at the end of a row, where a delay was taken out
  std::size_t threads = 0;
};

/// The spectral lines of a test before its spectra are known.
struct LineChoice {
  acquire::LineRange lines;  // from the margin below the band to the highest possible end
  double end_Hz = 0;         // the end of the lines, unless a strong mode lies just beyond (end_past_modes)
};

/// Where the data of a test come from: a record in time, or FRFs that were given. A source keeps no results: Analysis
/// computes them in order, keeps them and passes them in.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  /// The record. For FRFs: their files, channels, notes and geometry, without rows.
  virtual const acquire::Record& record() const = 0;
  /// The FRFs that were given; nullptr for a record.
  virtual const acquire::FrfRecord* frfs() const = 0;
  /// Numbers of the measured points.
  virtual std::set<int> points() const = 0;
  virtual std::vector<acquire::Hit> find_hits(const acquire::HitOptions& options) const = 0;
  /// Whether FRFs exist, or can be estimated from these hits.
  virtual bool has_frfs(const std::vector<AnalysedHit>& hits) const = 0;
  /// The band of an analysis if the user states none.
  virtual std::pair<double, double> default_band_Hz(const std::vector<AnalysedHit>& hits) const = 0;
  /// The band with a margin for modes just outside, limited by the bandwidth of the data. FRFs that were given leave no
  /// choice: their lines already end past strong modes just beyond the band. `hits` are graded by force.
  /// errors  InputError: no accepted hit, or a band that does not fit the data.
  virtual LineChoice choose_lines(const LineRequest& request, const std::vector<AnalysedHit>& hits,
                                  Trace& trace) const = 0;
  /// Decay rate of the exponential window that the data contain already; 0 without a window.
  virtual double window_decay_per_s() const = 0;
  /// The FRFs that exist or can be estimated, point by point, ascending. errors  InputError: no accepted hit.
  virtual std::vector<FrfGroup> groups(const std::vector<AnalysedHit>& hits) const = 0;
  /// One of groups() over the lines of `spectra`. Several threads may call it at the same time.
  virtual acquire::PointFrf frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator) const = 0;
  /// The FRFs that modes are fitted to; `averages` as for h1_dataset.
  virtual identify::FrfDataset dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits,
                                       const std::vector<acquire::PointFrf>* averages) const = 0;
};

}  // namespace percuss::pipeline
