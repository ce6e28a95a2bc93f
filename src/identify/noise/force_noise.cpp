#include "identify/noise/force_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/complex.hpp"
#include "core/math/wide_loops.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

// Spacing of the groups of samples (Delay), in periods of the highest line, but at least one sample. The noise divides
// equally between real and imaginary part if the squares of the groups' phase factors sum to zero. From one group to
// the next, this square turns by 2 · 2π · kDelay = 4 rad. This is less than a full turn, so the squares of the groups
// cancel like the squares of single samples. With a spacing of one sample, each group is one sample.
constexpr double kDelay = 0.32;

constexpr double kEqualParts = 0.01;  // difference of the variances of real and imaginary part, over their sum

constexpr double kNarrow = 0.2;  // half of a band's width over its highest line
constexpr double kMinGroups = 16;

// Standard deviation of the sum of the ringing that the gate cuts off, in standard deviations σ of the noise. The gate
// ends where the ringing is below 4 σ. The ringing roughly alternates in sign from sample to sample, so that at low
// frequencies its sum is half its first sample. Near half the sampling rate the sum is larger, by the factor
// kMaxRingingGain at most.
constexpr double kCutRinging = 1;
constexpr double kMaxRingingGain = 5;

// Zeros within a gate that part it: fewer may be samples of a coarse channel.
constexpr std::size_t kMinPause = 16;

// Samples of the force that carry noise, as delays from the centre of the main pulse.
struct Part {
  double begin = 0, end = 0;
  double samples() const { return end - begin; }
};

// The gate of one hit.
struct HitGate {
  std::vector<Part> parts;  // the main pulse's first, then those of further contacts
  double energy = 0;        // sum of the squares of the force
  double weight = 0;        // the hit's part of the energy of all hits
};

std::vector<Part> parted(const std::vector<double>& force_N) {
  const auto size = static_cast<double>(force_N.size());
  std::vector<Part> parts{{.begin = 0, .end = size}};
  std::size_t before = force_N.size();  // the last sample that is not zero
  for (std::size_t n = 0; n < force_N.size(); ++n) {
    if (force_N[n] == 0) continue;
    if (before < n && n - before > kMinPause) {
      parts.back().end = static_cast<double>(before + 1);
      parts.push_back({.begin = static_cast<double>(n), .end = size});
    }
    before = n;
  }
  return parts;
}

// Moves the part with the largest force to the front.
void put_main_first(std::vector<Part>& parts, const std::vector<double>& force_N) {
  const auto largest =
      std::max_element(force_N.begin(), force_N.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto at = static_cast<double>(largest - force_N.begin());
  const auto main = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return at < part.end; });
  if (main != parts.end()) std::iter_swap(parts.begin(), main);
}

// Centre of the main pulse within the gate, in samples.
double centre_of(const std::vector<double>& force_N, const Part& main) {
  double moment = 0, sum = 0;
  for (auto n = static_cast<std::size_t>(main.begin); n < static_cast<std::size_t>(main.end); ++n) {
    moment += static_cast<double>(n) * force_N[n] * force_N[n];
    sum += force_N[n] * force_N[n];
  }
  return sum > 0 ? moment / sum : 0;
}

// The gates of a point's hits. The distance between the centres of two hits counts in whole samples.
std::vector<HitGate> gates_of(const PointForce& force) {
  std::vector<HitGate> gates;
  double first_centre = 0, energy = 0;
  for (const frf::ForceBlock& block : force.blocks) {
    HitGate gate{.parts = parted(block.force_N)};
    put_main_first(gate.parts, block.force_N);
    const double centre = centre_of(block.force_N, gate.parts.front());
    if (gates.empty()) first_centre = centre;
    if (!block.ungated_N.empty()) gate.parts = {{.begin = 0, .end = static_cast<double>(block.ungated_N.size())}};
    const double origin = first_centre + std::round(centre - first_centre);
    for (Part& part : gate.parts) part = {.begin = part.begin - origin, .end = part.end - origin};
    for (const double value : block.force_N) gate.energy += value * value;
    energy += gate.energy;
    gates.push_back(std::move(gate));
  }
  const double equal = 1 / static_cast<double>(gates.size());
  for (HitGate& gate : gates) gate.weight = energy > 0 ? gate.energy / energy : equal;
  return gates;
}

