#include "identify/start/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/math/statistics.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/noise/window_noise.hpp"
#include "identify/start/peaks.hpp"

namespace percuss::identify {
namespace {

constexpr double kNoiseProminence = 6;  // standard deviations of the level's fluctuation
constexpr double kDecibelsPerNeper = 8.6859;
constexpr double kResonanceSpan =
    6;  // half-widths on either side, over which a resonance is compared with the residual
constexpr double kMinResidualModeGain =
    30;  // noise powers above three times the expected sum over the FRFs: one false alarm in 10^10 lines
constexpr double kOutOfBandGain = 1000;     // … above the force's bandwidth, where weaker modes are never accepted
constexpr double kModelFloor = 1e-6;        // of the largest line: the residual of a fit to noise-free data
constexpr double kFlank = 20;               // half-widths of a resonance's flanks on either side …
constexpr double kFlankGain = 0.1;          // … and the part of its gain that the flanks may show
constexpr double kMinResonanceLines = 1.5;  // half-width of the narrowest resonance searched for
constexpr double kMaxResidualModeWidth = 0.03;  // half-width of the broadest mode searched for, over the top frequency
constexpr std::size_t kFlopsPerLevelLine = 20;  // operations of the noise or weight of one line

double largest_magnitude(std::span<const Complex> h) {
  double largest = 0;  // as power
  for (const Complex& value : h) largest = std::max(largest, std::norm(value));
  return std::sqrt(largest);
}

struct Level {
  std::vector<double> power, noise;  // Σ over the FRFs of |H|² and of the noise power
};

Level level_of(const FrfDataset& set, const LineNoise& line_noise) {
  const std::size_t n = set.lines.count;
  Level level{std::vector<double>(n), std::vector<double>(n)};
  std::vector<std::vector<double>> noise(set.channels.size());
  parallel_for_cost(noise.size(), kFlopsPerLevelLine * n, [&](std::size_t o) { noise[o] = line_noise.local(o); });
  parallel_for_chunks(n, kFlopsPerLevelLine * noise.size(), [&](std::size_t first, std::size_t count) {
    for (std::size_t o = 0; o < noise.size(); ++o) {
      for (std::size_t k = first; k < first + count; ++k) {
        level.power[k] += std::norm(set.channels[o].frf[k]);
        level.noise[k] += noise[o][k];
      }
    }
  });
  return level;
}

// The shape of a resonance of half-width h (in lines) over ±kResonanceSpan·h, a straight background projected out.
Eigen::VectorXcd resonance(double h) {
  const auto reach = static_cast<Eigen::Index>(std::ceil(kResonanceSpan * h));
  const Eigen::VectorXd x =
      Eigen::VectorXd::LinSpaced(2 * reach + 1, -static_cast<double>(reach), static_cast<double>(reach));
  Eigen::VectorXcd g(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) g(i) = 1.0 / Complex(h, x(i));
  g.array() -= g.mean();
  g -= x.cast<Complex>() * (x.cast<Complex>().dot(g) / x.squaredNorm());
  return g / g.norm();
}

// The residual of one FRF at some line width, and its noise power.
struct ResidualLines {
  Eigen::VectorXcd residual;
  std::vector<double> noise;
};

// Doubles the line width: the mean of two lines has half the noise power, but the full model error.
ResidualLines with_doubled_width(const ResidualLines& lines, double floor) {
  const Eigen::Index n = lines.residual.size() / 2;
  ResidualLines wide{Eigen::VectorXcd(n), std::vector<double>(static_cast<std::size_t>(n))};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    wide.residual(i) = 0.5 * (lines.residual(2 * i) + lines.residual(2 * i + 1));
    wide.noise[k] = std::max(floor, 0.25 * (lines.noise[2 * k] + lines.noise[2 * k + 1]));
  }
  return wide;
}

// The energy that the resonance explains at each line over the noise power, Σ over the FRFs.
std::vector<double> gain_of(const std::vector<ResidualLines>& channels, const Eigen::VectorXcd& shape) {
  const auto reach = static_cast<std::size_t>(shape.size() / 2);
  const auto lines = static_cast<std::size_t>(channels.front().residual.size());
  std::vector<double> gain(lines);
  parallel_for_chunks(lines, 2 * kFlopsPerProduct * reach * channels.size(), [&](std::size_t first, std::size_t count) {
    const std::size_t end = std::min(first + count, lines > reach ? lines - reach : 0);
    for (std::size_t k = std::max(first, reach); k < end; ++k) {
      const auto from = static_cast<Eigen::Index>(k - reach);
      for (const ResidualLines& channel : channels) {
        if (channel.noise[k] > 0) gain[k] += std::norm(adjoint_dot(shape, channel.residual, from)) / channel.noise[k];
      }
    }
  });
  return gain;
}

std::vector<Eigen::VectorXcd> frf_segments(const FrfDataset& set, std::size_t first, std::size_t count) {
  std::vector<Eigen::VectorXcd> out;
  for (const FrfChannel& channel : set.channels) {
    out.emplace_back(Eigen::Map<const Eigen::VectorXcd>(channel.frf.data() + first, static_cast<Eigen::Index>(count)));
  }
  return out;
}

// The narrowest resonance that the lines resolve.
Pole narrowest_pole(const FrfDataset& set, double asked_Hz) {
  const double freq_Hz = std::max(asked_Hz, set.lines.df_Hz());
  return {.freq_Hz = freq_Hz, .damping_ratio = std::min(0.1, set.lines.df_Hz() / freq_Hz)};
}

Pole pole_at_line(const FrfDataset& set, std::size_t line) {
  // A narrow window first, then one of a few bandwidths of the pole found, where the linear fit is best.
  Pole pole;
  std::size_t half = 4;
  for (int pass = 0; pass < 3; ++pass) {
    const std::size_t first = line > half ? line - half : 0;
    const std::size_t end = std::min(set.lines.count, line + half + 1);
    if (end - first < 4) break;
    const Pole found = pole_of_window(set, frf_segments(set, first, end - first), first);
    const bool near = std::abs(found.freq_Hz - set.lines.freq_Hz(line)) < static_cast<double>(half) * set.lines.df_Hz();
    if (!(found.freq_Hz > 0) || !near) break;
    pole = found;
    half = static_cast<std::size_t>(std::clamp(2 * pole.half_power_Hz() / set.lines.df_Hz(), 4.0, 400.0));
  }
  return pole.freq_Hz > 0 ? pole : narrowest_pole(set, set.lines.freq_Hz(line));
}

Pole peak_near(const FrfDataset& set, double freq_Hz) {
  const double at = set.lines.position(freq_Hz);
  const double reach = std::max(kStatedRangeLines, kStatedRange * freq_Hz / set.lines.df_Hz());
  std::size_t best = set.lines.at(at);
  double highest = 0;
  for (std::size_t line = set.lines.at(at - reach); line <= set.lines.at(at + reach); ++line) {
    const double power = power_at(set, line);
    if (power > highest) best = line;
    highest = std::max(highest, power);
  }
  return pole_at_line(set, best);
}

}  // namespace

