#pragma once
#include "model/impact/impact.hpp"

namespace percuss::accuracy {

/// The coefficient of restitution of an impact without hysteresis, by another way than model/impact.cpp's: Runge and
/// Kutta's eighth-order method (Prince and Dormand's, of GSL), held to 1e-14, on the equations of motion of ball and
/// modes, the modes' motion included; the end of the contact by Newton's method. Good to some 1e-12.
double exact_cor(const model::Impact& impact);

}  // namespace percuss::accuracy
