#pragma once
#include <vector>

#include "core/units.hpp"
#include "model/trampoline/trampoline_fit.hpp"

namespace percuss::test {

/// The exponents of the model at the points of ccor_points.
inline constexpr double kCcorStiffnessExponent = 0.6495, kCcorDampingExponent = 0.5202;

/// The model's COR at the five speeds of the source ([8] in docs/theory/sources.md), computed outside percuss with
/// scipy, as trampoline_test.cpp describes. Each has the standard deviation `std`.
inline std::vector<model::MeasuredCor> ccor_points(double std) {
  return {{.speed_mps = 60 * kMilePerHour_mps, .cor = 0.5192180578841, .cor_std = std},
          {.speed_mps = 80 * kMilePerHour_mps, .cor = 0.5067505983381, .cor_std = std},
          {.speed_mps = 90 * kMilePerHour_mps, .cor = 0.5016257732107, .cor_std = std},
          {.speed_mps = 100 * kMilePerHour_mps, .cor = 0.4970326135485, .cor_std = std},
          {.speed_mps = 115 * kMilePerHour_mps, .cor = 0.4909280961852, .cor_std = std}};
}

}  // namespace percuss::test
