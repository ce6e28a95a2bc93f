#include "identify/decay/decay_modes.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"
#include "core/units.hpp"
#include "identify/decay/companion_decays.hpp"
#include "identify/hits/hit_scatter.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMinDampingSignificance = 3;  // standard deviations; below them the oscillation counts as a tone
constexpr double kMaxLinear = 0.5;  // step of a hit's pole over the decay rate: beyond it, a linear estimate fails

struct PoleWithStd {
  Pole pole;
  double freq_std_Hz = 0, damping_std = 0;
};

// ∂(f, ζ)/∂(Re s, Im s) of f = |s|/2π and ζ = −Re s/|s|.
Eigen::Matrix2d by_rate(const Complex& s) {
  const double size = std::abs(s), re = s.real(), im = s.imag();
  return Eigen::Matrix2d{{re / size / kTwoPi, im / size / kTwoPi},
                         {-im * im / std::pow(size, 3), re * im / std::pow(size, 3)}};
}

PoleWithStd pole_with_std(const DecayRate& rate, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d slope = by_rate(rate.rate_radps);
  const Eigen::Matrix2d of_pole = slope * covariance * slope.transpose();
  return {.pole = rate.pole(),
          .freq_std_Hz = std::sqrt(std::max(0.0, of_pole(0, 0))),
          .damping_std = std::sqrt(std::max(0.0, of_pole(1, 1)))};
}

void add_scatter(const FittedDecay& decay, Mode& mode) {
  std::vector<double> freq_Hz, freq_std_Hz, damping, damping_std;
  const double limit = kMaxLinear * -decay.rate.rate_radps.real();
  for (std::size_t h = 0; h < decay.hit_step.size(); ++h) {
    const Eigen::Vector2d& step = decay.hit_step[h];
    const DecayRate own{decay.rate.rate_radps + Complex(step(0), step(1))};
    const PoleWithStd known = pole_with_std(own, decay.hit_covariance[h]);
    const double std_radps = std::sqrt(decay.hit_covariance[h].trace());
    if (!step.allFinite() || !(step.norm() < limit) || !(std_radps < limit)) continue;
    freq_Hz.push_back(known.pole.freq_Hz);
    freq_std_Hz.push_back(known.freq_std_Hz);
    damping.push_back(known.pole.damping_ratio);
    damping_std.push_back(known.damping_std);
  }
  if (freq_Hz.size() < 2) return;
  const ScatterOfHits freq = scatter_of_hits(freq_Hz, freq_std_Hz), zeta = scatter_of_hits(damping, damping_std);
  if (freq.deviate > kOnceIn1000) {
    mode.freq_std_parts_Hz.hits = freq.std_from_scatter;
    mode.hit_scatter_Hz = freq.spread;
  }
  if (zeta.deviate > kOnceIn1000) {
    mode.damping_std_parts.hits = zeta.std_from_scatter;
    mode.hit_scatter_damping = zeta.spread;
  }
}

// Rank one of the amplitudes over their noise: value(h, c) ≈ hit(h) channel(c).
struct RankOne {
  Eigen::VectorXcd hit;      // [hits]
  Eigen::VectorXcd channel;  // [channels]
  Eigen::VectorXd hit_std;   // [hits] standard deviation of the real (and of the imaginary) part, relative to `std`
  Eigen::VectorXd std;       // [channels] of the real and of the imaginary part
  double excess = 1;         // of the standard deviations: the residual's RMS over the noise, at least 1
};

