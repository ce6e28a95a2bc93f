#pragma once
#include <Eigen/Core>

namespace percuss::model {

/// Integrates undamped modes of unit mass under one force in steps of fixed length.
///   q̈ = −ω² q + φ F, F linear in the step: solved exactly                                              (1)
/// shapes: all [modes].
/// theory (12.5)
struct ModalStepper {
  ModalStepper(const Eigen::ArrayXd& omega_radps, const Eigen::ArrayXd& phi, double step_s);

  Eigen::ArrayXd phi;
  double step_s;
  Eigen::ArrayXd cosine, sine_over, sine_times;     // of ωh: cos, sin/ω, ω sin
  Eigen::ArrayXd q_from, q_to, rate_from, rate_to;  // contribution of φF at the start and the end of the step to q, q̇
};

/// Modal amplitudes and their rates.
struct ModalState {
  Eigen::ArrayXd q, rate;

  double deflection(const ModalStepper& stepper) const { return (stepper.phi * q).sum(); }
  /// Advances by one step, without the contribution of the force at its end.
  void advance(const ModalStepper& stepper, double force_at_start_N);
  /// Adds the contribution of the force at the end of the step.
  void add_end(const ModalStepper& stepper, double force_at_end_N);
};

}  // namespace percuss::model
