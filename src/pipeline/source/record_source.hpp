#pragma once
#include "pipeline/source/source.hpp"

namespace percuss::pipeline {

/// A record of force and acceleration in time.
class RecordSource : public Source {
 public:
  /// errors  InputError: no acceleration channel.
  explicit RecordSource(acquire::Record record);

  const acquire::Record& record() const override { return record_; }
  const acquire::FrfRecord* frfs() const override { return nullptr; }
  std::set<int> points() const override { return record_.points(); }
  std::vector<acquire::Hit> find_hits(const acquire::HitOptions& options) const override;
  bool has_frfs(const std::vector<AnalysedHit>& hits) const override { return any_accepted(hits); }
  std::pair<double, double> default_band_Hz(const std::vector<AnalysedHit>& hits) const override;
  LineChoice choose_lines(const LineRequest& request, const std::vector<AnalysedHit>& hits,
                          Trace& trace) const override;
  double window_decay_per_s() const override { return 0; }
  std::vector<FrfGroup> groups(const std::vector<AnalysedHit>& hits) const override;
  acquire::PointFrf frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator) const override;
  identify::FrfDataset dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits,
                               const std::vector<acquire::PointFrf>* averages) const override;

 private:
  std::size_t block_samples(const LineRequest& request, const std::vector<AnalysedHit>& hits, Trace& trace) const;
  void require_band(const LineRequest& request) const;
  void require_accepted(const std::vector<AnalysedHit>& hits) const;

  acquire::Record record_;
};

}  // namespace percuss::pipeline
