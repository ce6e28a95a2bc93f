#include "report/svg/analysis_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/svg/analysis_curves.hpp"
#include "report/svg/barrel_cross_section.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/analysis_tables.hpp"

namespace percuss::report {
namespace {

constexpr double kTurn_deg = 360, kJump_deg = 300;
constexpr double kMinAmplitude = 0.01;  // of a curve, as a lower limit where the ± band reaches zero
const ChartAxis kFrequency{.label = "frequency, Hz"};

std::vector<ChartAnnotation> mode_flags(const std::vector<identify::Mode>& modes,
                                        const std::vector<identify::ModeClassification>& classifications) {
  std::vector<ChartAnnotation> flags;
  for (std::size_t m = 0; m < classifications.size(); ++m)
    flags.push_back({.x = modes[m].pole.freq_Hz, .name = mode_name(classifications[m], m)});
  return flags;
}

// One standard deviation up and down, symmetric in amplitude, not in decibels.
ChartBand band_of(const FrfCurve& curve, const std::vector<double>& x, std::size_t style) {
  ChartBand band{.x = x, .low = curve.level_dB, .high = curve.level_dB, .style = style};
  for (std::size_t k = 0; k < x.size(); ++k) {
    band.high[k] += curve.above_dB[k];
    band.low[k] += 20 * std::log10(std::max(kMinAmplitude, 2 - std::pow(10, curve.above_dB[k] / 20)));
  }
  return band;
}

LineChart magnitude_chart(const pipeline::Analysis& analysis, const std::vector<FrfCurve>& frfs,
                          const std::vector<identify::Mode>& modes,
                          const std::vector<identify::ModeClassification>& classifications) {
  LineChart chart{.title = "Frequency responses", .x = kFrequency, .y = {.label = "dB re 1 (m/s²)/N"}};
  const std::vector<double> x = acquire::frequencies_Hz(analysis.lines());
  for (std::size_t i = 0; i < frfs.size(); ++i) {
    chart.curves.push_back({.name = frfs[i].name, .x = x, .y = frfs[i].level_dB, .style = i});
    if (!frfs[i].above_dB.empty()) chart.bands.push_back(band_of(frfs[i], x, i));
  }
  for (const FrfCurve& frf : frfs) {
    if (!frf.fit_dB.empty()) chart.curves.push_back({.x = x, .y = frf.fit_dB, .thin = true});
  }
  chart.flags = mode_flags(modes, classifications);
  return chart;
}

// The curve is interrupted where the phase wraps.
std::vector<double> interrupted_at_wraps(std::vector<double> phase_deg) {
  const std::vector<double> given = phase_deg;
  for (std::size_t k = 1; k < given.size(); ++k) {
    if (std::abs(given[k] - given[k - 1]) > kJump_deg) phase_deg[k] = std::numeric_limits<double>::quiet_NaN();
  }
  return phase_deg;
}

LineChart phase_chart(const pipeline::Analysis& analysis, const std::vector<FrfCurve>& frfs) {
  LineChart chart{.title = "Phase",
                  .x = kFrequency,
                  .y = {.label = "degrees",
                        .range = std::pair(-0.53 * kTurn_deg, 0.53 * kTurn_deg),
                        .ticks = {-180, -90, 0, 90, 180}}};
  const std::vector<double> x = acquire::frequencies_Hz(analysis.lines());
  for (std::size_t i = 0; i < frfs.size(); ++i)
    chart.curves.push_back({.name = frfs[i].name, .x = x, .y = interrupted_at_wraps(frfs[i].phase_deg), .style = i});
  return chart;
}

LineChart coherence_chart(const pipeline::Analysis& analysis, const std::vector<FrfCurve>& frfs) {
  LineChart chart{.title = "Coherence", .x = kFrequency, .y = {.label = "coherence", .range = std::pair(0.0, 1.02)}};
  const std::vector<double> x = acquire::frequencies_Hz(analysis.lines());
  for (std::size_t i = 0; i < frfs.size(); ++i) {
    if (!frfs[i].coherence.empty())
      chart.curves.push_back({.name = frfs[i].name, .x = x, .y = frfs[i].coherence, .style = i});
  }
  return chart;
}

ChartCurve curve_of_hit(const HitCurves& hit, const HitSamples& samples, double unit, std::size_t style) {
  ChartCurve curve{.name = fmt::format("hit {}{}", hit.index + 1, hit.accepted ? "" : ", rejected"), .style = style};
  for (std::size_t i = 0; i < samples.value.size(); ++i) {
    curve.x.push_back((samples.first + static_cast<double>(i) * samples.step) * unit);
    curve.y.push_back(samples.value[i]);
  }
  return curve;
}

LineChart hits_chart(const std::vector<HitCurves>& hits, HitSamples HitCurves::*what, double unit, LineChart chart) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!(hits[i].*what).value.empty()) chart.curves.push_back(curve_of_hit(hits[i], hits[i].*what, unit, i));
  }
  return chart;
}

// Drawn at the highest order of the diagram, because the sections that show these poles have model orders of their own.
ChartCurve unmodelled_poles(const pipeline::Analysis& analysis) {
  ChartCurve curve{
      .name = "stable in a part of the band, no mode", .line = false, .mark = ChartMark::triangle, .style = 4};
  std::size_t top = 0;
  for (const identify::StabilisationPole& pole : analysis.stabilisation().poles) top = std::max(top, pole.order);
  for (const identify::Pole& pole : analysis.unmodelled_poles()) {
    curve.x.push_back(pole.freq_Hz);
    curve.y.push_back(static_cast<double>(top));
  }
  return curve;
}

