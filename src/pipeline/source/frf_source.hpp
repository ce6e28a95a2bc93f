#pragma once
#include "pipeline/source/source.hpp"

namespace percuss::pipeline {

/// FRFs that were given in place of a record: no hits, and the force is not known.
class FrfSource : public Source {
 public:
  explicit FrfSource(acquire::FrfRecord frfs);

  const acquire::Record& record() const override { return record_; }
  const acquire::FrfRecord* frfs() const override { return &frfs_; }
  std::set<int> points() const override;
  std::vector<acquire::Hit> find_hits(const acquire::HitOptions& /*options*/) const override { return {}; }
  bool has_frfs(const std::vector<AnalysedHit>& /*hits*/) const override { return true; }
  std::pair<double, double> default_band_Hz(const std::vector<AnalysedHit>& hits) const override;
  LineChoice choose_lines(const LineRequest& request, const std::vector<AnalysedHit>& hits,
                          Trace& trace) const override;
  double window_decay_per_s() const override { return frfs_.decay_per_s; }
  std::vector<FrfGroup> groups(const std::vector<AnalysedHit>& hits) const override;
  acquire::PointFrf frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator) const override;
  identify::FrfDataset dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits,
                               const std::vector<acquire::PointFrf>* averages) const override;

 private:
  acquire::FrfRecord frfs_;
  acquire::Record record_;
};

}  // namespace percuss::pipeline
