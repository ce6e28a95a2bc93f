#include "pipeline/warnings/survey_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/mode_warnings.hpp"
#include "pipeline/warnings/sensor_name.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMaxNoiseRms = 1.6;         // rms of residues over their standard deviations: noise up to here
constexpr double kMinCertainRms = 5;         // … and certainly motion from here
constexpr double kMaxNodeSensitivity = 0.1;  // sensitivity below which a sensor sits on a node
constexpr double kMaxAsymmetry = 0.1;        // of the frequency: how far asymmetry splits a pair of modes
constexpr double kMaxDifference = 0.05;      // of reciprocal residues, relative, and
constexpr double kMaxDeviations = 4;         // … in standard deviations
// FRAC below which an FRF is poorly explained; level from which an FRF counts, relative to the strongest FRF.
constexpr double kPoorFrac = 0.99, kStrong_dB = -20;
constexpr std::size_t kMaxNamed = 8;

std::string mode_name(const SurveyResults& survey, std::size_t m) {
  return fmt::format("{} ({:.1f} Hz)", m + 1, survey.modes[m].pole.freq_Hz);
}

void add_name(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

struct NamedModes {
  std::string names;
  std::size_t count = 0;

  void add(const SurveyResults& survey, std::size_t m, const std::string& remark = "") {
    add_name(names, mode_name(survey, m) + remark);
    ++count;
  }
  // "mode 1 (175.2 Hz)", "modes 1 (175.2 Hz), 3 (661.0 Hz)"
  std::string text() const { return fmt::format("mode{} {}", plural(count), names); }
};

// Root mean square of the mode's residues at one channel over their noise.
double residue_rms(const identify::Mode& mode, std::size_t channel) {
  double sum = 0, count = 0;
  for (const identify::Residue& r : mode.residues) {
    if (r.channel != channel || !(r.std > 0)) continue;
    sum += std::norm(r.value) / (2 * r.std * r.std);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : kMinCertainRms;
}

void warn_of_nodes(const SurveyResults& survey, std::vector<Warning>& out) {
  const std::vector<identify::Mode>& modes = survey.modes;
  const std::vector<acquire::SignalInfo>& accel = survey.accel;
  NamedModes nowhere;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (survey.shapes[m].significance < kMaxNoiseRms) nowhere.add(survey, m);
  }
  if (nowhere.count > 0) {
    const bool several = nowhere.count > 1;
    out.push_back(with_remedy({"sensor_on_node", "the residues of " + nowhere.text() +
                                                     " lie within their noise at every point: every sensor may sit on "
                                                     "a node of " +
                                                     (several ? "each of these modes" : "this mode")},
                              several ? "place sensors where the modes move" : "place a sensor where the mode moves"));
  }
  if (survey.roving != identify::Roving::hammer) return;
  for (std::size_t c = 0; c < accel.size() && accel.size() > 1; ++c) {
    NamedModes blind;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (std::find(survey.repeated.begin(), survey.repeated.end(), m) != survey.repeated.end()) continue;
      if (survey.shapes[m].significance > kMinCertainRms && residue_rms(modes[m], c) < kMaxNoiseRms)
        blind.add(survey, m);
    }
    if (blind.count == 0) continue;
    out.push_back(
        with_remedy({"sensor_on_node", fmt::format("{} sits on a node of {}: only the other sensors measure {}",
                                                   one_line(accel[c].name, kMaxNameBytes), blind.text(),
                                                   blind.count > 1 ? "their shapes" : "its shape")},
                    "move this sensor if the others do not suffice"));
  }
}

// The partner has the same circumferential order and pattern, and nearly the same frequency.
bool has_partner(const SurveyResults& survey, std::size_t m) {
  const identify::TubeShape& own = *survey.tubes[m];
  const auto& modes = survey.modes;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& other = survey.tubes[i];
    if (i == m || !other || other->order != own.order || other->sign_changes != own.sign_changes) continue;
    if (std::abs(modes[i].pole.freq_Hz - modes[m].pole.freq_Hz) <= kMaxAsymmetry * modes[m].pole.freq_Hz) return true;
  }
  return false;
}

// The largest sensitivity of any sensor to the partner, 1 at its antinode; nothing when an angle is not stated.
std::optional<double> partner_sensitivity(const SurveyResults& survey, const identify::TubeShape& tube) {
  double largest = 0;
  for (const acquire::SignalInfo& signal : survey.accel) {
    if (!signal.angle_rad) return std::nullopt;
    largest = std::max(largest, std::abs(std::sin(tube.order * (*signal.angle_rad - *tube.plane_rad))));
  }
  return largest;
}

