#include "metrics/deflection/baseline_noise.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "core/math/fft.hpp"
#include "core/math/significance.hpp"
#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "metrics/deflection/laplace_transform.hpp"
#include "metrics/deflection/window_mean.hpp"

namespace percuss::metrics {
namespace {

using Eigen::Index;

constexpr std::size_t kMinRestSamples = 64;
// The strengths of one signal: 1/f noise that is as strong as its white noise at 2⁻⁴ Hz … 2²⁰ Hz.
constexpr double kLowestCorner_Hz = 1.0 / 16, kHighestCorner_Hz = 1 << 20;
constexpr double kStrengthsPerOctave = 2, kLowestOctave = -80;
constexpr double kMinLogGain = 3;       // of 1/f noise over white noise
constexpr double kExcluded = 4.5;       // log likelihood below the largest: exceeded by chance once in 400 times
constexpr double kContradicts = 5;      // normal deviate of the late deflection, exceeded once in three million
constexpr double kMinPeriods = 4;       // of the strongest motion, in a window
constexpr double kMinWindows = 6;       // that would cover the moving signal side by side, if the periods permit
constexpr double kMaxWindow = 2.0 / 3;  // of the moving signal
constexpr double kAboveNoise = 10;      // power of a line over the noise: exceeded by noise once in 20000 lines
constexpr double kHum = 100;            // power of a line at rest over the median of its neighbours
constexpr std::size_t kHumLines = 32;   // faster hum hardly changes the means of blocks: samples per period
constexpr std::size_t kLinesAtOnce = 8;
constexpr std::size_t kRotations = 256;      // from one sine and cosine: they keep 13 digits
constexpr std::size_t kMaxSummed = 1 << 14;  // longer rests are faster transformed
constexpr double kLobe = 4;                  // largest ratio of the powers of neighbouring lines of two grids
constexpr double kKnotRatio = 1.1;           // of the times at which a standard deviation is computed

std::vector<double> hann_windowed(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  std::vector<double> windowed(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) windowed[i] = x[i] * (1 - std::cos(kTwoPi * static_cast<double>(i) / n));
  return windowed;
}

// The power of kLinesAtOnce spectral lines from `first` on, from their sums: a transform of a length of its own would
// need a plan, which takes longer than some hundred lines.
std::array<double, kLinesAtOnce> powers_from(std::size_t first, std::span<const double> windowed) {
  std::array<double, kLinesAtOnce> real{}, imag{}, cosine{}, sine{}, step_cosine{}, step_sine{}, power{};
  const auto angle = [&](std::size_t l, std::size_t i) {
    return kTwoPi * static_cast<double>((first + l) * i % windowed.size()) / static_cast<double>(windowed.size());
  };
  for (std::size_t l = 0; l < kLinesAtOnce; ++l) {
    step_cosine[l] = std::cos(angle(l, 1));
    step_sine[l] = std::sin(angle(l, 1));
  }
  for (std::size_t begin = 0; begin < windowed.size(); begin += kRotations) {
    for (std::size_t l = 0; l < kLinesAtOnce; ++l) {
      cosine[l] = std::cos(angle(l, begin));
      sine[l] = std::sin(angle(l, begin));
    }
    const std::size_t end = std::min(windowed.size(), begin + kRotations);
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t l = 0; l < kLinesAtOnce; ++l) {
        real[l] += windowed[i] * cosine[l];
        imag[l] += windowed[i] * sine[l];
        const double next = cosine[l] * step_cosine[l] - sine[l] * step_sine[l];
        sine[l] = sine[l] * step_cosine[l] + cosine[l] * step_sine[l];
        cosine[l] = next;
      }
    }
  }
  for (std::size_t l = 0; l < kLinesAtOnce; ++l) power[l] = real[l] * real[l] + imag[l] * imag[l];
  return power;
}

// The power of the lines 0 … count − 1, count <= N/2 + 1.
std::vector<double> first_powers(std::span<const double> windowed, std::size_t count) {
  std::vector<double> power;
  if (windowed.size() > kMaxSummed) {
    const std::vector<Complex> lines = real_dft(windowed);
    for (std::size_t k = 0; k < count; ++k) power.push_back(std::norm(lines[k]));
    return power;
  }
  for (std::size_t k = 0; k < count; k += kLinesAtOnce) {
    const auto some = powers_from(k, windowed);
    power.insert(power.end(), some.begin(), some.end());
  }
  power.resize(count);
  return power;
}

