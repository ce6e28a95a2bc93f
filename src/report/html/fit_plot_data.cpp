#include "report/html/fit_plot_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "identify/start/mif.hpp"
#include "report/json/quantised_curve.hpp"
#include "report/json/rice_code.hpp"
#include "report/svg/plot_geometry.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// The wanted limit of the bytes of all FRFs together, and the fewest and most lines of one FRF.
constexpr std::size_t kMaxBytesOfAll = 120'000, kMinLines = 100, kMaxLines = 4000;
constexpr std::size_t kMaxPeaks = 20;
constexpr double kStep_dB = 0.1, kResidualStep_dB = 1, kStepsPerTurn = 512, kMaxLevel_dB = 400;

std::int32_t level_steps(double amplitude, double step_dB) {
  const double level_dB = 20 * std::log10(std::max(amplitude, 1e-300));
  return static_cast<std::int32_t>(std::lround(std::clamp(level_dB, -kMaxLevel_dB, kMaxLevel_dB) / step_dB));
}

// Steps of a phase, within half a turn of the steps before, so that they change little.
std::int32_t phase_steps(double phase_rad, std::int32_t before) {
  const double steps = std::round(phase_rad / kTwoPi * kStepsPerTurn);
  return static_cast<std::int32_t>(steps + kStepsPerTurn * std::round((before - steps) / kStepsPerTurn));
}

std::string packed_frf(const std::vector<Complex>& measured, const std::vector<Complex>* made,
                       const std::vector<std::size_t>& lines) {
  std::vector<std::int32_t> level, phase, level_change, phase_change, residual;
  std::int32_t turned = 0, change = 0;
  for (const std::size_t k : lines) {
    level.push_back(level_steps(std::abs(measured[k]), kStep_dB));
    phase.push_back(turned = phase_steps(std::arg(measured[k]), turned));
    if (made == nullptr) continue;
    level_change.push_back(level_steps(std::abs((*made)[k]), kStep_dB) - level.back());
    phase_change.push_back(change = phase_steps(std::arg((*made)[k]) - kTwoPi * turned / kStepsPerTurn, change));
    residual.push_back(level_steps(std::abs(measured[k] - (*made)[k]), kResidualStep_dB));
  }
  RiceCode code;
  code.add(level);
  code.add(phase);
  if (made != nullptr) {
    code.add(level_change);
    code.add(phase_change);
    code.add(residual);
  }
  return code.base64_text();
}

std::string packed_lines(const std::vector<std::size_t>& lines) {
  std::vector<std::int32_t> numbers;
  numbers.reserve(lines.size());
  for (const std::size_t line : lines) numbers.push_back(static_cast<std::int32_t>(line));
  RiceCode code;
  code.add(numbers);
  return code.base64_text();
}

std::string channel_title(const acquire::SignalInfo& signal) {
  return signal.angle_rad ? fmt::format("{} ({:.4g}°)", signal.name, *signal.angle_rad * kRadian_deg) : signal.name;
}

Json places_json(const pipeline::Survey& survey, const std::vector<int>& points) {
  Json out = Json::array();
  for (const int point : points) {
    const auto at = plot_position(survey, static_cast<std::size_t>(point));
    if (!at) {
      out.push_back(nullptr);
      continue;
    }
    Json place = Json::array();
    for (const double x : *at) place.push_back(std::round(x * 1e5) / 1e5);
    out.push_back(std::move(place));
  }
  return out;
}

// [points] the number of each point as a number, or its name as a text if the name says more.
Json names_json(const pipeline::PointNames& names, const std::vector<int>& points) {
  Json out = Json::array();
  for (const int point : points) {
    const std::string name = names.name(point);
    out.push_back(name == std::to_string(point) ? Json(point) : Json(name));
  }
  return out;
}

}  // namespace

