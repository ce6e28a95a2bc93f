#include "identify/classify/classify.hpp"

#include <algorithm>
#include <cmath>

#include "identify/classify/asymmetry_split.hpp"
#include "identify/classify/type_posterior.hpp"

namespace percuss {
namespace {

constexpr double kPairSpacing = 0.04;   // of the frequency: the two planes of one bending mode lie closer than this
constexpr double kSplitSpacing = 0.15;  // of the frequency: the 25 Hz rule is for bats, whose modes lie above 100 Hz
constexpr double kSure = 0.9;           // below it the rival is named
constexpr double kRival = 0.03;
constexpr double kComplex = 0.4;  // imaginary over whole ratio above which no real shape explains it

struct Ratio {
  Complex value;
  double std = 0;
  double size = 1;  // of both residues
  RatioAngle angle;
  bool known = false;
};

// Least squares over the points hit: every point's pair of residues has the same ratio.
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
  const double mean_square = std::norm(ratio.value);
  ratio.std = std::sqrt((second_noise + mean_square * first_noise) / first_power);
  ratio.known = true;
  // As an angle χ = atan(ratio): well behaved when the first sensor sits on a node.
  const double size = std::sqrt(first_power + second_power);
  ratio.size = size;
  const double sign = cross.real() < 0 ? -1 : 1;
  ratio.angle.chi_rad = std::atan2(sign * std::sqrt(second_power), std::sqrt(first_power));
  ratio.angle.std_rad = std::sqrt((first_noise * second_power + second_noise * first_power)) / (size * size);
  // Relative to both: what one sensor sees at its node is noise, of any phase.
  ratio.angle.out_of_phase = 2 * std::abs(cross.imag()) / (size * size);
  return ratio;
}

bool close_pair(const Mode& a, const Mode& b, const ClassifyOptions& options) {
  const double apart = std::abs(a.pole.freq_Hz - b.pole.freq_Hz);
  return apart <= std::max(options.double_peak_Hz, kPairSpacing * std::min(a.pole.freq_Hz, b.pole.freq_Hz));
}

std::optional<std::size_t> partner_of(const std::vector<Mode>& modes, std::size_t m, const ClassifyOptions& options) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i == m || !close_pair(modes[i], modes[m], options)) continue;
    const auto apart = [&](std::size_t j) { return std::abs(modes[j].pole.freq_Hz - modes[m].pole.freq_Hz); };
    if (!best || apart(i) < apart(*best)) best = i;
  }
  return best;
}

std::vector<Belief> beliefs_of(const std::vector<Mode>& modes, const std::vector<Ratio>& ratios,
                               const SensorPair& sensors, const ClassifyOptions& options) {
  std::vector<FamilyEvidence> evidence(modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    evidence[m].freq_Hz = modes[m].pole.freq_Hz;
    evidence[m].size = ratios[m].size;
    if (ratios[m].known) evidence[m].ratio = ratios[m].angle;
    const auto partner = partner_of(modes, m, options);
    if (partner && partner_of(modes, *partner, options) == m) evidence[m].partner = partner;
  }
  const SetUpError error{.angle_rad = options.angle_std_rad, .gain = options.gain_std};
  return family_beliefs(evidence, RatioLikelihood(sensors.first_rad, sensors.second_rad, error));
}

void judge(Verdict& verdict, const Belief& belief, const Ratio& ratio) {
  if (!ratio.known) return;
  verdict.ratio = ratio.value;
  verdict.ratio_std = ratio.std;
  const bool bending = belief[0] >= belief[1];
  const double best = std::max(belief[0], belief[1]);
  const double rival = std::min(belief[0], belief[1]);
  const bool real_shape = ratio.angle.out_of_phase < kComplex;
  verdict.family = best >= kNamed && real_shape ? (bending ? Family::bending : Family::hoop) : Family::unknown;
  verdict.confidence = verdict.family == Family::unknown ? 1 - best : best;
  if (verdict.family == Family::unknown) {
    verdict.alternative = bending ? Family::bending : Family::hoop;
  } else if (rival > kRival || best < kSure) {
    verdict.alternative = bending ? Family::hoop : Family::bending;
  }
}

