#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// A pole s and its derivatives by its frequency (in rad/s) and damping ratio.
struct PoleTerms {
  double omega, zeta;
  Complex s, by_omega, by_zeta;
};
PoleTerms terms_of(const Pole& pole);

/// The state q_h of a mode at the end of a hit's record, (1) in mode_column(), and dq_h/ds. [hits]
struct EndStates {
  std::vector<Complex> q, q_by_s;
};

/// The truncation term of a mode in (1). Its factors c·D are common to all points; the states q_h differ.
class Truncation {
 public:
  /// c·D at one line and its derivative by s at constant ω_d, for the pole and for its conjugate.
  struct Factors {
    Complex value, by_s, mirror, mirror_by_s;
  };

  Truncation(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines);

  /// [count] the factors at lines first … first + count − 1.
  std::vector<Factors> factors(std::size_t first, std::size_t count) const;
  EndStates end_states(const PointForce& force) const;
  /// Subtracts the term from the column's value and, by the chain rule, from its derivatives. factors [lines]
  void subtract_from(ModeColumn& column, const std::vector<Factors>& factors, const PointForce& force,
                     std::size_t first) const;

 private:
  acquire::LineRange lines_;
  PoleTerms terms_;
  Complex windowed_;  // s − σ
};

}  // namespace percuss::identify
