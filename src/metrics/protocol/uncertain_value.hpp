#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace percuss::metrics {

/// The readings from which results are computed; each has its own error.
enum class Reading : std::size_t {
  length,
  weight,
  cg,
  period,
  moi,
  ball,
  location,
  inbound,
  rebound,
  swing,
  given_besr,
  given_bbcor
};
inline constexpr std::size_t kReadings = 12;

/// A value with first-order error propagation; the errors of different readings are independent:
///   f(x + δ) = f(x) + Σ_i ∂f/∂x_i δ_i,   σ_f² = Σ_i (∂f/∂x_i σ_i)²                            (P0)
/// Contributions of the same reading add before they are squared, so they may cancel.
class UncertainValue {
 public:
  UncertainValue() = default;
  UncertainValue(double exact) : value_(exact) {}  // NOLINT(google-explicit-constructor): constants of the equations
  /// A standard deviation of 0 means that it is unknown.
  UncertainValue(double value, double std, Reading reading) : value_(value) {
    parts_.at(static_cast<std::size_t>(reading)) = std;
    if (std == 0) unknown_ = 1U << static_cast<unsigned>(reading);
  }

  double value() const { return value_; }
  double std() const {
    double sum = 0;
    for (const double part : parts_) sum += part * part;
    return std::sqrt(sum);
  }
  double part(Reading reading) const { return parts_.at(static_cast<std::size_t>(reading)); }

  /// Whether the value depends on a reading of unknown error, which std() does not include.
  bool unknown(Reading reading) const { return ((unknown_ >> static_cast<unsigned>(reading)) & 1U) != 0; }

  friend UncertainValue operator+(const UncertainValue& a, const UncertainValue& b) {
    return combined(a.value_ + b.value_, 1, a, 1, b);
  }
  friend UncertainValue operator-(const UncertainValue& a, const UncertainValue& b) {
    return combined(a.value_ - b.value_, 1, a, -1, b);
  }
  friend UncertainValue operator*(const UncertainValue& a, const UncertainValue& b) {
    return combined(a.value_ * b.value_, b.value_, a, a.value_, b);
  }
  friend UncertainValue operator/(const UncertainValue& a, const UncertainValue& b) {
    const double quotient = a.value_ / b.value_;
    return combined(quotient, 1 / b.value_, a, -quotient / b.value_, b);
  }
  friend UncertainValue pow(const UncertainValue& a, double exponent) {
    const double power = std::pow(a.value_, exponent);
    return combined(power, exponent * power / a.value_, a, 0, a);
  }

 private:
  using Parts = std::array<double, kReadings>;
  static UncertainValue combined(double value, double by_a, const UncertainValue& a, double by_b,
                                 const UncertainValue& b) {
    UncertainValue out(value);
    for (std::size_t i = 0; i < kReadings; ++i) out.parts_[i] = by_a * a.parts_[i] + by_b * b.parts_[i];
    out.unknown_ = a.unknown_ | b.unknown_;
    return out;
  }

  double value_ = 0;
  Parts parts_{};  // ∂f/∂x_i σ_i
  unsigned unknown_ = 0;
};

}  // namespace percuss::metrics
