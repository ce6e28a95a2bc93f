#pragma once
#include <string>
#include <vector>

#include "metrics/common_places.hpp"
#include "metrics/compare.hpp"

namespace percuss::report {

/// The comparison of one document, `b`, with the first, `a`.
struct Comparison {
  const metrics::ComparedDocument& a;
  const metrics::ComparedDocument& b;  // its shapes have the point numbers of a
  metrics::CommonPlaces places;
  metrics::PairedModes modes;
  std::vector<metrics::DeflectionPair> deflections;
  std::vector<metrics::DistantPair> distant{};
};

/// The document percuss/compare/1. `comparisons`: of each document after the first.
std::string compare_json(const std::vector<metrics::ComparedDocument>& documents,
                         const std::vector<Comparison>& comparisons);

}  // namespace percuss::report
