#include "identify/classify/type_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace percuss::identify {
namespace {

using std::numbers::pi;

// Planes of the tube: 2° apart over 90°, because every plane comes with the one at right angles to it. Planes of the
// blow: 2° apart over 180°.
constexpr std::size_t kPlanes = 45;
constexpr std::size_t kBlowPlanes = 2 * kPlanes;
constexpr double kPairPrior = 0.9;      // prior probability that two partners are one mode in two planes
constexpr double kPairAngle_rad = 0.1;  // standard deviation, around 90°, of the angle between a mode's two planes
// Density of the log size ratio: its width for unrelated modes over its width for a pair.
constexpr double kBroader = 2;
constexpr double kMinHoop_Hz = 1000;  // lowest hoop frequency of barrels

// One number per type, in the order of TypePosterior: a prior, likelihoods or weights whose sum is not 1.
using TypeWeights = TypePosterior;

// Prior probabilities of the types. A bat's lowest mode is a bending mode at 100 to 300 Hz. The higher the lowest
// frequency found is, the likelier the band excludes this bending mode: the prior becomes uninformative towards
// kMinHoop_Hz.
TypeWeights prior_at(double freq_Hz) {
  const double hoop = std::clamp(std::pow(freq_Hz / kMinHoop_Hz, 2), 0.01, 1.0);
  return {2 - hoop, hoop, 1};
}

double sum_of(const TypeWeights& b) { return b[0] + b[1] + b[2]; }

TypePosterior normalised(TypeWeights b) {
  const double sum = sum_of(b);
  if (!(sum > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  for (double& p : b) p /= sum;
  return b;
}

TypeWeights product_of(TypeWeights a, const TypeWeights& b) {
  for (std::size_t f = 0; f < a.size(); ++f) a[f] *= b[f];
  return a;
}

// Likelihoods of one mode's ratio for all values of the shared unknowns.
struct ModeTable {
  std::vector<double> bending;  // [planes]
  std::array<double, RatioLikelihood::kPlacements> hoop{};
  double other = 1;
  TypeWeights prior{1, 1, 1};
};

enum class BendingPlanes { of_the_tube, of_the_blow };

ModeTable table_of(const TypeEvidence& mode, const RatioLikelihood& likelihood, BendingPlanes planes) {
  ModeTable table;
  table.bending.assign(planes == BendingPlanes::of_the_tube ? kPlanes : kBlowPlanes, 1);
  table.hoop.fill(1);
  if (!mode.ratio) return table;
  for (std::size_t p = 0; p < table.bending.size(); ++p) {
    const double plane_rad = pi / 2 * static_cast<double>(p) / kPlanes;
    table.bending[p] = planes == BendingPlanes::of_the_tube ? likelihood.bending(*mode.ratio, plane_rad)
                                                            : likelihood.bending_of_blow(*mode.ratio, plane_rad);
  }
  for (std::size_t e = 0; e < table.hoop.size(); ++e) table.hoop[e] = likelihood.hoop(*mode.ratio, e);
  table.other = likelihood.other(*mode.ratio);
  return table;
}

// Density of the logarithm of two sizes' ratio. The members of a pair share one motion at a random angle λ, so their
// ratio is tan λ; for unrelated modes the density is broader.
double sech(double x) { return 1 / std::cosh(std::min(std::abs(x), 300.0)); }
double pair_density(double log_ratio) { return sech(log_ratio) / pi; }
double independent_density(double log_ratio) { return sech(log_ratio / kBroader) / (kBroader * pi); }

// Likelihoods of two partners that do not depend on the shared unknowns.
struct PairTable {
  TypeWeights size{1, 1, 1};   // of the members' sizes, if both are one mode in its two planes; per type of the mode
  double unrelated_modes = 1;  // of the members' sizes, as unrelated modes
  double right_angle = 1;      // of the angle between the planes
};

PairTable table_of(const TypeEvidence& one, const TypeEvidence& two, const RatioLikelihood& likelihood) {
  const RatioAngle &a = *one.ratio, &b = *two.ratio;
  const double log_ratio = std::log(one.size / two.size);
  const auto as = [&](int n) {
    return pair_density(log_ratio -
                        std::log(likelihood.observed_amplitude(a, n) / likelihood.observed_amplitude(b, n)));
  };
  const double spread = std::hypot(kPairAngle_rad, a.std_rad, b.std_rad);
  return {.size = {as(1), as(2), pair_density(log_ratio)},
          .unrelated_modes = independent_density(log_ratio),
          .right_angle = wrapped_density(a.chi_rad - b.chi_rad - pi / 2, spread)};
}

class JointPosterior {
 public:
  JointPosterior(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood,
                 BendingPlanes planes = BendingPlanes::of_the_tube)
      : modes_(modes), planes_(planes == BendingPlanes::of_the_tube ? kPlanes : kBlowPlanes) {
    for (const TypeEvidence& mode : modes) {
      tables_.push_back(table_of(mode, likelihood, planes));
      const bool both = mode.partner && mode.ratio && modes[*mode.partner].ratio;
      pairs_.push_back(both ? std::optional(table_of(mode, modes[*mode.partner], likelihood)) : std::nullopt);
    }
    if (!modes.empty()) tables_[0].prior = prior_at(modes[0].freq_Hz);
  }

  // Gives every mode the prior at its frequency; by default only the lowest mode has it.
  void use_all_frequencies() {
    for (std::size_t m = 0; m < modes_.size(); ++m) tables_[m].prior = prior_at(modes_[m].freq_Hz);
  }

  // Logarithm of the likelihood of all ratios, averaged over the shared unknowns.
  double log_evidence() const {
    const std::vector<double> log_weight = log_weights();
    const double most = *std::max_element(log_weight.begin(), log_weight.end());
    double sum = 0;
    for (const double one : log_weight) sum += std::exp(one - most);
    return most + std::log(sum / static_cast<double>(planes_));
  }

  std::vector<TypePosterior> posteriors() const {
    const std::vector<double> log_weight = log_weights();
    const double most = *std::max_element(log_weight.begin(), log_weight.end());
    std::vector<TypePosterior> out(modes_.size(), TypePosterior{});
    for (std::size_t s = 0; s < log_weight.size(); ++s) {
      const double weight = std::exp(log_weight[s] - most);
      if (weight < kNegligible) continue;
      for (std::size_t m = 0; m < modes_.size(); ++m) {
        const TypePosterior here = normalised(joint_weights(s, m));
        for (std::size_t f = 0; f < here.size(); ++f) out[m][f] += weight * here[f];
      }
    }
    for (TypePosterior& posterior : out) posterior = normalised(posterior);
    return out;
  }

 private:
  static constexpr double kNegligible = 1e-9;

  // s numbers the combinations of the shared unknowns, plane and placement.
  std::size_t placement_of(std::size_t s) const { return s / planes_; }
  std::size_t plane_of(std::size_t s) const { return s % planes_; }

  std::vector<double> log_weights() const {
    std::vector<double> log_weight;
    for (std::size_t s = 0; s < planes_ * RatioLikelihood::kPlacements; ++s) log_weight.push_back(log_weight_of(s));
    return log_weight;
  }

  TypeWeights own_weights(std::size_t s, std::size_t m) const {
    const ModeTable& table = tables_[m];
    return product_of({table.bending[plane_of(s)], table.hoop[placement_of(s)], table.other}, table.prior);
  }

  // Weights of the types of mode m, summed over the types of its partner. The total is the same for both partners.
  TypeWeights joint_weights(std::size_t s, std::size_t m) const {
    const TypeWeights own = own_weights(s, m);
    if (!pairs_[m]) return own;
    const std::size_t partner = *modes_[m].partner;
    const TypeWeights other = own_weights(s, partner);
    const std::size_t sharper = modes_[m].ratio->std_rad < modes_[partner].ratio->std_rad ? m : partner;
    const double bending = tables_[sharper].bending[plane_of(s)] * tables_[std::min(m, partner)].prior[0];
    const TypeWeights together =
        product_of({bending * pairs_[m]->right_angle, own[1] * other[1], own[2] * other[2]}, pairs_[m]->size);
    TypeWeights out{};
    for (std::size_t f = 0; f < out.size(); ++f)
      out[f] = kPairPrior * together[f] + (1 - kPairPrior) * pairs_[m]->unrelated_modes * own[f] * sum_of(other) / 3;
    return out;
  }

  double log_weight_of(std::size_t s) const {
    double sum = std::log(RatioLikelihood::weight_of(placement_of(s)));
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      if (pairs_[m] && *modes_[m].partner < m) continue;  // counted with its partner
      sum += std::log(sum_of(joint_weights(s, m)));
    }
    return sum;
  }

  const std::vector<TypeEvidence>& modes_;
  std::size_t planes_;
  std::vector<ModeTable> tables_;
  std::vector<std::optional<PairTable>> pairs_;  // where both members have a ratio
};

}  // namespace

std::vector<TypePosterior> type_posteriors(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood) {
  return modes.empty() ? std::vector<TypePosterior>{} : JointPosterior(modes, likelihood).posteriors();
}

double log_set_up_evidence(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood) {
  if (modes.empty()) return 0;
  std::vector<double> logs;
  for (const BendingPlanes planes : {BendingPlanes::of_the_tube, BendingPlanes::of_the_blow}) {
    JointPosterior joint(modes, likelihood, planes);
    joint.use_all_frequencies();
    logs.push_back(joint.log_evidence());
  }
  const double most = std::max(logs[0], logs[1]);
  return most + std::log(0.5 * (std::exp(logs[0] - most) + std::exp(logs[1] - most)));
}

}  // namespace percuss::identify