std::vector<std::size_t> drawn_lines(const acquire::LineRange& band, const std::vector<identify::Mode>& modes,
                                     const std::vector<identify::UnmodelledPeak>& peaks, std::size_t limit) {
  std::vector<std::size_t> lines;
  if (band.count <= limit) {
    for (std::size_t k = 0; k < band.count; ++k) lines.push_back(k);
    return lines;
  }
  // Resonance curves as densities: up to half of the lines for all of them together.
  constexpr double kWidths = 2, kMinHalfWidth = 2;  // half-power bandwidths; lines
  const auto count = static_cast<double>(band.count);
  std::vector<double> density(band.count, 1 / count);
  const double share = 1 / static_cast<double>(modes.size() + peaks.size() + 1);
  const auto add = [&](double freq_Hz, double half_width) {
    for (std::size_t k = 0; k < band.count; ++k) {
      const double x = (static_cast<double>(k) - band.position(freq_Hz)) / half_width;
      density[k] += share / (kTwoPi / 2 * half_width * (1 + x * x));
    }
  };
  for (const identify::Mode& mode : modes)
    add(mode.pole.freq_Hz, std::max(kWidths * mode.pole.half_power_Hz() / band.df_Hz(), kMinHalfWidth));
  for (const identify::UnmodelledPeak& peak : peaks) add(peak.freq_Hz, kMinHalfWidth);
  double all = 0, sum = 0;
  for (const double d : density) all += d;
  double next = 0;
  for (std::size_t k = 0; k < band.count; ++k) {
    sum += density[k];
    if (sum < next && k + 1 < band.count) continue;
    lines.push_back(k);
    next = std::max(next, sum) + all / static_cast<double>(limit);
  }
  // The tops of the resonances, whatever the density.
  const std::size_t beside = 6 * modes.size() <= limit ? 1 : 0;
  const auto add_top = [&](double freq_Hz, std::size_t around) {
    const std::size_t at = band.nearest(freq_Hz) - band.first;
    for (std::size_t k = at - std::min(at, around); k <= std::min(at + around, band.count - 1); ++k) lines.push_back(k);
  };
  for (const identify::Mode& mode : modes) add_top(mode.pole.freq_Hz, beside);
  for (const identify::UnmodelledPeak& peak : peaks) add_top(peak.freq_Hz, 0);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

Json fit_plot_json(const pipeline::Analysis& analysis, const pipeline::Survey* survey) {
  const identify::FrfDataset& set = analysis.fitted_frfs();
  const acquire::LineRange band = analysis.band_lines();
  const std::vector<identify::Mode> modes = analysis.fitted_modes();
  const std::vector<int> points = analysis.frf_points();
  std::vector<identify::UnmodelledPeak> peaks = analysis.unexplained_peaks();
  peaks.resize(std::min(peaks.size(), kMaxPeaks));
  static const std::vector<identify::SynthesisedFrf> kNone;
  const std::vector<identify::SynthesisedFrf>& made = modes.empty() ? kNone : analysis.synthesis();
  const auto skip = static_cast<std::ptrdiff_t>(band.first - set.lines.first);
  const auto packed = [&](const std::vector<std::size_t>& lines) {
    std::vector<std::string> out;
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const auto first = set.channels[o].frf.begin() + skip;
      const std::vector<Complex> measured(first, first + static_cast<std::ptrdiff_t>(band.count));
      out.push_back(packed_frf(measured, made.empty() ? nullptr : &made[o].value, lines));
    }
    return out;
  };
  // The bytes per line depend on the noise: a first packing measures them.
  std::size_t limit =
      std::clamp(kMaxBytesOfAll / 4 / std::max<std::size_t>(set.channels.size(), 1), kMinLines, kMaxLines);
  std::vector<std::size_t> lines = drawn_lines(band, modes, peaks, limit);
  std::vector<std::string> bits = packed(lines);
  std::size_t bytes = 0;
  for (const std::string& frf : bits) bytes += frf.size();
  if (bytes > kMaxBytesOfAll && lines.size() > kMinLines) {
    limit = std::max(kMinLines, lines.size() * kMaxBytesOfAll / bytes);
    lines = drawn_lines(band, modes, peaks, limit);
    bits = packed(lines);
  }
  Json json{{"first_hz", band.freq_Hz(0)},
            {"df_hz", band.df_Hz()},
            {"count", lines.size()},
            {"of", band.count},
            {"lines", packed_lines(lines)},
            {"channels", Json::array()},
            {"points", names_json(analysis.point_names(), points)},
            {"frfs", Json::array()},
            {"peaks", Json::array()}};
  for (const acquire::SignalInfo& signal : analysis.record().accel) json["channels"].push_back(channel_title(signal));
  if (survey != nullptr) json["places"] = places_json(*survey, points);
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    Json frf{{"point", set.channels[o].point}, {"channel", set.channels[o].channel}};
    if (!made.empty()) frf["frac"] = std::round(made[o].frac * 1e6) / 1e6;
    frf["bits"] = std::move(bits[o]);
    json["frfs"].push_back(std::move(frf));
  }
  for (const identify::UnmodelledPeak& peak : peaks)
    json["peaks"].push_back({{"hz", peak.freq_Hz}, {"db", std::round(peak.level_dB * 10) / 10}});
  return json;
}

Json indicator_plot_json(const pipeline::Analysis& analysis, const Eigen::MatrixXd& cmif) {
  constexpr Eigen::Index kMaxValues = 3;
  constexpr double kLevelStep_dB = 0.01, kIndicatorStep = 1e-3;
  const acquire::LineRange band = analysis.band_lines();
  Json json{{"first_hz", band.freq_Hz(0)}, {"df_hz", band.df_Hz()}, {"values", Json::array()}};
  for (Eigen::Index i = 0; i < std::min(kMaxValues, cmif.cols()); ++i) {
    std::vector<double> level_dB;
    for (const double value : cmif.col(i)) level_dB.push_back(20 * std::log10(std::max(value, 1e-300)));
    json["values"].push_back(quantised_json(level_dB, kLevelStep_dB));
  }
  json["mif"] = quantised_json(identify::mif(analysis.fitted_frfs(), band), kIndicatorStep);
  return json;
}

}  // namespace percuss::report
