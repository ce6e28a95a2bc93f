#include "synth/anti_alias_filter.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <numbers>

namespace percuss::synth {
namespace {

constexpr double kCutoff = 0.45;      // cycles/sample
constexpr double kEdgeExponent = 37;  // the Gaussian is e^−37 = 1e-16 at the edge of the support

GaussLegendre tabulated() {
  GaussLegendre rule;
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(kGaussNodes);
  for (std::size_t i = 0; i < kGaussNodes; ++i) {
    gsl_integration_glfixed_point(0, 1, i, &rule.x[i], &rule.weight[i], table);
  }
  gsl_integration_glfixed_table_free(table);
  return rule;
}

}  // namespace

double anti_alias_kernel(double u) {
  if (std::abs(u) > kFilterHalfWidth) return 0;
  const double x = 2 * std::numbers::pi * kCutoff * u;
  const double sinc = std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x;
  return 2 * kCutoff * sinc * std::exp(-kEdgeExponent * u * u / (kFilterHalfWidth * kFilterHalfWidth));
}

const GaussLegendre& gauss_legendre() {
  static const GaussLegendre shared = tabulated();
  return shared;
}

}  // namespace percuss::synth
