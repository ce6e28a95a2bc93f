#include "model/impact/free_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/roots.hpp"
#include "core/units.hpp"

namespace percuss::model {
namespace {

constexpr double kPeakStepsPerPeriod = 20;  // steps of the search for the peak
constexpr double kMaxPeakSteps = 20000;     // faster modes contribute too little to need shorter steps
constexpr double kTouched = 1e-7;           // of the first step: a shorter step means that the gap is closed

// The time for which x + x′t − bound t²/2 stays above zero.
double positive_until_s(double x, double rate, double bound) {
  const double root = std::sqrt(rate * rate + 2 * bound * x);
  return rate > 0 ? (rate + root) / bound : 2 * x / (root - rate);
}

}  // namespace

FreeMotion::FreeMotion(const BallOnBeam& system, const BallOnBeamState& separated)
    : ball_m_(separated.ball_m), ball_mps_(separated.ball_mps) {
  const std::size_t modes = system.modes();
  omega_ = system.omega_radps();
  cosine_.resize(modes);
  sine_.resize(modes);
  for (std::size_t i = 0; i < modes; ++i) {
    const double y = system.weight()[i], omega = omega_[i];
    cosine_[i] = y * separated.eta[i];
    if (omega > 0) {
      sine_[i] = y * separated.rate[i] / omega;
    } else {
      steady_mps_ += y * separated.rate[i];
    }
    bound_mps2_ += omega * omega * std::hypot(cosine_[i], sine_[i]);
    fastest_radps_ = std::max(fastest_radps_, omega);
  }
}

FreeMotion::Point FreeMotion::beam_at(double time_s) const {
  Point point{.value = steady_mps_ * time_s, .rate = steady_mps_};
  for (std::size_t i = 0; i < omega_.size(); ++i) {
    const double c = std::cos(omega_[i] * time_s), s = std::sin(omega_[i] * time_s);
    point.value += cosine_[i] * c + sine_[i] * s;
    point.rate += omega_[i] * (sine_[i] * c - cosine_[i] * s);
  }
  return point;
}

FreeMotion::Point FreeMotion::gap_at(double time_s) const {
  const Point beam = beam_at(time_s);
  return {.value = beam.value - ball_at(time_s), .rate = beam.rate - ball_mps_};
}

std::optional<double> FreeMotion::next_contact_s(double until_s) const {
  const auto [closed_m, opening] = gap_at(0);
  if (!(opening > 0) || !(bound_mps2_ > 0)) return {};
  // At a gap of zero, positive_until_s is 2 opening / bound. Half of it lies after the touch that has just ended and
  // before any other.
  double time_s = opening / bound_mps2_;
  const double min_step_s = std::max(kTouched * time_s, 1e-12 * until_s);
  while (time_s < until_s) {
    const Point gap = gap_at(time_s);
    const double open_m = gap.value - closed_m;
    const double step_s = open_m > 0 ? positive_until_s(open_m, gap.rate, bound_mps2_) : 0;
    if (step_s < min_step_s) return time_s;
    time_s += step_s;
  }
  return {};
}

std::optional<FreeMotion::Peak> FreeMotion::peak(double until_s, double floor_m, double direction) const {
  std::optional<Peak> best;
  const auto beam = [&](double time_s) {
    const Point point = beam_at(time_s);
    return Point{.value = direction * point.value, .rate = direction * point.rate};
  };
  const auto offer = [&](double time_s, double value_m) {
    if (value_m > (best ? best->value_m : floor_m)) best = {.value_m = value_m, .time_s = time_s};
  };
  const double min_step_s =
      std::max(until_s / kMaxPeakSteps, kTwoPi / (kPeakStepsPerPeriod * std::max(fastest_radps_, 1e-300)));
  Point here = beam(0);
  for (double time_s = 0; time_s < until_s;) {
    offer(time_s, here.value);
    const double below = (best ? best->value_m : floor_m) - here.value;
    double step_s = until_s;
    if (bound_mps2_ > 0)
      step_s = below > 0 || here.rate <= 0 ? positive_until_s(below, -here.rate, bound_mps2_) : here.rate / bound_mps2_;
    const double next_s = std::min(until_s, time_s + std::max(min_step_s, step_s));
    const Point next = beam(next_s);
    if (here.rate > 0 && next.rate < 0) {
      const double top_s = bracketed_root([&](double t) { return beam(t).rate; }, time_s, next_s);
      offer(top_s, beam(top_s).value);
    }
    time_s = next_s;
    here = next;
  }
  offer(until_s, here.value);
  return best;
}

}  // namespace percuss::model