// On a tube every mode with n ≥ 1 has a partner turned by 90°/n. Where one of the two was not found, a sensor on its
// node would explain that.
void warn_of_partners(const SurveyResults& survey, std::vector<Warning>& out) {
  if (survey.roving != identify::Roving::hammer) return;
  NamedModes blind, unknown;
  for (std::size_t m = 0; m < survey.tubes.size(); ++m) {
    const auto& tube = survey.tubes[m];
    if (!tube || tube->order < 1 || !tube->plane_rad || has_partner(survey, m)) continue;
    const auto sensitivity = partner_sensitivity(survey, *tube);
    if (!sensitivity) {
      unknown.add(survey, m);
    } else if (*sensitivity < kMaxNodeSensitivity) {
      const double turned_deg = std::fmod(*tube->plane_rad * kRadian_deg + 90.0 / tube->order, 180.0 / tube->order);
      blind.add(survey, m, fmt::format(" (its partner's antinode at {:.0f}°)", turned_deg));
    }
  }
  const std::string pairs =
      "a tube's modes come in pairs of one pattern, turned by 90°/n, but no partner was found for ";
  if (blind.count > 0) {
    out.push_back(
        with_remedy({"sensor_on_node", pairs + blind.text() +
                                           (blind.count > 1 ? "; the sensors sit on the partners' nodes and cannot "
                                                              "measure them"
                                                            : "; the sensors sit on the partner's nodes and cannot "
                                                              "measure it")},
                    "add a sensor half way between these nodes"));
  }
  if (unknown.count > 0) {
    out.push_back(with_remedy({"sensor_on_node",
                               pairs + unknown.text() +
                                   (unknown.count > 1 ? "; each partner may have the same frequency, or the sensor may "
                                                        "sit on its node"
                                                      : "; the partner may have the same frequency, or the sensor may "
                                                        "sit on its node"),
                               {"angle"}},
                              "state the sensor's angle to check that"));
  }
}

std::string name_of_point(const SurveyResults& survey, std::size_t point) {
  return survey.names.name(static_cast<int>(point));
}

// "modes 1, 3 at point 8 (P8.csv), accel 1": the modes of each driving point whose residue has the wrong sign.
std::string wrong_signs(const SurveyResults& survey) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> modes;  // by point and channel
  for (const identify::DrivingPointCheck& check : survey.driving_checks) {
    if (check.wrong_sign) modes[{check.at.point, check.at.channel}].push_back(check.mode + 1);
  }
  std::string out;
  for (const auto& [at, wrong] : modes) {
    add_name(out, fmt::format("mode{} {} at point {}, {}", plural(wrong.size()), fmt::join(wrong, ", "),
                              name_of_point(survey, at.first), sensor_name(survey.accel, at.second)));
  }
  return out;
}

// The channels at whose driving points every significant residue has the wrong sign.
std::set<std::size_t> reversed_channels(const SurveyResults& survey) {
  std::set<std::size_t> wrong;
  for (const identify::DrivingPointCheck& check : survey.driving_checks) {
    if (check.wrong_sign) wrong.insert(check.at.channel);
  }
  for (const identify::DrivingPointCheck& check : survey.driving_checks) {
    if (check.right_sign) wrong.erase(check.at.channel);
  }
  return wrong;
}

Warning wrong_driving_signs(const SurveyResults& survey, const std::string& wrong) {
  const bool opposite = std::any_of(survey.driving_checks.begin(), survey.driving_checks.end(),
                                    [](const auto& check) { return check.at.sign < 0; });
  const std::string must = opposite ? "have the sign that the stated directions give" : "be positive";
  Warning warning{"driving_point_sign",
                  fmt::format("a driving point's residue must {}, and {} not for {}: the sensor or the hammer may "
                              "point the other way, or they may not be at the same point. Modal masses and the sign "
                              "of shapes are wrong then",
                              must, opposite ? "has it" : "is", wrong)};
  std::string remedy = "check direction and place of the sensor and of the hits";
  const std::set<std::size_t> channels = reversed_channels(survey);
  if (channels.empty()) return with_remedy(std::move(warning), remedy);
  std::string names, scales;
  for (const std::size_t c : channels) add_name(names, sensor_name(survey.accel, c));
  for (std::size_t c = 0; c < survey.accel.size(); ++c)
    scales += fmt::format("{}{:.9g}", c == 0 ? "" : ",", (channels.contains(c) ? -1 : 1) * survey.accel[c].to_SI);
  remedy += fmt::format(
      R"(. If {} points against the blows, state the directions of force and sensor in the set-up, or "sign": -1 for )"
      "the sensor (remove it where it is stated)",
      names);
  warning.options = {"setup"};
  if (survey.has_samples) {
    remedy += fmt::format("; or, without a set-up, the scale {}", scales);
    warning.options.emplace_back("accel_scale");
  }
  return with_remedy(std::move(warning), remedy);
}

