#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "pipeline/survey.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kNoise = 1.6;               // root mean square over deviations up to which residues are noise
constexpr double kSeen = 5;                  // … and from which a mode is there for certain
constexpr double kMaxNodeSensitivity = 0.1;  // sensitivity below which a sensor sits on a node
constexpr double kRoundPair = 0.1;           // of the frequency: how far asymmetry splits a ring mode
constexpr double kReciprocal = 0.05;         // of the residue, and
constexpr double kDeviations = 4;
constexpr std::size_t kMaxNamed = 8;

std::string mode_name(const Survey& survey, std::size_t m) {
  return fmt::format("{} ({:.1f} Hz)", m, survey.analysis().modes()[m].pole.freq_Hz);
}

void add_name(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

double seen_by(const identify::Mode& mode, std::size_t channel) {
  double sum = 0, count = 0;
  for (const identify::Residue& r : mode.residues) {
    const double std = identify::total_std(r);
    if (r.channel != channel || !(std > 0)) continue;
    sum += std::norm(r.value) / (2 * std * std);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : kSeen;
}

void warn_of_nodes(const Survey& survey, std::vector<Warning>& out) {
  const auto& modes = survey.analysis().modes();
  const auto& accel = survey.analysis().record().accel;
  std::string nowhere;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (survey.shapes()[m].significance < kNoise) add_name(nowhere, mode_name(survey, m));
  }
  if (!nowhere.empty()) {
    out.push_back(
        {"sensor_on_node", "the residues of mode " + nowhere +
                               " lie within their noise at every point: every sensor may sit on a node of it"});
  }
  if (survey.options().roving != identify::Roving::hammer) return;
  for (std::size_t c = 0; c < accel.size() && accel.size() > 1; ++c) {
    std::string blind;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (survey.shapes()[m].significance > kSeen && seen_by(modes[m], c) < kNoise)
        add_name(blind, mode_name(survey, m));
    }
    if (blind.empty()) continue;
    out.push_back({"sensor_on_node", fmt::format("{} sits on a node of mode {}: only the other sensors tell its shape",
                                                 one_line(accel[c].name, 40), blind)});
  }
}

bool has_partner(const Survey& survey, std::size_t m) {
  const identify::TubeShape& own = *survey.tubes()[m];
  const auto& modes = survey.analysis().modes();
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& other = survey.tubes()[i];
    if (i == m || !other || other->order != own.order || other->sign_changes != own.sign_changes) continue;
    if (std::abs(modes[i].pole.freq_Hz - modes[m].pole.freq_Hz) <= kRoundPair * modes[m].pole.freq_Hz) return true;
  }
  return false;
}

// The largest part of the partner's antinode that any sensor sees; nothing when an angle is not stated.
std::optional<double> sight_of_partner(const Survey& survey, const identify::TubeShape& tube) {
  double most = 0;
  for (const acquire::SignalInfo& signal : survey.analysis().record().accel) {
    if (!signal.angle_rad) return std::nullopt;
    most = std::max(most, std::abs(std::sin(tube.order * (*signal.angle_rad - *tube.plane_rad))));
  }
  return most;
}

// On a tube every mode with n ≥ 1 has a partner turned by 90°/n. Where only one of the two was found, a sensor on the
// other's node would explain it.
void warn_of_partners(const Survey& survey, std::vector<Warning>& out) {
  if (survey.options().roving != identify::Roving::hammer) return;
  std::string blind, unknown;
  for (std::size_t m = 0; m < survey.tubes().size(); ++m) {
    const auto& tube = survey.tubes()[m];
    if (!tube || tube->order < 1 || !tube->plane_rad || has_partner(survey, m)) continue;
    const auto sight = sight_of_partner(survey, *tube);
    if (!sight) {
      add_name(unknown, mode_name(survey, m));
    } else if (*sight < kMaxNodeSensitivity) {
      const double turned_deg = std::fmod(*tube->plane_rad * kRadian_deg + 90.0 / tube->order, 180.0 / tube->order);
      add_name(blind, mode_name(survey, m) + fmt::format(" (its partner's antinode at {:.0f}°)", turned_deg));
    }
  }
  const std::string pairs = "a tube's modes come in pairs turned against each other, and one only was found for mode ";
  if (!blind.empty()) {
    out.push_back({"sensor_on_node", pairs + blind +
                                         "; the sensors sit on the nodes of the other, which they could not see: a "
                                         "sensor half way between its nodes would tell"});
  }
  if (!unknown.empty()) {
    out.push_back({"sensor_on_node", pairs + unknown +
                                         "; the other may have the same frequency, or the sensor may sit on its node: "
                                         "state the sensor's angle (--angle) to have that checked"});
  }
}

