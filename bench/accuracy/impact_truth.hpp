#pragma once
#include "model/impact/impact.hpp"

namespace percuss::accuracy {

/// The coefficient of restitution of an impact without hysteresis. It is independent of model/impact/impact.cpp, except
/// for the length of the steps in which the end of the contact is searched: a thousandth of hertz_contact_s. GSL's
/// eighth-order Runge–Kutta method (Prince and Dormand) integrates the equations of motion of ball and modes with a
/// tolerance of 1e-14. Newton's method finds the end of the contact. The error is about 1e-12.
double exact_cor(const model::Impact& impact);

}  // namespace percuss::accuracy
