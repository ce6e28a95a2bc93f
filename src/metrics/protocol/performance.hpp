#pragma once
#include <cmath>

#include "core/units.hpp"

namespace percuss::metrics {

// The performance of a bat, (P1) and (P3) to (P10) of docs/theory/performance.md, after [8] in docs/theory/sources.md.
// SI units. Positions as in the laboratory: locations z and the centre of gravity from the barrel's tip, the pivot from
// the knob. T is double, or UncertainValue for a value with its uncertainty.

inline constexpr double kPivot_m = 6 * kInch_m;  // of every test, from the base of the knob
inline constexpr double kProtocolGravity_mps2 =
    386.4 * kInch_m;  // as printed in the protocol: 0.08 % above standard gravity
// Swing and pitch together, 6 in from the tip; also the speed at which a ball lot is calibrated.
inline constexpr double kNominalSpeed_mph = 136;
inline constexpr double kNominalSpeed_mps = kNominalSpeed_mph * kMilePerHour_mps;
// The highest limit of BESR or BBCOR that is read. A higher number is a slip, such as 50 for 0.5.
inline constexpr double kMaxLimit = 2;
inline constexpr double kBarrelSpeed_mps = 66 * kMilePerHour_mps;  // of the swing alone, 6 in from the tip
inline constexpr double kPitchSpeed_mps = 70 * kMilePerHour_mps;   // where the ball crosses the plate
inline constexpr double kOunceInch2_kgm2 = kOunce_kg * kInch_m * kInch_m;

/// Drop = weight in ounces − length in inches.                                                              (P1)
template <class T>
T drop_of(const T& mass_kg, const T& length_m) {
  return mass_kg / T(kOunce_kg) - length_m / T(kInch_m);
}

/// Moment of inertia about the pivot, from the period of small swings: I = T² g m a / 4π², a = L − pivot − z_cg.  (P3)
template <class T>
T pendulum_moi_kgm2(const T& period_s, const T& mass_kg, const T& length_m, const T& cg_m,
                    double gravity_mps2 = kProtocolGravity_mps2) {
  const T arm_m = length_m - T(kPivot_m) - cg_m;
  return period_s * period_s * T(gravity_mps2) * mass_kg * arm_m / T(kTwoPi * kTwoPi);
}

/// The swing model: a player's speed with a standard bat, and its decrease with the moment of inertia. The source
/// prints v0 = 40 mph, which gives 44.6 mph 6 in from the tip of a 34 in bat with a moment of inertia of 10 450 oz·in²;
/// 60 mph gives about the 66 mph that the source states there.
struct SwingModel {
  double v0_mps = 60 * kMilePerHour_mps;
  double length_m = 28 * kInch_m;
  double moi_kgm2 = 15000 * kOunceInch2_kgm2;
  double exponent = 0.3;  // 0.08 to 0.37 by player
};

/// Swing speed at location z: v = v0 (L − z)/L0 (MOI0/MOI)^e. The lever arm is from the knob, as printed.     (P4)
template <class T>
T swing_speed_mps(const T& length_m, const T& z_m, const T& moi_kgm2, const SwingModel& swing = {}) {
  using std::pow;
  return T(swing.v0_mps / swing.length_m) * (length_m - z_m) * pow(T(swing.moi_kgm2) / moi_kgm2, swing.exponent);
}

/// Required speed of the ball at the bat: V_c = 66 mph (L − 6 in − z)/(L − 12 in) + 70 mph.                    (P5)
template <class T>
T contact_speed_mps(const T& length_m, const T& z_m) {
  return T(kBarrelSpeed_mps) * (length_m - T(kPivot_m) - z_m) / (length_m - T(2 * kPivot_m)) + T(kPitchSpeed_mps);
}

/// BESR = v_out/v_in + 1/2.                                                                                   (P6)
template <class T>
T besr_of(const T& out_mps, const T& in_mps) {
  return out_mps / in_mps + T(0.5);
}

/// (v_out − δ)/(v_in + δ) + 1/2, δ = V − V_c: BESR at the nominal speed V.                                     (P7)
template <class T>
T ncaa_besr_of(const T& out_mps, const T& in_mps, const T& contact_mps, double nominal_mps = kNominalSpeed_mps) {
  const T delta = T(nominal_mps) - contact_mps;
  return (out_mps - delta) / (in_mps + delta) + T(0.5);
}

/// Batted-ball speed: v_pitch (BESR − 1/2) + v_swing (BESR + 1/2).                                            (P8)
template <class T>
T batted_ball_speed_mps(const T& besr, const T& swing_mps, double pitch_mps = kPitchSpeed_mps) {
  return T(pitch_mps) * (besr - T(0.5)) + swing_mps * (besr + T(0.5));
}

/// k = m_ball x²/MOI, x = L − pivot − z.                                                                     (P10)
template <class T>
T ball_to_bat_inertia(const T& ball_kg, const T& length_m, const T& z_m, const T& moi_kgm2) {
  const T x_m = length_m - T(kPivot_m) - z_m;
  return ball_kg * x_m * x_m / moi_kgm2;
}

/// BBCOR = (BESR − 1/2)(1 + k) + k, and its inverse.                                                          (P9)
template <class T>
T bbcor_of(const T& besr, const T& k) {
  return (besr - T(0.5)) * (T(1) + k) + k;
}
template <class T>
T besr_from_bbcor(const T& bbcor, const T& k) {
  return (bbcor - k) / (T(1) + k) + T(0.5);
}

}  // namespace percuss::metrics
