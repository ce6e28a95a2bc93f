#include "identify/classify/classify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identify/classify/asymmetry_split.hpp"
#include "identify/classify/mode_partners.hpp"
#include "identify/classify/three_waves.hpp"
#include "identify/classify/tube_evidence.hpp"
#include "identify/classify/type_posterior.hpp"

namespace percuss::identify {
namespace {

constexpr double kSplitDeviations = 2;         // standard deviations that noise may add to a separation
constexpr double kSplitSpacing = 0.15;         // of the lower frequency: largest separation, besides double_peak_Hz
constexpr double kMinLoneProbability = 0.9;    // below it the second type is stated …
constexpr double kMinRivalProbability = 0.03;  // … and where the second type has more than this
// Limits of the logarithm of the Bayes factor for a tube. With few modes, another object may be ten times as likely.
// Each further mode raises the limit, because on a tube it is evidence for the tube; from nine modes on, the tube must
// be the likelier object.
constexpr double kMinTubeEvidence = -2.3, kTubeEvidencePerMode = 0.5, kManyTubeModes = 9;
constexpr double kSameAngle_rad = 0.1;  // sensors at one angle see bending and hoop modes alike
constexpr double kMaxOutOfPhase = 0.4;  // RatioAngle::out_of_phase above which the shape is not real

struct Ratio {
  Complex value;
  double std = 0;
  double size = 1;  // of both residues together
  RatioAngle angle;
  bool known = false;
};

// The ratio of the residues at the two sensors, by least squares over the impact points.
Ratio ratio_of(const Mode& mode, const SensorPair& sensors) {
  double first_power = 0, second_power = 0, first_noise = 0, second_noise = 0;
  Complex cross;
  for (const Residue& a : mode.residues) {
    if (a.channel != sensors.first) continue;
    for (const Residue& b : mode.residues) {
      if (b.channel != sensors.second || b.point != a.point) continue;
      cross += std::conj(a.value) * b.value;
      first_power += std::norm(a.value);
      second_power += std::norm(b.value);
      first_noise += a.std * a.std;
      second_noise += b.std * b.std;
    }
  }
  Ratio ratio;
  if (!(first_power > 0)) return ratio;
  ratio.value = cross / first_power;
  const double ratio_power = std::norm(ratio.value);
  ratio.std = std::sqrt((second_noise + ratio_power * first_noise) / first_power);
  ratio.known = true;
  // The angle χ = atan(ratio) stays finite where the first sensor is at a node.
  const double size = std::sqrt(first_power + second_power);
  ratio.size = size;
  const double sign = cross.real() < 0 ? -1 : 1;
  ratio.angle.chi_rad = std::atan2(sign * std::sqrt(second_power), std::sqrt(first_power));
  ratio.angle.std_rad = std::sqrt((first_noise * second_power + second_noise * first_power)) / (size * size);
  // Relative to both residues, because a residue at a node is noise of any phase.
  ratio.angle.out_of_phase = 2 * std::abs(cross.imag()) / (size * size);
  return ratio;
}

std::vector<TypePosterior> posteriors_of(const std::vector<Mode>& modes, const std::vector<Ratio>& ratios,
                                         const SensorPair& sensors, const ClassifyOptions& options) {
  std::vector<TypeEvidence> evidence(modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    evidence[m].freq_Hz = modes[m].pole.freq_Hz;
    evidence[m].size = ratios[m].size;
    if (ratios[m].known) evidence[m].ratio = ratios[m].angle;
  }
  find_partners(evidence, options);
  const SetUpError error{.angle_rad = options.angle_std_rad, .gain = options.gain_std};
  return type_posteriors(evidence, RatioLikelihood(sensors.first_rad, sensors.second_rad, error));
}

// The least log_tube_evidence() of an object that counts as a tube.
double min_tube_evidence(std::size_t modes) {
  return std::clamp(kTubeEvidencePerMode * (static_cast<double>(modes) - kManyTubeModes), kMinTubeEvidence, 0.0);
}

bool is_tube(const std::vector<Ratio>& ratios, const SensorPair& sensors, const ClassifyOptions& options) {
  if (options.object != ObjectKind::automatic) return options.object == ObjectKind::tube;
  if (!options.angles_assumed) return true;
  std::vector<RatioAngle> angles;
  for (const Ratio& ratio : ratios) {
    if (ratio.known) angles.push_back(ratio.angle);
  }
  const SetUpError error{.angle_rad = options.angle_std_rad, .gain = options.gain_std};
  return log_tube_evidence(angles, RatioLikelihood(sensors.first_rad, sensors.second_rad, error)) >
         min_tube_evidence(angles.size());
}

void set_type(ModeClassification& classification, const TypePosterior& posterior, const Ratio& ratio) {
  if (!ratio.known) return;
  classification.ratio = ratio.value;
  classification.ratio_std = ratio.std;
  const bool bending = posterior[0] >= posterior[1];
  const double best = std::max(posterior[0], posterior[1]);
  const double rival = std::min(posterior[0], posterior[1]);
  const bool real_shape = ratio.angle.out_of_phase < kMaxOutOfPhase;
  classification.type =
      best >= kMinTypeProbability && real_shape ? (bending ? ModeType::bending : ModeType::hoop) : ModeType::unknown;
  classification.confidence = classification.type == ModeType::unknown ? 1 - best : best;
  if (classification.type == ModeType::unknown) {
    classification.alternative = bending ? ModeType::bending : ModeType::hoop;
  } else if (rival > kMinRivalProbability || best < kMinLoneProbability) {
    classification.alternative = bending ? ModeType::hoop : ModeType::bending;
  }
}

void mark_split_modes(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                      const ClassifyOptions& options) {
  for (std::size_t m = 0; m + 1 < modes.size(); ++m) {
    const double apart = modes[m + 1].pole.freq_Hz - modes[m].pole.freq_Hz;
    const double most_Hz = std::min(options.double_peak_Hz, kSplitSpacing * modes[m].pole.freq_Hz);
    const double error_Hz = kSplitDeviations * std::hypot(modes[m].freq_std_Hz, modes[m + 1].freq_std_Hz);
    if (apart > most_Hz + error_Hz || classifications[m].type != classifications[m + 1].type ||
        classifications[m].split_mode)
      continue;
    classifications[m].split_mode = SplitMode{.partner = m + 1, .separation_Hz = apart, .first = true};
    classifications[m + 1].split_mode = SplitMode{.partner = m, .separation_Hz = apart, .first = false};
  }
}

void number_orders(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                   const ClassifyOptions& options, const LowerOrders& lower) {
  for (const ModeType type : {ModeType::bending, ModeType::hoop}) {
    int order = type == ModeType::bending ? lower.bending : lower.hoop;
    std::optional<std::size_t> before;
    bool paired = false;  // a mode has at most one partner
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (classifications[m].type != type) continue;
      const bool same =
          before && !paired && near_enough_for_one_mode(modes[*before].pole.freq_Hz, modes[m].pole.freq_Hz, options);
      if (!same) ++order;
      paired = same;
      classifications[m].order = order;
      before = m;
    }
  }
}

// Planes of bending modes, and of hoop modes where the sensors are not at right angles.
void find_planes(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                 const SensorPair& sensors, const ClassifyOptions& options) {
  for (std::size_t m = 0; m < modes.size(); ++m) {
    auto& pair = classifications[m].split_mode;
    if (!pair || !pair->first || classifications[m].type == ModeType::unknown) continue;
    const int order = classifications[m].type == ModeType::bending ? 1 : 2;
    const auto plane = [&](std::size_t i) {
      return plane_from_sensors(modes[i], sensors, order, options.angle_std_rad);
    };
    describe_split(modes[m], modes[pair->partner], plane(m), plane(pair->partner), *pair,
                   *classifications[pair->partner].split_mode);
  }
}

}  // namespace