void warn_of_signs(const SurveyResults& survey, std::vector<Warning>& out) {
  const std::string wrong = wrong_signs(survey);
  if (!wrong.empty()) out.push_back(wrong_driving_signs(survey, wrong));
  std::string broken;
  for (const identify::ReciprocityCheck& check : survey.reciprocity) {
    if (check.difference > kMaxDifference && check.deviations > kMaxDeviations) {
      add_name(broken, fmt::format("mode {}, points {} and {} ({:.0f} %)", check.mode + 1,
                                   name_of_point(survey, check.one.point), name_of_point(survey, check.other.point),
                                   check.difference * 100));
    }
  }
  if (!broken.empty()) {
    out.push_back(with_remedy(
        {"reciprocity", "residues must be equal when force and response change places, and are not: " + broken},
        "check the sensors' calibration, direction and position"));
  }
}

void warn_of_frac(const SurveyResults& survey, std::vector<Warning>& out) {
  std::string poor;
  std::size_t count = 0;
  for (const identify::SynthesisedFrf& frf : survey.synthesis) {
    if (!poorly_explained(frf) || ++count > kMaxNamed) continue;
    add_name(poor, fmt::format("point {} {} ({:.4f}{})", survey.names.name(survey.frf_points[frf.point]),
                               sensor_name(survey.accel, frf.channel), frf.frac,
                               noise_alone(frf) ? ", the rest is noise" : ""));
  }
  if (count == 0) return;
  if (count > kMaxNamed) poor += fmt::format(" and {} more", count - kMaxNamed);
  out.push_back(with_remedy({"frac", "the modes explain less than 99 % (FRAC) of the FRF of " + poor +
                                         ": modes may be missing, hits may be poor, or noise is large"},
                            "look at these FRFs and their hits, and add hits where noise is the rest"));
}

void warn_of_pairs(const SurveyResults& survey, std::vector<Warning>& out) {
  std::string pairs;
  for (std::size_t m = 0; m < survey.classifications.size(); ++m) {
    const auto& pair = survey.classifications[m].split_mode;
    if (!pair || !pair->first || !is_split_hoop(survey.modes, survey.classifications, m)) continue;
    std::string text = fmt::format("{:.1f} Hz ({:.1f} Hz apart", survey.modes[m].pole.freq_Hz, pair->separation_Hz);
    if (pair->planes) {
      text += fmt::format(", planes {:.2f} ± {:.2g}° apart", pair->planes->between_rad * kRadian_deg,
                          pair->planes->between_std_rad * kRadian_deg);
    }
    add_name(pairs, text + (pair->quoted ? ")" : "; here the second peak is quoted, because it hides the first)"));
  }
  if (!pairs.empty()) {
    out.push_back({"double_peak", "split modes, listed by their first peak: " + pairs +
                                      ". Planes turned by 90°/n indicate uneven wall or material; other possible "
                                      "causes: a tuned absorber, a crack or other damage"});
  }
}

}  // namespace

bool poorly_explained(const identify::SynthesisedFrf& frf) {
  return frf.level_dB >= kStrong_dB && !(frf.frac >= kPoorFrac);
}

bool noise_alone(const identify::SynthesisedFrf& frf) {
  return (1 - frf.frac) * (1 - frf.noise_share) <= 1 - kPoorFrac;
}

std::vector<Warning> survey_warnings(const SurveyResults& survey) {
  std::vector<Warning> out;
  if (!survey.has_geometry) {
    out.push_back(with_remedy({"no_geometry",
                               "the positions of the points are not known, so shapes cannot name modes",
                               {"geometry", "survey.example"}},
                              "state the geometry, or print an example of it"));
  }
  warn_of_nodes(survey, out);
  warn_of_partners(survey, out);
  warn_of_signs(survey, out);
  warn_of_frac(survey, out);
  warn_of_pairs(survey, out);
  return out;
}

}  // namespace percuss::pipeline