LineChart stabilisation_chart(const pipeline::Analysis& analysis, const std::vector<identify::Mode>& modes,
                              const std::vector<identify::ModeClassification>& classifications) {
  LineChart chart{.title = "Stabilisation", .x = kFrequency, .y = {.label = "model order"}};
  struct Kind {
    identify::Stability stability;
    const char* name;
    ChartMark mark;
    std::size_t style;
  };
  constexpr std::array<Kind, 4> kKinds{{{identify::Stability::fresh, "new", ChartMark::circle, 3},
                                        {identify::Stability::frequency, "stable frequency", ChartMark::plus, 1},
                                        {identify::Stability::damping, "stable damping", ChartMark::cross, 2},
                                        {identify::Stability::stable, "stable", ChartMark::diamond, 0}}};
  for (const Kind& kind : kKinds) {
    ChartCurve curve{.name = kind.name, .line = false, .mark = kind.mark, .style = kind.style};
    for (const identify::StabilisationPole& pole : analysis.stabilisation().poles) {
      if (pole.stability != kind.stability) continue;
      curve.x.push_back(pole.pole.freq_Hz);
      curve.y.push_back(static_cast<double>(pole.order));
    }
    if (!curve.x.empty()) chart.curves.push_back(std::move(curve));
  }
  if (ChartCurve poles = unmodelled_poles(analysis); !poles.x.empty()) chart.curves.push_back(std::move(poles));
  chart.flags = mode_flags(modes, classifications);
  return chart;
}

}  // namespace

const std::vector<std::string>& analysis_chart_names() {
  static const std::vector<std::string> names{"magnitude", "phase", "coherence",     "force",   "response",
                                              "spectrum",  "decay", "stabilisation", "movement"};
  return names;
}

std::vector<SvgFragment> analysis_charts(const pipeline::Analysis& analysis,
                                         const std::vector<identify::ModeClassification>& classifications,
                                         const std::vector<std::string>& names,
                                         const std::vector<identify::Mode>* modes) {
  const auto wants = [&](std::initializer_list<const char*> any) {
    return std::any_of(any.begin(), any.end(),
                       [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); });
  };
  const bool possible = analysis.possible(), with_hits = analysis.given_frfs() == nullptr;
  const auto frfs =
      possible && wants({"magnitude", "phase", "coherence"}) ? frf_curves(analysis) : std::vector<FrfCurve>();
  const auto hits =
      with_hits && wants({"force", "response", "spectrum", "decay"}) ? hit_curves(analysis) : std::vector<HitCurves>();
  static const std::vector<identify::Mode> kNone;
  const std::vector<identify::Mode>& listed = modes != nullptr          ? *modes
                                              : classifications.empty() ? kNone
                                                                        : analysis.modes();
  std::vector<LineChart> charts;
  if (!frfs.empty() && wants({"magnitude"})) charts.push_back(magnitude_chart(analysis, frfs, listed, classifications));
  if (!frfs.empty() && wants({"phase"})) charts.push_back(phase_chart(analysis, frfs));
  if (!frfs.empty() && wants({"coherence"})) charts.push_back(coherence_chart(analysis, frfs));
  if (wants({"force"})) {
    charts.push_back(
        hits_chart(hits, &HitCurves::force_N, 1e3,
                   {.title = "Force", .x = {.label = "time after the onset, ms"}, .y = {.label = "force, N"}}));
  }
  if (wants({"response"})) {
    charts.push_back(hits_chart(hits, &HitCurves::response_mps2, 1e3,
                                {.title = "Response to the pulse",
                                 .x = {.label = "time after the onset, ms"},
                                 .y = {.label = "first accelerometer, m/s²"}}));
  }
  if (wants({"spectrum"})) {
    charts.push_back(
        hits_chart(hits, &HitCurves::spectrum_dB, 1,
                   {.title = "Spectrum of the force", .x = kFrequency, .y = {.label = "dB re the largest line"}}));
    if (possible) {
      const auto [low_Hz, high_Hz] = analysis.band_Hz();
      charts.back().flags = {{.x = low_Hz, .name = "band's start"}, {.x = high_Hz, .name = "band's end"}};
    }
  }
  if (wants({"decay"})) {
    charts.push_back(hits_chart(hits, &HitCurves::decay_dB, 1,
                                {.title = "Decay of the response",
                                 .x = {.label = "time after the force's peak, s"},
                                 .y = {.label = "dB re the largest level"}}));
  }
  if (wants({"stabilisation"}) && possible) charts.push_back(stabilisation_chart(analysis, listed, classifications));
  std::vector<SvgFragment> pieces;
  for (const LineChart& chart : charts) {
    if (!chart.curves.empty()) pieces.push_back(line_chart_fragment(chart));
  }
  if (wants({"movement"}) && possible) {
    const auto barrels = barrel_cross_sections(analysis, listed, classifications);
    if (!barrels.empty()) pieces.push_back(shape_svg("Cross-section of the barrel", barrels));
  }
  return pieces;
}

}  // namespace percuss::report