void mark_double_peaks(const std::vector<Mode>& modes, std::vector<Verdict>& verdicts, const ClassifyOptions& options) {
  for (std::size_t m = 0; m + 1 < modes.size(); ++m) {
    const double apart = modes[m + 1].pole.freq_Hz - modes[m].pole.freq_Hz;
    const double most_Hz = std::min(options.double_peak_Hz, kSplitSpacing * modes[m].pole.freq_Hz);
    if (apart > most_Hz || verdicts[m].family != verdicts[m + 1].family || verdicts[m].double_peak) continue;
    verdicts[m].double_peak = DoublePeak{.partner = m + 1, .separation_Hz = apart, .first = true};
    verdicts[m + 1].double_peak = DoublePeak{.partner = m, .separation_Hz = apart, .first = false};
  }
}

void number_orders(const std::vector<Mode>& modes, std::vector<Verdict>& verdicts, const ClassifyOptions& options) {
  for (const Family family : {Family::bending, Family::hoop}) {
    int order = 0;
    std::optional<std::size_t> before;
    bool paired = false;  // a mode has one partner at most
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (verdicts[m].family != family) continue;
      const bool same = before && !paired && close_pair(modes[*before], modes[m], options);
      if (!same) ++order;
      paired = same;
      verdicts[m].order = order;
      before = m;
    }
  }
}

// Bending planes; those of hoop modes where the sensors do not stand at right angles.
void find_planes(const std::vector<Mode>& modes, std::vector<Verdict>& verdicts, const SensorPair& sensors,
                 const ClassifyOptions& options) {
  for (std::size_t m = 0; m < modes.size(); ++m) {
    auto& pair = verdicts[m].double_peak;
    if (!pair || !pair->first || verdicts[m].family == Family::unknown) continue;
    const int order = verdicts[m].family == Family::bending ? 1 : 2;
    const auto plane = [&](std::size_t i) {
      return plane_from_sensors(modes[i], sensors, order, options.angle_std_rad);
    };
    describe_split(modes[m], modes[pair->partner], plane(m), plane(pair->partner), *pair,
                   *verdicts[pair->partner].double_peak);
  }
}

}  // namespace

void number_verdicts(const std::vector<Mode>& modes, std::vector<Verdict>& verdicts, const ClassifyOptions& options) {
  for (Verdict& verdict : verdicts) {
    verdict.order = 0;
    verdict.double_peak.reset();
  }
  mark_double_peaks(modes, verdicts, options);
  number_orders(modes, verdicts, options);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    auto& pair = verdicts[m].double_peak;
    if (pair && pair->first)
      describe_split(modes[m], modes[pair->partner], {}, {}, *pair, *verdicts[pair->partner].double_peak);
  }
}

const char* name_of(Family family) {
  switch (family) {
    case Family::bending:
      return "bending";
    case Family::hoop:
      return "hoop";
    case Family::unknown:
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
      const double off = std::abs(std::cos(*angle_rad[j] - *angle_rad[i]));  // 0 at a right angle
      if (best && off >= best_off) continue;
      best = SensorPair{.first = i, .second = j, .first_rad = *angle_rad[i], .second_rad = *angle_rad[j]};
      best_off = off;
    }
  }
  return best;
}

std::vector<Verdict> classify(const std::vector<Mode>& modes, const std::optional<SensorPair>& sensors,
                              const std::vector<std::optional<double>>& overlay_dB, const ClassifyOptions& options) {
  std::vector<Verdict> verdicts(modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    verdicts[m].overlay_dB = overlay_dB[m];
    verdicts[m].overlaid = overlay_dB[m] && std::abs(*overlay_dB[m]) <= options.overlay_dB;
  }
  if (sensors) {
    std::vector<Ratio> ratios;
    ratios.reserve(modes.size());
    for (const Mode& mode : modes) ratios.push_back(ratio_of(mode, *sensors));
    const auto beliefs = beliefs_of(modes, ratios, *sensors, options);
    for (std::size_t m = 0; m < modes.size(); ++m) judge(verdicts[m], beliefs[m], ratios[m]);
  }
  number_verdicts(modes, verdicts, options);
  if (sensors) find_planes(modes, verdicts, *sensors, options);
  return verdicts;
}

}  // namespace percuss