RankOne rank_one(const FittedDecay& decay, Index channels) {
  const Index hits = decay.amplitude.size() / channels;
  // The standard deviations as a product of one per hit and one per channel: their geometric means.
  const Eigen::VectorXd log_std = (decay.noise * decay.inverse_gram.trace() / 2).cwiseMax(1e-290).array().log() / 2;
  const Eigen::Map<const Eigen::MatrixXd> table(log_std.data(), channels, hits);
  const Eigen::VectorXd noise = table.rowwise().mean().array().exp();
  const Eigen::VectorXd of_hit = (table.colwise().mean().array() - table.mean()).exp().transpose();
  Eigen::MatrixXcd weighted(hits, channels);
  for (Index h = 0; h < hits; ++h) {
    for (Index c = 0; c < channels; ++c) weighted(h, c) = decay.amplitude(h * channels + c) / (of_hit(h) * noise(c));
  }
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(weighted, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  RankOne out{.hit = svd.matrixU().col(0).cwiseProduct(of_hit.cast<Complex>()),
              .channel = (values(0) * svd.matrixV().col(0).conjugate()).cwiseProduct(noise.cast<Complex>()),
              .hit_std = of_hit,
              .std = noise};
  const auto freedom = static_cast<double>(2 * (hits - 1) * (channels - 1));
  if (freedom > 0) {
    const double chi2 = values.tail(values.size() - 1).squaredNorm();
    // Real and imaginary parts each have unit variance: chi2 has `freedom` degrees of freedom.
    if (chi2_deviate(chi2, freedom) > kOnceIn1000) out.excess = std::sqrt(chi2 / freedom);
  }
  out.std *= out.excess;
  return out;
}

// The channel that observes all modes best. A channel's score is its amplitude in its worst mode, relative to the
// mode's largest amplitude.
std::size_t reference_channel(const std::vector<RankOne>& shapes, std::size_t channels) {
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t c = 0; c < channels; ++c) {
    double share = 1;
    for (const RankOne& shape : shapes)
      share = std::min(share, std::abs(shape.channel(static_cast<Index>(c))) / shape.channel.cwiseAbs().maxCoeff());
    if (share > largest * (1 + 1e-9)) best = c;
    largest = std::max(largest, share);
  }
  return best;
}

void add_shape(const RankOne& shape, std::size_t reference, DecayMode& out) {
  const auto at = static_cast<Index>(reference);
  const Complex unit = shape.channel(at);
  for (Index c = 0; c < shape.channel.size(); ++c) {
    const Complex ratio = c == at ? Complex(1) : shape.channel(c) / unit;
    const double std =
        c == at ? 0 : std::hypot(shape.std(c), std::abs(ratio) * shape.std(at)) / std::max(std::abs(unit), 1e-290);
    out.mode.residues.push_back(
        {.point = 0, .channel = static_cast<std::size_t>(c), .value = ratio, .std = std, .own_pole = {}});
  }
  for (Index h = 0; h < shape.hit.size(); ++h)
    out.hits.push_back({.value = shape.hit(h) * unit, .std = shape.hit_std(h) * shape.std(at)});
}

Mode mode_of(const FittedDecay& decay) {
  const PoleWithStd known = pole_with_std(decay.rate, decay.covariance);
  Mode mode{.pole = known.pole,
            .freq_std_parts_Hz = {.noise = std::max(known.freq_std_Hz, kRounding * known.pole.freq_Hz)},
            .damping_std_parts = {.noise = std::max(known.damping_std, kRoundingDamping * known.pole.damping_ratio)},
            .amplitude = {},
            .drift = {},
            .residues = {}};
  const double misfit = std::sqrt(std::max(0.0, decay.misfit * decay.misfit - 1));
  mode.freq_std_parts_Hz.misfit = misfit * known.freq_std_Hz;
  mode.damping_std_parts.misfit = misfit * known.damping_std;
  add_scatter(decay, mode);
  mode.freq_std_Hz = mode.freq_std_parts_Hz.total();
  mode.damping_std = mode.damping_std_parts.total();
  return mode;
}

}  // namespace

DecayResults modes_of_decays(const FreeDecayFit& fit, std::size_t channels, std::pair<double, double> band_Hz) {
  DecayResults out;
  std::vector<RankOne> shapes, tone_shapes;
  for (std::size_t d = 0; d < fit.decays.size(); ++d) {
    const Mode mode = mode_of(fit.decays[d]);
    if (mode.pole.freq_Hz < band_Hz.first || mode.pole.freq_Hz > band_Hz.second) continue;
    if (mode.pole.damping_ratio > kMaxDampingRatio) continue;
    const bool decays = mode.pole.damping_ratio > kMinDampingSignificance * mode.damping_std;
    (decays ? shapes : tone_shapes).push_back(rank_one(fit.decays[d], static_cast<Index>(channels)));
    (decays ? out.modes : out.tones)
        .push_back({.mode = mode,
                    .hits = {},
                    .energy = fit.energy[d],
                    .alternative_pair_Hz = fit.decays[d].alternative_pair_Hz});
  }
  out.reference = reference_channel(shapes, channels);
  for (std::size_t m = 0; m < shapes.size(); ++m) add_shape(shapes[m], out.reference, out.modes[m]);
  for (std::size_t m = 0; m < tone_shapes.size(); ++m) add_shape(tone_shapes[m], out.reference, out.tones[m]);
  gather_companions(out);
  return out;
}

}  // namespace percuss::identify