void warn_of_signs(const Survey& survey, std::vector<Warning>& out) {
  std::string wrong;
  for (const identify::DrivingPointCheck& check : survey.driving_checks()) {
    if (check.wrong_sign)
      add_name(wrong, fmt::format("mode {} at point {}, channel {}", check.mode, check.at.point, check.at.channel));
  }
  if (!wrong.empty()) {
    out.push_back({"driving_point_sign", "a driving point's residue must be positive, and is not for " + wrong +
                                             ": the sensor or the hammer may point the other way, or they are not at "
                                             "one place"});
  }
  std::string broken;
  for (const identify::ReciprocityCheck& check : survey.reciprocity()) {
    if (check.difference > kReciprocal && check.deviations > kDeviations) {
      add_name(broken, fmt::format("mode {}, points {} and {} ({:.0f} %)", check.mode, check.one.point,
                                   check.other.point, check.difference * 100));
    }
  }
  if (!broken.empty()) {
    out.push_back({"reciprocity", "residues that must be equal both ways round are not: " + broken +
                                      "; check the sensors' calibration, direction and place"});
  }
}

void warn_of_frac(const Survey& survey, std::vector<Warning>& out) {
  std::string poor;
  std::size_t count = 0;
  const auto points = survey.analysis().frf_points();
  for (const identify::SynthesisedFrf& frf : survey.synthesis()) {
    if (!poorly_explained(frf) || ++count > kMaxNamed) continue;
    add_name(poor, fmt::format("point {} channel {} ({:.4f}{})", points[frf.point], frf.channel, frf.frac,
                               noise_alone(frf) ? ", the rest noise" : ""));
  }
  if (count == 0) return;
  if (count > kMaxNamed) poor += fmt::format(" and {} more", count - kMaxNamed);
  out.push_back(
      {"frac", "the modes explain less than 99 % (FRAC) of the FRF of " + poor +
                   ": modes may be missing, or hits were poor; what is noise changes from line to line, and more "
                   "averages help"});
}

void warn_of_pairs(const Survey& survey, std::vector<Warning>& out) {
  std::string pairs;
  for (std::size_t m = 0; m < survey.classifications().size(); ++m) {
    const auto& pair = survey.classifications()[m].split_mode;
    if (!pair || !pair->first) continue;
    std::string text =
        fmt::format("{:.1f} Hz ({:.1f} Hz apart", survey.analysis().modes()[m].pole.freq_Hz, pair->separation_Hz);
    if (pair->planes) {
      text += fmt::format(", planes {:.2f} ± {:.2g}° apart", pair->planes->between_rad * kRadian_deg,
                          pair->planes->between_std_rad * kRadian_deg);
    }
    add_name(pairs, text + (pair->quoted ? ")" : "; the second is quoted, which hides it)"));
  }
  if (!pairs.empty()) {
    out.push_back({"double_peak", "double peaks, of which the first is quoted: " + pairs +
                                      ". Planes turned by 90°/n tell uneven wall or material; possible causes else: a "
                                      "tuned absorber, a crack or other damage"});
  }
}

}  // namespace

std::vector<Warning> survey_warnings(const Survey& survey) {
  std::vector<Warning> out;
  if (!survey.geometry()) {
    out.push_back({"no_geometry",
                   "where the points lie is not known, so that shapes cannot name modes: give --geometry "
                   "(percuss survey --example prints one)"});
  }
  warn_of_nodes(survey, out);
  warn_of_partners(survey, out);
  warn_of_signs(survey, out);
  warn_of_frac(survey, out);
  warn_of_pairs(survey, out);
  return out;
}

}  // namespace percuss::pipeline
