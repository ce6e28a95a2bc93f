#include "identify/classify/tube_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace percuss::identify {
namespace {

using std::numbers::pi;

constexpr std::size_t kTubePlanes = 45;  // 2° apart over 90°
// Sum of the prior weights: 1 for bending, 1 for hoop, 0.05 for other types. RatioLikelihood::other() includes the
// 0.05.
constexpr double kPriorSum = 2.05;

// The likelihoods of one ratio for each plane and for each placement of the sensors.
struct RatioTable {
  std::array<double, kTubePlanes> bending{};
  std::array<double, RatioLikelihood::kPlacements> hoop{};
  double other = 0;
};

RatioTable table_of(const RatioAngle& ratio, const RatioLikelihood& likelihood) {
  RatioTable table;
  for (std::size_t p = 0; p < kTubePlanes; ++p)
    table.bending[p] = likelihood.bending(ratio, pi / 2 * static_cast<double>(p) / kTubePlanes);
  for (std::size_t e = 0; e < RatioLikelihood::kPlacements; ++e) table.hoop[e] = likelihood.hoop(ratio, e);
  table.other = likelihood.other(ratio);
  return table;
}

// Logarithm of the likelihood over the likelihood of an arbitrary ratio, for one plane and one placement.
double log_factor(const std::vector<RatioTable>& tables, std::size_t plane, std::size_t placement) {
  double sum = 0;
  for (const RatioTable& table : tables)
    sum += std::log(pi * (table.bending[plane] + table.hoop[placement] + table.other) / kPriorSum);
  return sum;
}

}  // namespace

double log_tube_evidence(const std::vector<RatioAngle>& ratios, const RatioLikelihood& likelihood) {
  if (ratios.empty()) return 0;
  std::vector<RatioTable> tables;
  tables.reserve(ratios.size());
  for (const RatioAngle& ratio : ratios) tables.push_back(table_of(ratio, likelihood));
  std::vector<double> logs;
  double weights = 0;
  for (std::size_t e = 0; e < RatioLikelihood::kPlacements; ++e) {
    weights += kTubePlanes * RatioLikelihood::weight_of(e);
    for (std::size_t p = 0; p < kTubePlanes; ++p)
      logs.push_back(log_factor(tables, p, e) + std::log(RatioLikelihood::weight_of(e)));
  }
  const double largest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - largest);
  return largest + std::log(sum / weights);
}

}  // namespace percuss::identify
