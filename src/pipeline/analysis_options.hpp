#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "frf/estimators.hpp"
#include "identify/classify/classify.hpp"
#include "identify/identify.hpp"

namespace percuss {

/// What an Analysis is to do with its record.
struct AnalysisOptions {
  std::optional<std::pair<double, double>> band_Hz;  // default: what the hammer excited
  Estimator estimator = Estimator::h1;               // of the FRFs shown; modes are fitted to H1, whose noise is known
  HitOptions hits;
  std::vector<std::size_t> accept_hits, reject_hits;  // the user's word on single hits
  double exponential_end = 0;                         // exponential window falling to this fraction; 0: none
  IdentifyOptions modes;
  ClassifyOptions classes;
  std::size_t threads = 0;
};

}  // namespace percuss
