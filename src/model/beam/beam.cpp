#include "model/beam/beam.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "model/beam/timoshenko_mode.hpp"

namespace percuss::model {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;

// cosh λ and sinh λ times 2 e^(−λ), which do not grow with λ; sin λ and cos λ are not scaled.
struct Scaled {
  double e, s, c, ch, sh;
  explicit Scaled(double lambda)
      : e(std::exp(-lambda)), s(std::sin(lambda)), c(std::cos(lambda)), ch(1 + e * e), sh(1 - e * e) {}
  double one_plus_cc() const { return 2 * e + c * ch; }
  double one_minus_cc() const { return 2 * e - c * ch; }
};

// s ch − c sh. Its terms cancel for small λ, so the series Σ (−1)^k 2^(2k+2) λ^(4k+3)/(4k+3)! is used there.
double sine_difference(double lambda, const Scaled& of) {
  if (lambda >= 1) return of.s * of.ch - of.c * of.sh;
  const double fourth = lambda * lambda * lambda * lambda;
  double term = 2 * lambda * lambda * lambda / 3, sum = 0;
  for (int k = 1; std::abs(term) > 1e-18 * std::abs(sum); ++k) {
    sum += term;
    const double n = 4 * k;
    term *= -4 * fourth / (n * (n + 1) * (n + 2) * (n + 3));
  }
  return 2 * of.e * sum;
}

// Elastic modes count from 1.
double pinned_lambda(std::size_t mode) {
  const double from = static_cast<double>(mode) * kHalfTurn_rad;
  return bracketed_root([](double x) { return sine_difference(x, Scaled(x)); }, from, from + kHalfTurn_rad / 2);  // (4)
}

double clamped_lambda(std::size_t mode) {
  const double to = static_cast<double>(mode) * kHalfTurn_rad;
  return bracketed_root([](double x) { return Scaled(x).one_plus_cc(); }, to - kHalfTurn_rad, to);  // (3)
}

double free_lambda(std::size_t mode) {
  const double from = static_cast<double>(mode) * kHalfTurn_rad;
  return bracketed_root([](double x) { return Scaled(x).one_minus_cc(); }, from, from + kHalfTurn_rad);  // (3)
}

double torsion_lambda(std::size_t mode, double relative_torsion) {
  const double spring = relative_torsion / (1 + relative_torsion), hinge = 1 / (1 + relative_torsion);
  const auto difference = [&](double x) {
    const Scaled of(x);
    return hinge * x * sine_difference(x, of) - spring * of.one_plus_cc();  // (2)
  };
  return bracketed_root(difference, mode == 1 ? 0 : pinned_lambda(mode - 1), clamped_lambda(mode));
}

BeamMode supported_mode(double lambda) {
  const Scaled of(lambda);
  const double d = of.one_plus_cc() + of.s * of.sh;
  return {.lambda = lambda,
          .sine = 1,
          .cosine = -sine_difference(lambda, of) / d,
          .far = (1 + of.e * (of.c + of.s)) / d,
          .near = (of.s - of.c - of.e) / d};
}

BeamMode free_mode(double lambda) {
  const Scaled of(lambda);
  const double d = of.sh - 2 * of.e * of.s;
  return {.lambda = lambda,
          .sine = -(of.ch - 2 * of.e * of.c) / d,
          .cosine = 1,
          .far = (of.c - of.s - of.e) / d,
          .near = (1 - of.e * (of.s + of.c)) / d};
}

// A spring of zero or infinite stiffness is a pin or a clamp.
BeamSupport support_of(const UniformBeam& beam) {
  if (beam.support != BeamSupport::torsion) return beam.support;
  const double relative = beam.relative_torsion();
  if (relative == 0) return BeamSupport::pinned;
  return std::isfinite(relative) ? BeamSupport::torsion : BeamSupport::clamped;
}

BeamMode euler_mode(const UniformBeam& beam, std::size_t elastic) {
  switch (beam.support) {
    case BeamSupport::pinned:
      return supported_mode(pinned_lambda(elastic));
    case BeamSupport::clamped:
      return supported_mode(clamped_lambda(elastic));
    case BeamSupport::free:
      return free_mode(free_lambda(elastic));
    default:
      return supported_mode(torsion_lambda(elastic, beam.relative_torsion()));
  }
}

BeamMode elastic_mode(const UniformBeam& beam, std::size_t elastic) {
  BeamMode mode = euler_mode(beam, elastic);
  mode.decay = mode.lambda;
  mode.length_m = beam.length_m;
  const double beta = mode.lambda / beam.length_m;
  mode.omega_radps = beta * beta * std::sqrt(beam.stiffness_Nm2 / beam.mass_per_length_kgpm);  // (5)
  const double end = mode.shape(beam.length_m);
  for (double* part : {&mode.sine, &mode.cosine, &mode.far, &mode.near}) *part /= end;
  mode.norm_m = beam.length_m / 4;  // (6)
  if (beam.support == BeamSupport::torsion) {
    const double turn = mode.slope_1pm(0) * beam.length_m;
    mode.norm_m += beam.length_m * beam.relative_torsion() * turn * turn / (4 * std::pow(mode.lambda, 4));  // (6)
  }
  return mode;
}

std::vector<BeamMode> rigid_modes(const UniformBeam& beam) {
  const double length = beam.length_m;
  if (beam.support == BeamSupport::pinned) return {{.length_m = length, .norm_m = length / 3, .tilt = 1}};
  if (beam.support != BeamSupport::free) return {};
  return {{.length_m = length, .norm_m = length, .offset = 1},
          {.length_m = length, .norm_m = length / 3, .offset = -1, .tilt = 2}};
}

}  // namespace