std::vector<std::size_t> prominent_lines(const FrfDataset& set, const LineNoise& noise,
                                         const CandidateOptions& options) {
  if (set.lines.count < 5) return {};
  const Level level = level_of(set, noise);
  std::vector<std::size_t> lines;
  for (const Peak& peak : find_peaks(level.power)) {
    if (peak.line == 0 || peak.line + 1 == level.power.size()) continue;
    const double power = level.power[peak.line];
    const double snr = level.noise[peak.line] > 0 ? std::sqrt(power / level.noise[peak.line]) : 1e9;
    if (snr < options.snr) continue;
    const double fluctuation_dB = kNoiseProminence * kDecibelsPerNeper / (snr * std::sqrt(2.0));
    const double saddle = std::max(power - peak.prominence, 1e-300);
    if (10 * std::log10(power / saddle) >= options.prominence_dB + fluctuation_dB) lines.push_back(peak.line);
  }
  return lines;
}

std::vector<Pole> candidate_poles(const FrfDataset& set, const LineNoise& noise, const CandidateOptions& options) {
  const std::vector<std::size_t> lines = prominent_lines(set, noise, options);
  std::vector<Pole> poles;
  for (const std::size_t line : lines) {
    const Pole pole = pole_at_line(set, line);
    const auto apart = [&](std::size_t from) {
      return std::abs(set.lines.position(pole.freq_Hz) - static_cast<double>(from));
    };
    const bool belongs_to_other =
        std::any_of(lines.begin(), lines.end(), [&](std::size_t other) { return apart(other) < apart(line); });
    poles.push_back(belongs_to_other ? narrowest_pole(set, set.lines.freq_Hz(line)) : pole);
  }
  return poles;
}

