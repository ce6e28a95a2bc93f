#pragma once
#include "model/impact/impact.hpp"

namespace percuss::accuracy {

/// The coefficient of restitution of an impact without hysteresis, independent of model/impact/impact.cpp. GSL's
/// eighth-order Runge–Kutta method (Prince and Dormand) integrates the equations of motion of ball and modes with a
/// tolerance of 1e-14. Newton's method finds the end of the contact. The error is about 1e-12.
double exact_cor(const model::Impact& impact);

}  // namespace percuss::accuracy