double BeamMode::shape(double x_m) const {
  const double xi = x_m / length_m, angle = lambda * xi;
  return offset + tilt * xi + sine * std::sin(angle) + cosine * std::cos(angle) + far * std::exp(decay * (xi - 1)) +
         near * std::exp(-decay * xi);  // (1)
}

double BeamMode::slope_1pm(double x_m) const {
  const double xi = x_m / length_m, angle = lambda * xi;
  return (tilt + lambda * (sine * std::cos(angle) - cosine * std::sin(angle)) +
          decay * (far * std::exp(decay * (xi - 1)) - near * std::exp(-decay * xi))) /
         length_m;
}

double BeamMode::freq_Hz() const { return omega_radps / kTwoPi; }

std::vector<BeamMode> beam_modes(const UniformBeam& given, std::size_t count) {
  UniformBeam beam = given;
  beam.support = support_of(given);
  std::vector<BeamMode> modes = rigid_modes(beam);
  modes.resize(std::min(modes.size(), count));
  modes.reserve(count);
  for (std::size_t elastic = 1; modes.size() < count; ++elastic) {
    modes.push_back(beam.is_timoshenko() ? timoshenko_mode(beam, elastic) : elastic_mode(beam, elastic));
    const double omega = modes.back().omega_radps;
    if (!(std::isfinite(omega) && omega > 0)) {
      throw InputError("the beam's frequencies exceed the range of numbers", "stiffness, mass and length",
                       "check EI in N·m², ρA in kg/m and the length in m", {"ei", "rho_a", "length"});
    }
  }
  return modes;
}

std::size_t rigid_body_modes(BeamSupport support) {
  return support == BeamSupport::free ? 2 : support == BeamSupport::pinned ? 1 : 0;
}

std::vector<double> beam_nodes_m(const BeamMode& mode) {
  // A half wave is π/λ of the beam's length. Neighbouring nodes lie almost that far apart.
  constexpr double kPerHalfWave = 8;
  const auto steps = static_cast<std::size_t>(std::ceil(kPerHalfWave * (mode.lambda / kHalfTurn_rad + 1)));
  const auto at = [&](std::size_t i) { return mode.length_m * static_cast<double>(i) / static_cast<double>(steps); };
  const double at_support = std::abs(mode.shape(0));
  std::vector<double> nodes;
  for (std::size_t i = at_support > 1e-9 ? 0 : 1; i < steps; ++i) {
    if ((mode.shape(at(i)) > 0) != (mode.shape(at(i + 1)) > 0))
      nodes.push_back(bracketed_root([&](double x_m) { return mode.shape(x_m); }, at(i), at(i + 1)));
  }
  return nodes;
}

}  // namespace percuss::model
