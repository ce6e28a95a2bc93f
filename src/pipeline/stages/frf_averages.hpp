#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "frf/estimators.hpp"
#include "identify/model/frf_dataset.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// The spectra that FRFs are estimated from; refers to results that must outlive it.
struct TestSpectra {
  const acquire::LineRange& lines;
  const std::vector<AnalysedHit>& hits;
  const std::vector<frf::Spectrum>& force;  // [hits]
  const HitResponses& responses;
  double window_decay_per_s = 0;
};

/// One FRF and the hits that it averages.
struct FrfGroup {
  std::size_t index = 0;  // among the FRFs of the test
  int point = 0;
  std::size_t channel = 0;
  std::vector<std::size_t> hits;
};

/// The FRFs of a test, [points × channels], point by point, ascending: each averages the accepted hits of its point.
std::vector<FrfGroup> frf_groups(const std::vector<AnalysedHit>& hits, std::size_t channels);

/// Floating-point operations of one average, for the division of work among threads.
std::size_t average_cost_flops(std::size_t lines, std::size_t hits);

acquire::PointFrf average_frf(const FrfGroup& group, const TestSpectra& spectra, frf::Estimator estimator);

/// H1 of `hits` by point, the input of the fit of the modes. `averages`: the same FRFs, if they exist already; else
/// nullptr.
identify::FrfDataset h1_dataset(const TestSpectra& spectra, const std::vector<std::size_t>& hits, std::size_t channels,
                                const std::vector<acquire::PointFrf>* averages);

}  // namespace percuss::pipeline
