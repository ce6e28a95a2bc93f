#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "frf/estimators.hpp"
#include "identify/classify/classify.hpp"
#include "identify/identify.hpp"

namespace percuss::pipeline {

/// What an Analysis is to do with its record.
struct AnalysisOptions {
  std::optional<std::pair<double, double>> band_Hz;  // default: what the hammer excited
  frf::Estimator estimator = frf::Estimator::h1;     // of the FRFs shown; modes are fitted to H1, whose noise is known
  acquire::HitOptions hits;
  std::vector<std::size_t> accept_hits, reject_hits;  // the user's word on single hits
  double exponential_end = 0;                         // exponential window falling to this fraction; 0: none
  identify::IdentifyOptions modes;
  identify::ClassifyOptions classes;
  std::size_t threads = 0;
};

}  // namespace percuss::pipeline
