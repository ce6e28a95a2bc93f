#include "identify/classify/asymmetry_split.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percuss::identify {
namespace {

using std::numbers::pi;

constexpr double kMinPlaneSine = 0.2;         // sine of n times the angle between the sensors
constexpr double kHidden_dB = 20;             // level difference at which the second peak hides the first
constexpr double kPatternError_rad = 0.0873;  // 5°: departure of measured shapes from cos n(θ − plane)
constexpr double kMinAngleSignificance = 3;   // standard deviations of an angle that differs from zero

// Amplitudes at the two sensors over all impact points, and their standard deviations. The second amplitude is negative
// where the sensors move in opposite phase.
struct SensorAmplitudes {
  double first = 0, second = 0, first_std = 0, second_std = 0;
};

SensorAmplitudes amplitudes(const Mode& mode, const SensorPair& sensors) {
  Complex cross;
  double a = 0, b = 0, a_noise = 0, b_noise = 0;
  for (const Residue& r : mode.residues) {
    if (r.channel != sensors.first) continue;
    for (const Residue& s : mode.residues) {
      if (s.channel != sensors.second || s.point != r.point) continue;
      cross += std::conj(r.value) * s.value;
      a += std::norm(r.value);
      b += std::norm(s.value);
      a_noise = std::max(a_noise, r.std);
      b_noise = std::max(b_noise, s.std);
    }
  }
  return {std::sqrt(a), std::copysign(std::sqrt(b), cross.real()), a_noise, b_noise};
}

double peak_height(const Mode& mode) {
  double sum = 0;
  for (const Residue& r : mode.residues) sum += std::norm(r.value);
  return std::sqrt(sum) / (2 * std::max(mode.pole.damping_ratio, 1e-12));
}

// Angle between two planes with period π/n: 0 … π/2n.
double between(const PatternPlane& a, const PatternPlane& b) {
  return std::abs(std::remainder(a.plane_rad - b.plane_rad, pi / a.order));
}

SplitCause cause_of(double between_rad, double std_rad, int order) {
  const double tolerance_rad = std::max(kMinAngleSignificance * std_rad, kPatternError_rad);
  const double asymmetry_rad = pi / (2 * order);                       // between the planes of an asymmetry split
  if (2 * tolerance_rad >= asymmetry_rad) return SplitCause::unclear;  // too uncertain
  if (asymmetry_rad - between_rad <= tolerance_rad) return SplitCause::asymmetry;
  return between_rad <= tolerance_rad ? SplitCause::coupled : SplitCause::unclear;
}

}  // namespace

const char* name_of(SplitCause cause) {
  switch (cause) {
    case SplitCause::asymmetry:
      return "asymmetry";
    case SplitCause::coupled:
      return "coupled";
    case SplitCause::unclear:
      return "unclear";
  }
  return "";
}

std::optional<PatternPlane> plane_from_sensors(const Mode& mode, const SensorPair& sensors, int order,
                                               double angle_std_rad) {
  const double n = order;
  const double turn = std::sin(n * (sensors.second_rad - sensors.first_rad));
  const SensorAmplitudes a = amplitudes(mode, sensors);
  if (order < 1 || std::abs(turn) < kMinPlaneSine || !(std::hypot(a.first, a.second) > 0)) return std::nullopt;
  // Solves A_c = C cos nθ_c + S sin nθ_c for C and S; n times the plane's angle is atan2(S, C).
  const double c1 = std::cos(n * sensors.first_rad), s1 = std::sin(n * sensors.first_rad);
  const double c2 = std::cos(n * sensors.second_rad), s2 = std::sin(n * sensors.second_rad);
  const double c = (a.first * s2 - a.second * s1) / turn, s = (a.second * c1 - a.first * c2) / turn;
  const double size = c * c + s * s;
  // ∂ atan2(S, C)/∂A_c = (C ∂S − S ∂C)/(C² + S²)
  const double by_first = (-c * c2 - s * s2) / turn / size, by_second = (c * c1 + s * s1) / turn / size;
  const double from_noise = std::hypot(by_first * a.first_std, by_second * a.second_std);
  const double slope1 = n * (s * c1 - c * s1), slope2 = n * (s * c2 - c * s2);  // ∂A_c/∂θ_c
  const double from_placement = angle_std_rad * std::hypot(by_first * slope1, by_second * slope2);
  const double period = pi / n, plane = std::atan2(s, c) / n;
  return PatternPlane{.plane_rad = plane - period * std::floor(plane / period),
                      .std_rad = std::hypot(from_noise, from_placement) / n,
                      .order = order};
}

void describe_split(const Mode& first, const Mode& second, const std::optional<PatternPlane>& first_plane,
                    const std::optional<PatternPlane>& second_plane, SplitMode& of_first, SplitMode& of_second) {
  const double height = peak_height(second) > 0 ? peak_height(first) / peak_height(second) : 1;
  const double height_dB = 20 * std::log10(std::clamp(height, 1e-15, 1e15));
  of_first.quoted = height_dB > -kHidden_dB;
  of_second.quoted = !of_first.quoted;
  for (SplitMode* peak : {&of_first, &of_second}) {
    peak->separation_std_Hz = std::hypot(first.freq_std_Hz, second.freq_std_Hz);
    peak->first_over_second_dB = height_dB;
    peak->planes.reset();
  }
  if (!first_plane || !second_plane || first_plane->order != second_plane->order) return;
  const double between_rad = between(*first_plane, *second_plane);
  const double std_rad = std::hypot(first_plane->std_rad, second_plane->std_rad);
  const SplitCause cause = cause_of(between_rad, std_rad, first_plane->order);
  of_first.planes = SplitPlanes{*first_plane, between_rad, std_rad, cause};
  of_second.planes = SplitPlanes{*second_plane, between_rad, std_rad, cause};
}

}  // namespace percuss::identify