std::vector<Resonance> residual_resonances(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual) {
  const WindowNoise window(set);
  std::vector<Resonance> found;
  std::vector<ResidualLines> channels(residual.size());
  std::vector<double> floors(residual.size());
  parallel_for_cost(channels.size(), kFlopsPerLevelLine * set.lines.count, [&](std::size_t o) {
    const std::span lines(residual[o].data(), static_cast<std::size_t>(residual[o].size()));
    channels[o] = {residual[o], local_noise(block_noise(lines, window.roughness()), lines.size())};
    floors[o] = std::pow(kModelFloor * largest_magnitude(set.channels[o].frf), 2);
    for (double& power : channels[o].noise) power = std::max(window.max_factor() * power, floors[o]);
  });
  const double threshold = kMinResidualModeGain + 3 * static_cast<double>(residual.size());
  const double top_Hz = set.lines.freq_Hz(set.lines.count - 1);
  const double widest = kMaxResidualModeWidth * top_Hz / set.lines.df_Hz();
  const Eigen::VectorXcd shape = resonance(kMinResonanceLines);
  // A resonance of each width is searched on the widest lines that resolve it: the work halves at every doubling.
  for (double width = 1; kMinResonanceLines * width < widest; width *= 2) {
    const auto gain = gain_of(channels, shape);
    for (const std::size_t peak : maxima_above(gain, threshold)) {
      const double line = (static_cast<double>(peak) + 0.5) * width - 0.5;
      found.push_back({line, kMinResonanceLines * width, gain[peak]});
    }
    const auto lines = static_cast<std::size_t>(channels.front().residual.size());
    parallel_for_cost(channels.size(), kFlopsPerLevelLine * lines,
                      [&](std::size_t o) { channels[o] = with_doubled_width(channels[o], floors[o]); });
  }
  return found;
}

std::vector<Pole> residual_mode_poles(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual) {
  // Keeps the best width at each place. Resonances within its width are the same one at another width, and weak
  // resonances around it may be its flanks.
  std::vector<Resonance> found = residual_resonances(set, residual);
  std::sort(found.begin(), found.end(), [](const Resonance& a, const Resonance& b) { return a.gain > b.gain; });
  std::vector<Resonance> kept;
  for (const Resonance& f : found) {
    const bool belongs = std::any_of(kept.begin(), kept.end(), [&](const Resonance& k) {
      const double apart = std::abs(f.line - k.line);
      const bool same = apart < 3 * std::max(k.half_width, f.half_width);
      return same || (apart < kFlank * k.half_width && f.gain < kFlankGain * k.gain);
    });
    if (!belongs) kept.push_back(f);
  }
  std::erase_if(kept, [&](const Resonance& f) {
    const double freq_Hz = (static_cast<double>(set.lines.first) + f.line) * set.lines.df_Hz();
    return set.usable_bandwidth_Hz > 0 && freq_Hz > set.usable_bandwidth_Hz && f.gain < kOutOfBandGain;
  });
  std::vector<Pole> poles;
  for (const Resonance& f : kept) {
    const double freq_Hz = (static_cast<double>(set.lines.first) + f.line) * set.lines.df_Hz();
    poles.push_back({.freq_Hz = freq_Hz, .damping_ratio = std::min(0.1, f.half_width * set.lines.df_Hz() / freq_Hz)});
  }
  return poles;
}

std::vector<Pole> poles_near(const FrfDataset& set, const std::vector<double>& freq_Hz) {
  std::vector<Pole> poles;
  for (const double asked_Hz : freq_Hz) {
    const Pole peak = peak_near(set, asked_Hz);
    const bool belongs_to_other = std::any_of(freq_Hz.begin(), freq_Hz.end(), [&](double other_Hz) {
      return std::abs(other_Hz - peak.freq_Hz) < std::abs(asked_Hz - peak.freq_Hz);
    });
    poles.push_back(belongs_to_other ? narrowest_pole(set, asked_Hz) : peak);
  }
  return poles;
}

}  // namespace percuss::identify
