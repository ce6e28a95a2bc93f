#include "report/analysis_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/units.hpp"
#include "identify/frf_synthesis.hpp"
#include "report/analysis_tables.hpp"
#include "report/curve_data.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFrfs = 8, kMostHitsShown = 12, kDecayPoints = 400;
constexpr double kSeen_dB = 0.01, kSeen_deg = 0.1, kSeen_coherence = 1e-4;
constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();

double level_dB_of(double amplitude) { return amplitude > 0 ? 20 * std::log10(amplitude) : kNotSeen; }

double level_of(const PointFrf& frf) {
  double sum = 0;
  for (const Complex& value : frf.frf.value) sum += std::norm(value);
  return sum;
}

std::string ascii_text(const Json& json) { return json.dump(-1, ' ', true, Json::error_handler_t::replace); }

Json numbers_json(std::span<const double> values, double coarsest) {
  PictureNumbers numbers = picture_numbers(values, coarsest);
  return {{"from", numbers.from}, {"step", numbers.step}, {"u16", std::move(numbers.u16)}};
}

// The strongest, in the order of the file.
std::vector<std::size_t> shown_frfs(const std::vector<PointFrf>& frfs) {
  std::vector<std::size_t> order(frfs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return level_of(frfs[a]) > level_of(frfs[b]); });
  order.resize(std::min(order.size(), kMostFrfs));
  std::sort(order.begin(), order.end());
  return order;
}

std::string name_of_frf(const Analysis& analysis, const PointFrf& frf) {
  const SignalInfo& signal = analysis.record().accel[frf.channel];
  std::string name = signal.name;
  if (signal.angle_rad) name += fmt::format(" ({:.4g}°)", *signal.angle_rad * kRadian_deg);
  return analysis.frf_points().size() > 1 ? fmt::format("point {}, {}", frf.point, name) : name;
}

Json curve_picture(const Analysis& analysis, const PointFrf& frf, const std::vector<Complex>* fit) {
  const auto picture = [](std::size_t count, double seen, auto value_of) {
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k) values[k] = value_of(k);
    return numbers_json(values, seen);
  };
  const auto& value = frf.frf.value;
  Json json{
      {"name", name_of_frf(analysis, frf)},
      {"db", picture(value.size(), kSeen_dB, [&](std::size_t k) { return level_dB_of(std::abs(value[k])); })},
      {"phase_deg", picture(value.size(), kSeen_deg, [&](std::size_t k) { return std::arg(value[k]) * kRadian_deg; })}};
  if (!frf.frf.coherence.empty())
    json["coherence"] = picture(value.size(), kSeen_coherence, [&](std::size_t k) { return frf.frf.coherence[k]; });
  if (!frf.frf.std.empty()) {
    json["sigma_db"] = picture(value.size(), kSeen_dB, [&](std::size_t k) {
      return std::min(40.0, level_dB_of(1 + frf.frf.std[k] / std::max(std::abs(value[k]), 1e-300)));
    });
  }
  if (fit != nullptr && fit->size() == value.size())
    json["fit_db"] = picture(value.size(), kSeen_dB, [&](std::size_t k) { return level_dB_of(std::abs((*fit)[k])); });
  return json;
}

Json frf_picture(const Analysis& analysis) {
  const auto& frfs = analysis.frfs();
  const FrfSet& set = analysis.fitted_frfs();
  std::vector<SynthesisedFrf> made;
  if (!analysis.modes().empty() && set.outputs.size() == frfs.size())
    made = synthesised_frfs(set, analysis.modes(), set.lines);
  Json json{{"first_hz", analysis.lines().freq_Hz(0)},
            {"df_hz", analysis.lines().df_Hz()},
            {"of", frfs.size()},
            {"curves", Json::array()}};
  for (const std::size_t i : shown_frfs(frfs)) {
    json["curves"].push_back(curve_picture(analysis, frfs[i], i < made.size() ? &made[i].value : nullptr));
  }
  return json;
}

// Where the mode is seen best.
std::size_t strongest_point(const Mode& mode) {
  const auto stronger = [](const Residue& a, const Residue& b) { return std::norm(a.value) < std::norm(b.value); };
  const auto best = std::max_element(mode.residues.begin(), mode.residues.end(), stronger);
  return best == mode.residues.end() ? 0 : best->point;
}