// Samples that carry noise into the force: mean over the hits.
double gated_samples(const std::vector<HitGate>& gates) {
  double gated = 0;
  for (const HitGate& gate : gates) {
    for (const Part& part : gate.parts) gated += gate.weight * part.samples();
  }
  return gated;
}

// Groups of samples that count as one each. Group i is centred `first + i * step` samples after the pulse's centre.
struct Groups {
  double first = 0, step = 0;
  std::vector<double> variance;  // [groups] over the variance of one sample
};

// Covers the parts of all gates by groups; `count_for` gives their number for a number of samples.
template <typename Count>
std::vector<Groups> groups_of(const std::vector<HitGate>& gates, Count count_for) {
  std::vector<Part> covered;
  for (const HitGate& gate : gates) covered.insert(covered.end(), gate.parts.begin(), gate.parts.end());
  std::sort(covered.begin(), covered.end(), [](const Part& a, const Part& b) { return a.begin < b.begin; });
  std::size_t count = 0;  // parts that no gap separates are one
  for (const Part& part : covered) {
    if (count > 0 && part.begin <= covered[count - 1].end) {
      covered[count - 1].end = std::max(covered[count - 1].end, part.end);
    } else {
      covered[count++] = part;
    }
  }
  covered.resize(count);
  std::vector<Groups> out;
  for (const Part& range : covered) {
    const double groups = count_for(range.samples()), step = range.samples() / groups;
    out.push_back({.first = range.begin + 0.5 * step - 0.5,
                   .step = step,
                   .variance = std::vector<double>(static_cast<std::size_t>(groups))});
    for (std::size_t i = 0; i < out.back().variance.size(); ++i) {
      const double begin = range.begin + static_cast<double>(i) * step;
      for (const HitGate& gate : gates) {
        for (const Part& part : gate.parts) {
          const double within = std::min(part.end, begin + step) - std::max(part.begin, begin);
          out.back().variance[i] += gate.weight * std::max(0.0, within);
        }
      }
    }
  }
  return out;
}

// The ringing that the gate cuts off, just outside one end of a part of it.
struct CutRinging {
  double delay = 0;  // samples from the pulse's centre
  double std = 0;    // in kCutRinging
};

// The ringing of the main pulse is the same in all hits, so the hits do not average it out: hence the factor √hits.
// That of a further contact belongs to one hit.
std::vector<CutRinging> cut_ringing(const PointForce& force, const std::vector<HitGate>& gates) {
  const double in_all = std::sqrt(static_cast<double>(gates.size()));
  double samples = 0;
  for (const HitGate& gate : gates) samples += gate.weight * gate.parts.front().samples();
  const double first = gates.front().parts.front().begin;
  const bool cut = force.blocks.front().ungated_N.empty();
  std::vector<CutRinging> out{{.delay = first - 1, .std = cut ? in_all : 0},
                              {.delay = first + samples, .std = cut ? in_all : 0}};
  for (const HitGate& gate : gates) {
    for (std::size_t p = 1; p < gate.parts.size(); ++p) {
      out.push_back({.delay = gate.parts[p].begin - 1, .std = std::sqrt(gate.weight)});
      out.push_back({.delay = gate.parts[p].end, .std = std::sqrt(gate.weight)});
    }
  }
  return out;
}

// Standard deviation of the ringing cut off at one end, N.
double cut_ringing_N(const PointForce& force, const CutRinging& cut, double turns) {
  const double gain = 1 / std::max(std::cos(0.5 * kTwoPi * turns), 1 / kMaxRingingGain);
  return kCutRinging * force.noise_N * gain * cut.std;
}

// Variance of the real part of the error that the noise of the gate causes, over the variance of the whole error: the
// mean of cos² over the samples' phases, which count from the pulse's centre.
double real_share(const std::vector<HitGate>& gates, double turns) {
  const double angle = kTwoPi * turns;
  double inequality = 0, largest = 0;
  for (const HitGate& gate : gates) {
    for (const Part& part : gate.parts) {
      const double sum = gate.weight * std::sin(angle * part.samples()) / std::sin(angle);
      largest += std::abs(sum);
      inequality += sum * std::cos(angle * (part.begin + part.end - 1));
    }
  }
  const double samples = gated_samples(gates);
  if (!(largest > kEqualParts * samples)) return 0.5;
  return 0.5 * std::max(0.0, 1 + inequality / samples);
}