// Whether a sinusoid stands out of the samples at rest. Such a line is no noise, and its phase is not random.
bool has_hum(std::span<const double> residual) {
  const std::size_t lines = residual.size() / 2 + 1, end = std::min(lines, residual.size() / kHumLines + 1);
  if (end < 5) return false;
  const std::vector<double> power = first_powers(hann_windowed(residual), std::min(lines, end + 6));
  const auto line = static_cast<std::size_t>(
      std::max_element(power.begin() + 3, power.begin() + static_cast<std::ptrdiff_t>(end)) - power.begin());
  std::vector<double> beside;
  for (std::size_t k = line - std::min<std::size_t>(line - 1, 6); k < std::min(line + 7, power.size()); ++k) {
    if (k + 2 < line || k > line + 2) beside.push_back(power[k]);
  }
  return power[line] > kHum * median(beside);
}

// The frequency of the strongest line of the deflection that is not noise: the slowest motion to expect. A padded
// transform, of a length that the integration has planned already, shows which lines to compute. The main lobe of the
// window is four lines wide, so the power at a line is at most kLobe times its neighbour's power on this finer grid.
std::optional<double> strongest_motion_Hz(std::span<const double> accel, double fs_Hz, double white, double flicker) {
  const std::vector<double> windowed = hann_windowed(accel);
  const auto n = static_cast<double>(accel.size());
  const auto freq_Hz = [&](std::size_t k) { return static_cast<double>(k) * fs_Hz / n; };
  // 3/2 n: the sum of the squared window.
  const auto least_power = [&](std::size_t k) {
    return kAboveNoise * 1.5 * n * (white + flicker / freq_Hz(k)) * fs_Hz / 2;
  };
  std::vector<double> padded(LaplaceTransform::padded_length(accel.size()));
  std::copy(windowed.begin(), windowed.end(), padded.begin());
  const std::span<const Complex> fine = real_dft_in_scratch(padded);
  std::vector<std::pair<double, std::size_t>> near;  // approximate strength of a line of the deflection
  // Lines 0 to 2 contain bias and drift.
  for (std::size_t k = 3; k < accel.size() / 2 + 1; ++k) {
    const double power = kLobe * std::norm(fine[std::min(fine.size() - 1, k * padded.size() / accel.size())]);
    if (power > least_power(k)) near.emplace_back(power / std::pow(freq_Hz(k), 4), k);
  }
  std::sort(near.begin(), near.end(), std::greater<>());
  std::optional<double> best;
  double largest = 0;
  for (const auto& [at_most, k] : near) {
    if (at_most < largest) break;
    const double power = powers_from(k, windowed).front();
    const double deflection = power / std::pow(freq_Hz(k), 4);
    if (!(power > least_power(k)) || !(deflection > largest)) continue;
    best = freq_Hz(k);
    largest = deflection;
  }
  return best;
}

}  // namespace

struct BaselineNoise::Regression {
  bool solved = false;
  Eigen::LLT<Eigen::MatrixXd> covariance;
  Eigen::MatrixXd weighted_lines;  // C⁻¹ X
  Eigen::Matrix2d line_covariance;
  Eigen::Vector2d line;               // bias and drift, in addition to the line subtracted
  Eigen::VectorXd weighted_residual;  // C⁻¹ (y − X·line)
  double chi2 = 0, log_likelihood = -std::numeric_limits<double>::infinity();
};

double flicker_strength_at(std::size_t i) {
  return std::exp2(kLowestOctave + static_cast<double>(i) / kStrengthsPerOctave);
}

double flicker_strength(std::span<const double> log_gains) {
  if (log_gains.empty()) return 0;
  const double most = *std::max_element(log_gains.begin(), log_gains.end());
  if (!(most > kMinLogGain)) return 0;
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < log_gains.size(); ++i) {
    if (!(log_gains[i] > 0)) continue;
    const double weight = std::exp(log_gains[i] - most);
    sum += weight * flicker_strength_at(i);
    weights += weight;
  }
  return sum / weights;
}