void assign_orders(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                   const ClassifyOptions& options, const LowerOrders& lower) {
  for (ModeClassification& classification : classifications) {
    classification.order = 0;
    classification.split_mode.reset();
  }
  mark_split_modes(modes, classifications, options);
  number_orders(modes, classifications, options, lower);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    auto& pair = classifications[m].split_mode;
    if (pair && pair->first)
      describe_split(modes[m], modes[pair->partner], {}, {}, *pair, *classifications[pair->partner].split_mode);
  }
}

const char* name_of(ModeType type) {
  switch (type) {
    case ModeType::bending:
      return "bending";
    case ModeType::hoop:
      return "hoop";
    case ModeType::unknown:
      return "unknown";
  }
  return "";
}

std::optional<SensorPair> pair_of_sensors(const std::vector<std::optional<double>>& angle_rad) {
  std::optional<SensorPair> best;
  double best_off = 0;
  for (std::size_t i = 0; i < angle_rad.size(); ++i) {
    for (std::size_t j = i + 1; j < angle_rad.size(); ++j) {
      if (!angle_rad[i] || !angle_rad[j]) continue;
      const double apart_rad = std::remainder(*angle_rad[j] - *angle_rad[i], 2 * std::numbers::pi);
      if (std::abs(apart_rad) < kSameAngle_rad) continue;
      const double off = std::abs(std::cos(*angle_rad[j] - *angle_rad[i]));  // 0 at a right angle
      if (best && off >= best_off) continue;
      best = SensorPair{.first = i, .second = j, .first_rad = *angle_rad[i], .second_rad = *angle_rad[j]};
      best_off = off;
    }
  }
  return best;
}

std::vector<double> three_over_bending(const std::vector<Mode>& modes, const SensorPair& sensors,
                                       const ClassifyOptions& options) {
  const RatioLikelihood likelihood(sensors.first_rad, sensors.second_rad,
                                   {.angle_rad = options.angle_std_rad, .gain = options.gain_std});
  std::vector<double> out;
  for (const Mode& mode : modes) {
    const Ratio ratio = ratio_of(mode, sensors);
    out.push_back(ratio.known ? likelihood.three_waves(ratio.angle) / likelihood.bending(ratio.angle) : 1);
  }
  return out;
}

std::vector<ModeClassification> classify(const std::vector<Mode>& modes, const std::optional<SensorPair>& sensors,
                                         const std::vector<std::optional<double>>& overlay_dB,
                                         const ClassifyOptions& options) {
  std::vector<ModeClassification> classifications(modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    classifications[m].overlay_dB = overlay_dB[m];
    classifications[m].overlaid = overlay_dB[m] && std::abs(*overlay_dB[m]) <= options.overlay_dB;
  }
  std::vector<Ratio> ratios;
  for (std::size_t m = 0; sensors && m < modes.size(); ++m) ratios.push_back(ratio_of(modes[m], *sensors));
  const bool tube = sensors && is_tube(ratios, *sensors, options);
  if (tube) {
    const auto posteriors = posteriors_of(modes, ratios, *sensors, options);
    for (std::size_t m = 0; m < modes.size(); ++m) set_type(classifications[m], posteriors[m], ratios[m]);
  }
  if (tube || options.object == ObjectKind::tube) assign_orders(modes, classifications, options);
  if (tube) allow_three_waves(modes, classifications, three_over_bending(modes, *sensors, options));
  if (tube) find_planes(modes, classifications, *sensors, options);
  return classifications;
}

}  // namespace percuss::identify