double one_over_force(const PointForce& force, std::size_t line) {
  return 1 / std::sqrt(std::max(force.ff[line], 1e-300));
}

PERCUSS_WIDE_LOOPS void multiply(std::vector<Complex>& values, const std::vector<Complex>& factors) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = times(values[k], factors[k]);
}

// [lines, groups + cut] relative error of the force's spectrum from the noise of each group and from the ringing cut
// off.
Eigen::MatrixXcd relative_force_errors(const FrfDataset& set, const PointForce& force,
                                       const std::vector<std::size_t>& lines, const std::vector<Groups>& groups,
                                       const std::vector<CutRinging>& cut) {
  std::size_t columns = cut.size();
  for (const Groups& of : groups) columns += of.variance.size();
  Eigen::MatrixXcd errors(static_cast<Index>(lines.size()), static_cast<Index>(columns));
  std::vector<Complex> error(lines.size()), turn(lines.size());
  std::vector<double> turns(lines.size()), per_N(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    turns[k] = set.lines.freq_Hz(lines[k]) / set.lines.fs_Hz;
    per_N[k] = one_over_force(force, lines[k]);
  }
  Index column = 0;
  for (const Groups& of : groups) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      turn[k] = std::polar(1.0, -kTwoPi * turns[k] * of.step);
      error[k] = std::polar(per_N[k] * force.noise_N, -kTwoPi * turns[k] * of.first);
    }
    for (const double variance : of.variance) {
      const Eigen::Map<const Eigen::VectorXcd> unscaled(error.data(), errors.rows());
      errors.col(column++) = std::sqrt(variance) * unscaled;
      multiply(error, turn);
    }
  }
  for (const CutRinging& end : cut) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      errors(static_cast<Index>(k), column) =
          std::polar(per_N[k] * cut_ringing_N(force, end, turns[k]), -kTwoPi * turns[k] * end.delay);
    }
    ++column;
  }
  return errors;
}

}  // namespace

Eigen::MatrixXcd gain_errors(const FrfDataset& set, std::size_t point, const std::vector<std::size_t>& lines,
                             ForceErrors of) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty() || !(force.noise_N > 0) || lines.empty()) return {};
  const std::vector<HitGate> gates = gates_of(force);
  const std::vector<CutRinging> cut = of == ForceErrors::all ? cut_ringing(force, gates) : std::vector<CutRinging>{};
  const double highest = set.lines.freq_Hz(lines.back()) / set.lines.fs_Hz;
  const double half = 0.5 * (highest - set.lines.freq_Hz(lines.front()) / set.lines.fs_Hz);
  if (half >= kNarrow * highest) {
    const double apart = std::max(1.0, kDelay / highest);
    const auto count = [&](double samples) { return std::max(2.0, std::ceil(samples / apart)); };
    return relative_force_errors(set, force, lines, groups_of(gates, count), cut);
  }
  // A narrow band allows groups of many periods, each with an in-phase and a quadrature variable.
  const auto count = [&](double samples) { return std::max(kMinGroups, std::ceil(samples * half / kDelay)); };
  const Eigen::MatrixXcd in_phase = relative_force_errors(set, force, lines, groups_of(gates, count), cut);
  Eigen::MatrixXcd errors(in_phase.rows(), 2 * in_phase.cols());
  errors << std::sqrt(0.5) * in_phase, Complex(0, std::sqrt(0.5)) * in_phase;
  return errors;
}

double gain_std(const FrfDataset& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // the force is unknown
  const std::vector<HitGate> gates = gates_of(force);
  const std::size_t line = set.lines.nearest(freq_Hz);
  double variance_N2 = gated_samples(gates) * force.noise_N * force.noise_N;
  for (const CutRinging& end : cut_ringing(force, gates))
    variance_N2 += std::pow(cut_ringing_N(force, end, set.lines.freq_Hz(line) / set.lines.fs_Hz), 2);
  return one_over_force(force, line) * std::sqrt(0.5 * variance_N2);
}

double gain_amplitude_std(const FrfDataset& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // the force is unknown
  const double turns = set.lines.freq_Hz(set.lines.nearest(freq_Hz)) / set.lines.fs_Hz;
  return gain_std(set, point, freq_Hz) * std::sqrt(2 * real_share(gates_of(force), turns));
}

}  // namespace percuss::identify