BaselineNoise::BaselineNoise(const BaselineEstimate& rest, const MovingSignal& signal)
    : fs_Hz_(signal.fs_Hz), corner_Hz_(signal.highpass_corner_Hz), samples_(signal.accel_mps2.size()) {
  const std::vector<double>& residual = rest.residual_mps2;
  if (residual.size() < kMinRestSamples || samples_ < kMinRestSamples) return;
  double squares = 0;
  for (const double value : residual) squares += value * value;
  sample_noise_mps2_ = std::sqrt(squares / static_cast<double>(residual.size() - 2));
  if (!(sample_noise_mps2_ > 0) || has_hum(residual)) return;
  usable_ = true;
  blocks_ = baseline_blocks(residual.size(), samples_, fs_Hz_);
  flicker_ = flicker_covariance(blocks_, fs_Hz_);
  observe_rest(residual);
  const std::vector<double> at_rest = log_likelihoods(at_rest_);
  const double most = std::max(*std::max_element(at_rest.begin(), at_rest.end()),
                               regression(at_rest_, 0, sample_noise_mps2_).log_likelihood);
  double strongest = flicker_strength_at(0);  // that the samples at rest permit
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    if (at_rest[i] > most - kExcluded) strongest = flicker_strength_at(i);
  }
  if (signal.may_return) {
    const double white = 2 * sample_noise_mps2_ * sample_noise_mps2_ / fs_Hz_;
    const auto motion_Hz = strongest_motion_Hz(signal.accel_mps2, fs_Hz_, white, strongest);
    if (motion_Hz) observe_windows(signal, *motion_Hz);
  }
  const Index all = seen_.value.size();
  std::vector<double> likelihoods = at_rest;
  if (all > at_rest_) {
    std::vector<double> together = log_likelihoods(all);
    const double strength = std::min(mean_strength(together), strongest);
    const double late =
        regression(all, strength, sample_noise_mps2_).chi2 - regression(at_rest_, strength, sample_noise_mps2_).chi2;
    returns_ = chi2_deviate(std::max(0.0, late), static_cast<double>(all - at_rest_)) < kContradicts;
    if (returns_) likelihoods = std::move(together);
  }
  const double as_white = regression(returns_ ? all : at_rest_, 0, sample_noise_mps2_).log_likelihood;
  usable_ = std::isfinite(as_white);
  if (!usable_) return;
  for (const double one : likelihoods) log_gains_.push_back(one - as_white);
}

void BaselineNoise::observe_rest(const std::vector<double>& residual_mps2) {
  at_rest_ = static_cast<Index>(blocks_.at_rest);
  const auto blocks = static_cast<Index>(blocks_.size());
  seen_.value.resize(at_rest_);
  seen_.by_line.resize(at_rest_, 2);
  seen_.by_block = Eigen::MatrixXd::Identity(at_rest_, blocks);
  seen_.white = Eigen::MatrixXd::Zero(at_rest_, at_rest_);
  seen_.leakage_m = Eigen::VectorXd::Zero(at_rest_);
  for (Index b = 0; b < at_rest_; ++b) {
    const auto block = static_cast<std::size_t>(b);
    const std::size_t from = blocks_.first[block], to = blocks_.first[block + 1];
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += residual_mps2[i];
    seen_.value(b) = sum / static_cast<double>(to - from);
    seen_.by_line.row(b) << 1, blocks_.middle_s(block);
    seen_.white(b, b) = 1 / static_cast<double>(to - from);
  }
  seen_.flicker = flicker_.topLeftCorner(at_rest_, at_rest_);
}

