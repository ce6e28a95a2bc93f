#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "core/budget.hpp"
#include "frf/estimators.hpp"
#include "identify/classify/classify.hpp"
#include "identify/identify.hpp"
#include "pipeline/channels/align_record.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

struct AnalysisOptions {
  std::optional<std::pair<double, double>> band_Hz;  // default: the usable bandwidth of the force
  frf::Estimator estimator = frf::Estimator::h1;     // of the FRFs shown; modes are fitted to H1, whose noise is known
  acquire::HitOptions hits;
  std::vector<std::size_t> accept_hits, reject_hits;  // indices of hits, or kEveryHit; overrule the findings
  double exponential_end = 0;                         // end value of the exponential window, relative; 0: none
  DelayCorrection delays;
  identify::IdentifyOptions modes;
  identify::ClassifyOptions classes;
  std::size_t threads = 0;          // 0: all
  std::optional<Budget> budget;     // default: default_budget() of the input
  std::vector<Warning> known;       // warnings about the input that are known before its analysis
  std::set<int> geometry_points{};  // point numbers of a stated geometry, for PointNames; empty: none stated
};

/// The limits of an analysis of `record`: the stated ones, by default default_budget() of its files.
Budget budget_of(const AnalysisOptions& options, const acquire::Record& record);

}  // namespace percuss::pipeline
