#pragma once
/// A bat's performance in numbers: drop, moment of inertia, BESR, BBS, BBCOR. SI units, except drop (weight in
/// ounces minus length in inches); docs/theory/performance.md.
///
/// @code
/// #include <iostream>
/// #include <percuss/metrics.hpp>
///
/// int main() {
///   const percuss::BatPerformance bat = percuss::bat_performance({.length_m = percuss::Measured{0.8636, 0.0005},
///                                                                 .moi_kgm2 = percuss::Measured{0.191},
///                                                                 .ball_kg = percuss::Measured{0.1454},
///                                                                 .z_m = percuss::Measured{0.1524},
///                                                                 .v_in_mps = percuss::Measured{60.8},
///                                                                 .v_out_mps = percuss::Measured{13.9, 0.1}});
///   std::cout << "BBCOR " << bat.bbcor->value << " ± " << bat.bbcor->std << '\n';
/// }
/// @endcode
#include <optional>
#include <vector>

#include <percuss/modes.hpp>

namespace percuss {

/// A number and its standard deviation. A standard deviation of 0 means that it is not known.
struct Measured {
  double value = 0, std = 0;
};

/// Readings of one bat and one impact. A result is absent when its readings are missing.
struct BatReadings {
  std::optional<Measured> length_m{}, mass_kg{};
  std::optional<Measured> cg_m{};      // from the barrel's tip
  std::optional<Measured> period_s{};  // of the pendulum; the pivot is 6 in from the knob
  std::optional<Measured> moi_kgm2{};  // replaces the result of the pendulum
  std::optional<Measured> ball_kg{};
  std::optional<Measured> z_m{};  // of the impact, from the barrel's tip
  std::optional<Measured> v_in_mps{}, v_out_mps{};
  std::optional<Measured> besr{}, bbcor{};  // one of them in place of the speeds; InputError if both are given
  std::optional<Measured> v_swing_mps{};    // replaces the speed of the swing model
  double lot_correction = 0;                // of the balls, added to v_out/v_in
};

/// The results (P1) and (P3) to (P10) of docs/theory/performance.md.
struct BatPerformance {
  std::optional<Measured> drop{}, moi_kgm2{}, besr{}, ncaa_besr{}, bbs_mps{}, bbcor{}, v_contact_mps{}, v_swing_mps{};
  std::optional<Measured> k{};  // m_ball x²/MOI, x from the pivot to the impact
  std::vector<Warning> warnings{};
};

/// Computes every result whose readings are given.
/// errors  InputError: values not above 0, a length of at most 0.3048 m, a place that is not between the tip and the
///         pivot, besr and bbcor together.
BatPerformance bat_performance(const BatReadings& readings);

}  // namespace percuss