void BaselineNoise::observe_windows(const MovingSignal& signal, double lowest_Hz) {
  const double length_s = static_cast<double>(samples_) / fs_Hz_;
  const double window = std::max(1 / kMinWindows, kMinPeriods / (lowest_Hz * length_s));  // of the moving signal
  if (window > kMaxWindow) return;
  const auto windows = static_cast<Index>((1 - window) / (window / 2) + 1e-9) + 1;
  const Index all = at_rest_ + windows, blocks = static_cast<Index>(blocks_.size());
  seen_.value.conservativeResize(all);
  seen_.by_line.conservativeResize(all, 2);
  seen_.by_block.conservativeResize(all, blocks);
  seen_.by_block.bottomRows(windows).setZero();
  seen_.leakage_m.conservativeResize(all);
  Eigen::MatrixXd by_noise(windows, static_cast<Index>(samples_));
  for (Index j = 0; j < windows; ++j) {
    const double from = (1 - window) * static_cast<double>(j) / static_cast<double>(windows - 1), to = from + window;
    const WindowMean mean = window_mean(signal.deflection_m, fs_Hz_, corner_Hz_, from, to);
    const Index row = at_rest_ + j;
    seen_.value(row) = mean.mean_m;
    seen_.by_line.row(row) = mean.by_bias.transpose();
    seen_.leakage_m(row) =
        hann_leakage_m(parabola_residual(signal.deflection_m, from, to).amplitude_m, window * length_s * lowest_Hz);
    by_noise.row(j) = Eigen::Map<const Eigen::RowVectorXd>(mean.by_noise.data(), static_cast<Index>(samples_));
  }
  for (std::size_t b = blocks_.at_rest; b < blocks_.size(); ++b) {
    for (std::size_t i = blocks_.first[b]; i < blocks_.first[b + 1]; ++i) {
      seen_.by_block.col(static_cast<Index>(b)).tail(windows) +=
          by_noise.col(static_cast<Index>(i - blocks_.first[blocks_.at_rest]));
    }
  }
  Eigen::MatrixXd white = Eigen::MatrixXd::Zero(all, all);
  white.topLeftCorner(at_rest_, at_rest_) = seen_.white;
  auto of_windows = white.bottomRightCorner(windows, windows);
  Index first = 0;  // the windows before it have ended
  for (Index i = 0; i < by_noise.cols(); ++i) {
    while (first < windows && by_noise(first, i) == 0) ++first;
    for (Index b = first; b < windows; ++b) {
      const double weight = by_noise(b, i);
      for (Index a = b; a < windows; ++a) of_windows(a, b) += by_noise(a, i) * weight;
    }
  }
  of_windows.triangularView<Eigen::StrictlyUpper>() = of_windows.transpose().eval();
  seen_.white = std::move(white);
  seen_.flicker = seen_.by_block * flicker_ * seen_.by_block.transpose();
}

// Least squares for bias and drift with the first of the observations, and their restricted likelihood.
BaselineNoise::Regression BaselineNoise::regression(Index observations, double strength, double noise_mps2) const {
  Regression out;
  Eigen::MatrixXd covariance = noise_mps2 * noise_mps2 * seen_.white.topLeftCorner(observations, observations) +
                               strength * seen_.flicker.topLeftCorner(observations, observations);
  covariance.diagonal() += seen_.leakage_m.head(observations).cwiseAbs2();
  out.covariance.compute(covariance);
  if (out.covariance.info() != Eigen::Success) return out;
  const auto lines = seen_.by_line.topRows(observations);
  out.weighted_lines = out.covariance.solve(lines);
  const Eigen::Matrix2d normal = lines.transpose() * out.weighted_lines;
  out.line_covariance = normal.inverse();
  out.line = out.line_covariance * (out.weighted_lines.transpose() * seen_.value.head(observations));
  const Eigen::VectorXd residual = seen_.value.head(observations) - lines * out.line;
  out.weighted_residual = out.covariance.solve(residual);
  out.chi2 = residual.dot(out.weighted_residual);
  double log_determinant = std::log(normal.determinant());
  for (Index i = 0; i < observations; ++i) log_determinant += 2 * std::log(out.covariance.matrixLLT()(i, i));
  if (std::isfinite(out.chi2) && std::isfinite(log_determinant)) {
    out.solved = true;
    out.log_likelihood = -(out.chi2 + log_determinant) / 2;
  }
  return out;
}