Json modes_picture(const Analysis& analysis, const std::vector<Verdict>& verdicts) {
  Json out = Json::array();
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const Mode& mode = analysis.modes()[m];
    const Verdict& verdict = verdicts[m];
    const std::size_t point = strongest_point(mode);
    Json json{{"hz", mode.pole.freq_Hz},
              {"zeta", mode.pole.damping_ratio},
              {"name", mode_name(verdict, m)},
              {"family", name_of(verdict.family)},
              {"sensors", Json::array()}};
    for (const Residue& residue : mode.residues) {
      const auto& angle_rad = analysis.record().accel[residue.channel].angle_rad;
      if (residue.point == point && angle_rad) {
        json["sensors"].push_back(
            {{"angle_rad", *angle_rad}, {"re", residue.value.real()}, {"im", residue.value.imag()}});
      }
    }
    out.push_back(std::move(json));
  }
  return out;
}

// The response's level from block to block after the onset, in dB under its largest.
Json decay_picture(const Analysis& analysis, const Hit& hit, std::size_t channel) {
  const Record& record = analysis.record();
  const std::size_t first = std::min(hit.peak, hit.first + hit.samples - 1), count = hit.first + hit.samples - first;
  std::vector<double> samples(count);
  record.read_accel_mps2(hit.row, channel, first, samples);
  double mean = 0;
  for (const double x : samples) mean += x / static_cast<double>(count);
  const std::size_t block = std::max<std::size_t>(1, count / kDecayPoints);
  std::vector<double> level_dB;
  for (std::size_t at = 0; at + block <= count; at += block) {
    double sum = 0;
    for (std::size_t i = at; i < at + block; ++i) sum += (samples[i] - mean) * (samples[i] - mean);
    level_dB.push_back(level_dB_of(std::sqrt(sum / static_cast<double>(block))));
  }
  const double highest = level_dB.empty() ? 0 : *std::max_element(level_dB.begin(), level_dB.end());
  for (double& level : level_dB) level -= highest;
  return {{"step_s", static_cast<double>(block) / record.fs_Hz}, {"db", numbers_json(level_dB, kSeen_dB)}};
}

Json hits_picture(const Analysis& analysis) {
  Json out = Json::array();
  const auto& hits = analysis.hits();
  for (std::size_t i = 0; i < hits.size() && out.size() < kMostHitsShown; ++i) {
    const Hit& hit = hits[i].hit;
    if (hit.gated_N.empty()) continue;
    const double start_s = static_cast<double>(hit.gate_first) / analysis.record().fs_Hz - hit.onset_s;
    Json json{{"name", fmt::format("hit {}", i)},
              {"accepted", hits[i].accepted},
              {"start_ms", start_s * 1e3},
              {"step_ms", 1e3 / analysis.record().fs_Hz},
              {"force_n", numbers_json(hit.gated_N, 0)},
              {"decay", Json::object()}};
    if (!hits[i].responses.empty()) json["decay"] = decay_picture(analysis, hit, 0);
    out.push_back(std::move(json));
  }
  return out;
}

Json stabilisation_picture(const Stabilisation& diagram) {
  std::vector<double> freq_Hz;
  std::string stability;
  Json orders = Json::array();
  for (const StabilisationPole& pole : diagram.poles) {
    freq_Hz.push_back(pole.pole.freq_Hz);
    orders.push_back(pole.order);
    stability += name_of(pole.stability)[0];
  }
  return {{"hz", numbers_json(freq_Hz, 0)}, {"order", std::move(orders)}, {"stability", stability}};
}

}  // namespace

std::string analysis_pictures(const Analysis& analysis, const std::vector<Verdict>& verdicts, bool stabilisation) {
  Json json = Json::object();
  if (analysis.given_frfs() == nullptr) {
    json["hits"] = hits_picture(analysis);
    json["of_hits"] = analysis.hits().size();
  }
  if (!analysis.possible()) return ascii_text(json);
  json["frf"] = frf_picture(analysis);
  json["modes"] = modes_picture(analysis, verdicts);
  if (stabilisation) json["stabilisation"] = stabilisation_picture(analysis.stabilisation());
  return ascii_text(json);
}

}  // namespace percuss
