#pragma once
#include <Eigen/Core>

namespace percuss::model {

/// Undamped modes of unit mass under one force, a step of fixed length at a time.
///   q̈ = −ω² q + φ F, F linear in the step: solved exactly                                              (1)
/// shapes: all [modes].
/// theory (12.5)
struct ModalStepper {
  ModalStepper(const Eigen::ArrayXd& omega_radps, const Eigen::ArrayXd& phi, double step_s);

  Eigen::ArrayXd phi;
  double step_s;
  Eigen::ArrayXd cosine, sine_over, sine_times;     // of ωh: cos, sin/ω, ω sin
  Eigen::ArrayXd q_from, q_to, rate_from, rate_to;  // what φF at the step's start and end adds to q and q̇
};

/// Amplitudes and their rates.
struct ModalState {
  Eigen::ArrayXd q, rate;

  double deflection(const ModalStepper& stepper) const { return (stepper.phi * q).sum(); }
  /// The step without what the force at its end will add.
  void advance(const ModalStepper& stepper, double force_at_start_N);
  void add_end(const ModalStepper& stepper, double force_at_end_N);
};

}  // namespace percuss::model