// At each strength. Weaker noise than the signal's range counts as none, stronger noise as impossible.
std::vector<double> BaselineNoise::log_likelihoods(Index observations) const {
  const double white = 2 * sample_noise_mps2_ * sample_noise_mps2_ / fs_Hz_;
  const double without = regression(observations, 0, sample_noise_mps2_).log_likelihood;
  std::vector<double> out(kFlickerStrengths, -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double strength = flicker_strength_at(i);
    if (strength < kLowestCorner_Hz * white) {
      out[i] = without;
    } else if (strength <= kHighestCorner_Hz * white) {
      out[i] = regression(observations, strength, sample_noise_mps2_).log_likelihood;
    }
  }
  return out;
}

// The mean over the signal's range, each strength with the weight of its likelihood.
double BaselineNoise::mean_strength(const std::vector<double>& log_likelihoods) const {
  const double white = 2 * sample_noise_mps2_ * sample_noise_mps2_ / fs_Hz_;
  const double most = *std::max_element(log_likelihoods.begin(), log_likelihoods.end());
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < log_likelihoods.size(); ++i) {
    const double strength = flicker_strength_at(i);
    if (strength < kLowestCorner_Hz * white) continue;
    const double weight = std::exp(log_likelihoods[i] - most);
    sum += weight * strength;
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

std::optional<BaselineNoise::Error> BaselineNoise::error_at(double strength) const {
  if (!usable_) return std::nullopt;
  const Index used = returns_ ? seen_.value.size() : at_rest_, blocks = static_cast<Index>(blocks_.size());
  const Regression fit = regression(used, strength, sample_noise_mps2_);
  if (!fit.solved) return std::nullopt;
  Eigen::MatrixXd lines(blocks, 2);
  for (Index b = 0; b < blocks; ++b) lines.row(b) << 1, blocks_.middle_s(static_cast<std::size_t>(b));
  const Eigen::MatrixXd shared = strength * flicker_ * seen_.by_block.topRows(used).transpose();
  const Eigen::VectorXd flicker = shared * fit.weighted_residual;
  const Eigen::MatrixXd by_line = lines - shared * fit.weighted_lines;
  const Eigen::MatrixXd covariance = strength * flicker_ - shared * fit.covariance.solve(shared.transpose()) +
                                     by_line * fit.line_covariance * by_line.transpose();
  Error out{.accel_mps2 = std::vector<double>(samples_), .std_m = std::vector<double>(samples_)};
  for (std::size_t b = blocks_.at_rest; b < blocks_.size(); ++b) {
    for (std::size_t i = blocks_.first[b]; i < blocks_.first[b + 1]; ++i) {
      const std::size_t sample = i - blocks_.first[blocks_.at_rest];
      out.accel_mps2[sample] =
          fit.line(0) + fit.line(1) * static_cast<double>(sample) / fs_Hz_ + flicker(static_cast<Index>(b));
    }
  }
  // The standard deviation is a smooth function of time: between a few times it is interpolated as a power of time.
  std::size_t before = 0;
  double log_before = 0, log_std_before = 0;
  for (std::size_t knot = 1; before < samples_;) {
    const double t_s = static_cast<double>(knot) / fs_Hz_;
    const Eigen::VectorXd by_block = deflection_by_block(blocks_, t_s, corner_Hz_);
    const double drift = std::max(0.0, by_block.dot(covariance * by_block));
    // t + Δt, because the noise of the first sample acts over the interval after it.
    const double white = std::pow(sample_noise_mps2_, 2) * std::pow(t_s + 1 / fs_Hz_, 3) / (3 * fs_Hz_);
    const double log_knot = std::log(static_cast<double>(knot)), log_std = std::log(drift + white) / 2;
    for (std::size_t i = before; i < knot; ++i) {
      const double at = std::log(static_cast<double>(i + 1));
      const double part = before == 0 ? 1 : (at - log_before) / (log_knot - log_before);
      out.std_m[i] = std::exp(log_std_before + part * (log_std - log_std_before));
    }
    out.drift_std_m = std::sqrt(drift);
    before = knot;
    log_before = log_knot;
    log_std_before = log_std;
    knot = std::min(samples_, std::max(knot + 1, static_cast<std::size_t>(kKnotRatio * static_cast<double>(knot))));
  }
  return out;
}

}  // namespace percuss::metrics
