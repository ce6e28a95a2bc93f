#include "model/beam/timoshenko_mode.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "core/units.hpp"

namespace percuss::model {
namespace {

constexpr double kHalfWave_rad = std::numbers::pi;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// The waves at one frequency; lengths in units of the beam's length.
struct Waves {
  double omega_radps = 0;
  double b = 0, a = 0;  // λ and δ; a² below zero gives a = NaN
  double bend = 0;      // b² − g (g of the header): φ' = −bend·w for w = sin and cos
  double lean = 0;      // a² + g: φ' = lean·w for exponentials w
};

// Rotary inertia and shear flexibility in units of the beam's length.
struct Thickness {
  double inertia = 0;  // ρI/(ρA L²)
  double shear = 0;    // EI/(κGA L²)
};

Thickness thickness_of(const UniformBeam& beam) {
  const double length2 = beam.length_m * beam.length_m;
  return {.inertia = beam.gyration_m * beam.gyration_m / length2,
          .shear = beam.shear_stiffness_N > 0 ? beam.stiffness_Nm2 / (beam.shear_stiffness_N * length2) : 0};
}

Waves waves_of(const UniformBeam& beam, double lambda) {
  const auto [inertia, shear] = thickness_of(beam);
  const double b2 = lambda * lambda;
  const double p = 1 + b2 * (shear + inertia);
  const double w2 = 2 * b2 * b2 / (p + std::sqrt(p * p - 4 * shear * inertia * b2 * b2));  // ρA L⁴ ω²/EI by (2)
  Waves waves{.b = lambda};
  waves.omega_radps =
      std::sqrt(w2) * std::sqrt(beam.stiffness_Nm2 / beam.mass_per_length_kgpm) / (beam.length_m * beam.length_m);
  waves.a = std::sqrt(w2 * (1 - w2 * shear * inertia) / b2);  // (3)
  waves.bend = b2 - shear * w2;
  waves.lean = waves.a * waves.a + shear * w2;
  return waves;
}

// The λ at the cut-off frequency, where (3) is zero, less a relative 1e-9.
double last_lambda(const UniformBeam& beam) {
  if (!(beam.gyration_m > 0 && beam.shear_stiffness_N > 0)) return kNoLimit;
  const auto [inertia, shear] = thickness_of(beam);
  return (1 - 1e-9) * std::sqrt((shear + inertia) / (shear * inertia));
}

// The free-free condition for modes that are even or odd about the middle: each root lies on its own branch.
double free_condition(const Waves& w, bool even) {
  const double t = std::tanh(w.a / 2), s = std::sin(w.b / 2), c = std::cos(w.b / 2);
  return even ? w.a * w.lean * s + w.b * w.bend * c * t : w.a * w.lean * c * t - w.b * w.bend * s;
}

// The determinant times 2 e^(−δ): the sum of a term for the spring and a term for the hinge.
double boundary_condition(const Waves& w, double spring, double hinge) {
  const double e = std::exp(-w.a), ch = 1 + e * e, sh = 1 - e * e, s = std::sin(w.b), c = std::cos(w.b);
  const double ka = w.lean / w.a, kb = w.bend / w.b;
  const double hinge_term = w.lean * sh * c / w.b - w.bend * s * ch / w.a;
  const double spring_term = ka * (w.lean * c * ch / w.b + 2 * e * w.bend / w.b - w.bend * s * sh / w.a) +
                             kb * (2 * e * w.lean / w.a + w.lean * s * sh / w.b + w.bend * c * ch / w.a);
  return spring * spring_term + hinge * (w.a * w.a + w.b * w.b) * hinge_term;
}

// The only root between low and high, or none when it lies beyond the last λ.
template <class Condition>
std::optional<double> lambda_between(const UniformBeam& beam, double low, double high, const Condition& condition) {
  const auto f = [&](double lambda) { return condition(waves_of(beam, lambda)); };
  const double end = std::min(high, last_lambda(beam));
  if (!(low < end) || (end < high && (f(low) > 0) == (f(end) > 0))) return {};
  return bracketed_root(f, low, end);
}

std::optional<double> pinned_timoshenko(const UniformBeam& beam, std::size_t elastic) {
  const double from = static_cast<double>(elastic) * kHalfWave_rad;
  return lambda_between(beam, from, from + kHalfWave_rad / 2,
                        [](const Waves& w) { return boundary_condition(w, 0, 1); });
}

std::optional<double> sprung_timoshenko(const UniformBeam& beam, std::size_t elastic) {
  const double relative = beam.support == BeamSupport::clamped ? kNoLimit : beam.relative_torsion();
  const double hinge = 1 / (1 + relative), spring = 1 - hinge;
  const std::optional<double> low = elastic > 1 ? pinned_timoshenko(beam, elastic - 1)
                                                : 0.5 * std::min(1.0, std::pow(3 * relative, 0.25));  // T* ≈ λ⁴/3
  if (!low) return {};
  return lambda_between(beam, *low, pinned_timoshenko(beam, elastic).value_or(kNoLimit),
                        [&](const Waves& w) { return boundary_condition(w, spring, hinge); });
}

std::optional<double> timoshenko_lambda(const UniformBeam& beam, std::size_t elastic) {
  if (beam.support == BeamSupport::pinned) return pinned_timoshenko(beam, elastic);
  if (beam.support != BeamSupport::free) return sprung_timoshenko(beam, elastic);
  const double from = static_cast<double>(elastic) * kHalfWave_rad;
  return lambda_between(beam, from, from + kHalfWave_rad,
                        [&](const Waves& w) { return free_condition(w, elastic % 2 == 1); });
}

}  // namespace

BeamMode timoshenko_mode(const UniformBeam& beam, std::size_t elastic) {
  const std::optional<double> lambda = timoshenko_lambda(beam, elastic);
  if (!lambda) {
    throw InputError("too many modes: above its cut-off frequency a Timoshenko beam carries two kinds of wave",
                     fmt::format("{:.6g} Hz", waves_of(beam, last_lambda(beam)).omega_radps / kTwoPi),
                     "ask for fewer modes", {"modes"});
  }
  const Waves w = waves_of(beam, *lambda);
  const double e = std::exp(-w.a), s = std::sin(w.b), c = std::cos(w.b);
  const double kb = w.bend / w.b, ka = w.lean / w.a;
  // Columns sin, cos, e^(−δ(1−ξ)), e^(−δξ). Rows: φ' and w' − φ at the free end; at x = 0 the same for a free beam,
  // else w and the balance of moments (φ alone for a clamp).
  Eigen::Matrix4d ends;
  ends.row(0) << -w.bend * s, -w.bend * c, w.lean, w.lean * e;
  ends.row(1) << c / w.b, -s / w.b, -1 / w.a, e / w.a;
  if (beam.support == BeamSupport::free) {
    ends.row(2) << 0, -w.bend, w.lean * e, w.lean;
    ends.row(3) << 1 / w.b, 0, -e / w.a, 1 / w.a;
  } else {
    const bool clamped = beam.support == BeamSupport::clamped;
    const double spring = clamped ? 1 : beam.support == BeamSupport::pinned ? 0 : beam.relative_torsion();
    ends.row(2) << 0, 1, e, 1;
    ends.row(3) << spring * kb, 0, spring * ka * e, -spring * ka;
    if (!clamped) ends.row(3) -= Eigen::RowVector4d(0, -w.bend, w.lean * e, w.lean);
  }
  for (int row = 0; row < 4; ++row) ends.row(row).normalize();
  const Eigen::Vector4d x = Eigen::JacobiSVD<Eigen::Matrix4d>(ends, Eigen::ComputeFullV).matrixV().col(3);
  const double end = x(0) * s + x(1) * c + x(2) + x(3) * e;
  return {.lambda = w.b,
          .decay = w.a,
          .omega_radps = w.omega_radps,
          .length_m = beam.length_m,
          .sine = x(0) / end,
          .cosine = x(1) / end,
          .far = x(2) / end,
          .near = x(3) / end};
}

}  // namespace percuss::model
