#include "pipeline/warnings/hit_scatter_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/io/significant_digits.hpp"
#include "core/math/significance.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxNamedModes = 4;
constexpr double kMuchScatter = 3;   // hits' part over the noise's part, from which unexplained scatter is reported
constexpr double kMaxChance = 1e-3;  // probability of the unexplained scatter if the hits do not differ
constexpr double kMuchMisfit = 5;    // misfit's part over the noise's
constexpr double kPpm = 1e6;

using identify::Mode;

// Lists the modes whose `rank` is positive, largest first, each with the text of `value`.
std::string named_modes(const std::vector<Mode>& modes, const std::function<double(const Mode&)>& rank,
                        const std::function<std::string(const Mode&)>& value) {
  std::vector<const Mode*> found;
  for (const Mode& mode : modes) {
    if (rank(mode) > 0) found.push_back(&mode);
  }
  std::stable_sort(found.begin(), found.end(), [&](const Mode* a, const Mode* b) { return rank(*a) > rank(*b); });
  std::string list;
  for (std::size_t i = 0; i < std::min(found.size(), kMaxNamedModes); ++i)
    list += fmt::format("{}{:.6g} Hz {}", i == 0 ? "" : "; ", found[i]->pole.freq_Hz, value(*found[i]));
  if (found.size() > kMaxNamedModes) list += fmt::format("; and {} more modes", found.size() - kMaxNamedModes);
  return list;
}

// "38 ± 4": both with the decimals of the first digit of the ±, without an exponent.
std::string percent_with_std(double value, double std) {
  const int decimals = std > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(std))), 0, 6) : 0;
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, std, decimals);
}

// The step of force in which a slope is stated: 100 N, 10 N, … The change per step is 50 % at most, because no value
// can fall by more than 100 %.
double stated_step_N(double percent_per_N) {
  constexpr double kMaxStep_N = 100, kMinStep_N = 1e-3, kMaxPercent = 50;
  double step_N = kMaxStep_N;
  while (step_N > kMinStep_N && step_N * percent_per_N > kMaxPercent) step_N /= 10;
  return step_N;
}

std::string amplitude_text(const Mode& mode) {
  const identify::AmplitudeTrend& trend = *mode.amplitude;
  std::string text;
  if (trend.freq_follows) {
    text +=
        fmt::format("{} by {} Hz/N ({}; {:.6g} Hz at zero force)", trend.freq_slope_Hz_per_N < 0 ? "falls" : "rises",
                    value_with_std(std::abs(trend.freq_slope_Hz_per_N), trend.freq_slope_std),
                    trend.freq_slope_Hz_per_N < 0 ? "softening" : "hardening", trend.freq_at_zero_Hz);
  }
  if (trend.damping_follows) {
    const bool falls = trend.damping_slope_per_N < 0;
    const double slope_percent_per_N = 100 * std::abs(trend.damping_slope_per_N) / mode.pole.damping_ratio;
    const double std_percent_per_N = 100 * trend.damping_slope_std / mode.pole.damping_ratio;
    const double step_N = stated_step_N(slope_percent_per_N);
    text += fmt::format("{}damping {} by {} % of itself per {:g} N ({})", text.empty() ? "" : ", ",
                        falls ? "falls" : "rises",
                        percent_with_std(step_N * slope_percent_per_N, step_N * std_percent_per_N), step_N,
                        falls ? "as dry friction does" : "as air or a loose joint does");
  }
  return text;
}

double amplitude_rank(const Mode& mode) {
  if (!mode.amplitude) return 0;
  return mode.hit_scatter_Hz / mode.pole.half_power_Hz() + mode.hit_scatter_damping / mode.pole.damping_ratio + 1e-12;
}

// The scatter of a mode between the hits, relative to its values. 0 where it is not significant, or not so large that
// it determines the ±.
struct RelativeScatter {
  double freq = 0, damping = 0;
};

RelativeScatter own_scatter(const Mode& mode) {
  return {.freq = mode.hit_scatter_freq_p < 1 ? mode.hit_scatter_Hz / mode.pole.freq_Hz : 0,
          .damping = mode.hit_scatter_damping_p < 1 ? mode.hit_scatter_damping / mode.pole.damping_ratio : 0};
}

// The scatter that a mode takes from the other modes (identify::shared_scatter), where it determines the ±.
RelativeScatter scatter_of_others(const Mode& mode) {
  const bool freq = mode.hit_scatter_freq_p == 1 && mode.freq_std_parts_Hz.hits > mode.freq_std_parts_Hz.noise;
  const bool damping = mode.hit_scatter_damping_p == 1 && mode.damping_std_parts.hits > mode.damping_std_parts.noise;
  return {.freq = freq ? mode.hit_scatter_Hz / mode.pole.freq_Hz : 0,
          .damping = damping ? mode.hit_scatter_damping / mode.pole.damping_ratio : 0};
}

std::string scatter_text(const RelativeScatter& scatter) {
  std::string text;
  if (scatter.freq > 0) text = fmt::format("frequency by {} ppm", significant(kPpm * scatter.freq, 2));
  if (scatter.damping > 0)
    text += fmt::format("{}damping by {:.2g} %", text.empty() ? "" : ", ", 100 * scatter.damping);
  return "(" + text + ")";
}

double unexplained_rank(const Mode& mode) {
  if (mode.amplitude || mode.drift) return 0;
  const RelativeScatter own = own_scatter(mode);
  const double freq = mode.freq_std_parts_Hz.hits > kMuchScatter * mode.freq_std_parts_Hz.noise ? own.freq : 0;
  const bool damping = mode.damping_std_parts.hits > kMuchScatter * mode.damping_std_parts.noise;
  return freq + (damping ? own.damping * mode.pole.damping_ratio : 0);
}

// A sentence about the modes whose ± includes the scatter of the others; empty where there are none.
std::string others_sentence(const std::vector<Mode>& modes) {
  const auto rank = [](const Mode& mode) {
    const RelativeScatter of_others = scatter_of_others(mode);
    return of_others.freq + of_others.damping;
  };
  const std::string list =
      named_modes(modes, rank, [](const Mode& mode) { return scatter_text(scatter_of_others(mode)); });
  return list.empty() ? list : ". Modes too weak to show such a scatter are assumed to have it as well: " + list;
}

// The probability that noise alone makes the hits differ as much, in as many modes without a trend. Each mode has two
// values (frequency and damping), and of many values some exceed the limit of a single value by chance.
double chance_of_scatter(const std::vector<Mode>& modes) {
  std::vector<double> p_values;
  for (const Mode& mode : modes) {
    if (mode.amplitude || mode.drift) continue;
    if (mode.freq_std_parts_Hz.hits > 0) p_values.push_back(mode.hit_scatter_freq_p);
    if (mode.damping_std_parts.hits > 0) p_values.push_back(mode.hit_scatter_damping_p);
  }
  std::sort(p_values.begin(), p_values.end());
  double least = 1;
  for (std::size_t k = 0; k < p_values.size(); ++k)
    least = std::min(least, chance_of_count(k + 1, 2 * modes.size(), p_values[k]));
  return least;
}

Warning misfit_warning(const std::string& list, const Mode& first, std::optional<double> residual_end_Hz,
                       bool force_known) {
  std::string text =
      "the residual of the fit has structure that the fitted modes do not explain, and determines the ± of: " + list;
  const std::string causes =
      std::string(force_known ? "" : "the noise of the force, if it had no force window, ") +
      "frequency or damping that changes during the decay (with the amplitude or with time), a weak mode beside a "
      "strong one, two modes too close to separate (those of the two planes of a tube, for example), a sensor's or "
      "filter's own response";
  if (!residual_end_Hz) {
    return with_remedy(
        {"model_misfit", text + ". Possible causes: " + causes + ", a mode just beyond the band", {"band"}},
        "compare softer and stronger hits, extend the band, and look at the fit around these modes");
  }
  text += fmt::format(
      ". The residual grows towards the end of the fitted lines at {:.4g} Hz, as the tail of a mode just beyond it "
      "does. "
      "Other possible causes: {}",
      *residual_end_Hz, causes);
  const char* const side = *residual_end_Hz > first.pole.freq_Hz ? "above" : "below";
  return with_remedy(
      {"model_misfit", std::move(text), {"band"}},
      fmt::format("extend the band to {} {:.4g} Hz; if that changes nothing, compare softer and stronger "
                  "hits",
                  side, *residual_end_Hz));
}

std::string drift_per_hit(const identify::DriftTrend& drift) {
  return fmt::format("by {} ppm per hit", value_with_std(kPpm * std::abs(drift.freq_change_per_hit), kPpm * drift.std));
}

// The drifts of the modes; empty where there are none. identify::describe_common_drift() gives all modes the same one.
std::string drift_text(const std::vector<Mode>& modes) {
  const auto falls = [](const Mode& mode) { return mode.drift->freq_change_per_hit < 0; };
  const bool common = modes.size() > 1 && std::all_of(modes.begin(), modes.end(), [&](const Mode& mode) {
                        return mode.drift && modes.front().drift &&
                               mode.drift->freq_change_per_hit == modes.front().drift->freq_change_per_hit;
                      });
  if (common) {
    return fmt::format(
        "all {} {}. The values are those of the middle of the test. The drift has been taken out of shapes and damping "
        "ratios, and the ± of a frequency includes it",
        falls(modes.front()) ? "fall" : "rise", drift_per_hit(*modes.front().drift));
  }
  const std::string drift = named_modes(
      modes, [](const Mode& mode) { return mode.drift ? std::abs(mode.drift->freq_change_per_hit) : 0; },
      [&](const Mode& mode) {
        return fmt::format("{} {}", falls(mode) ? "falls" : "rises", drift_per_hit(*mode.drift));
      });
  return drift.empty() ? drift : drift + ". Each value is a mean over the hits, and its ± includes the drift";
}

}  // namespace

double much_misfit(const Mode& mode) {
  const auto over = [](const identify::StdParts& parts) {
    return parts.noise > 0 && parts.misfit > kMuchMisfit * parts.noise ? parts.misfit / parts.noise : 0.0;
  };
  return std::max(over(mode.freq_std_parts_Hz), over(mode.damping_std_parts));
}

std::vector<Warning> hit_scatter_warnings(const std::vector<Mode>& modes, std::optional<double> residual_end_Hz,
                                          bool force_known) {
  std::vector<Warning> out;
  const std::string amplitude = named_modes(modes, amplitude_rank, amplitude_text), drift = drift_text(modes);
  std::string unexplained =
      named_modes(modes, unexplained_rank, [](const Mode& mode) { return scatter_text(own_scatter(mode)); });
  if (!(chance_of_scatter(modes) < kMaxChance)) unexplained.clear();
  // Said once, in the last of the three warnings.
  const std::string others = others_sentence(modes);
  const bool of_drift = unexplained.empty(), of_amplitude = of_drift && drift.empty();
  if (!amplitude.empty()) {
    out.push_back(with_remedy({"nonlinear", "nonlinear: these modes depend on the strength of the hits: " + amplitude +
                                                ". Each value is a mean over the hits, and its ± includes their "
                                                "scatter" +
                                                (of_amplitude ? others : "")},
                              "quote the force with each value, or hit with equal strength"));
  }
  if (!drift.empty()) {
    out.push_back(with_remedy(
        {"drifting", "frequencies drift from hit to hit, in the order of the test: " + drift +
                         (of_drift ? others : "") + ". Possible causes: temperature, a support that settles, damage"},
        "wait until temperature and support are steady, and repeat the test"));
  }
  if (!unexplained.empty()) {
    out.push_back(with_remedy({"hits_differ",
                               "modes change from hit to hit by more than the noise explains, and neither the force "
                               "nor the order of the hits explains it: " +
                                   unexplained + others +
                                   ". Each ± includes this scatter. Possible causes: the point or the direction of "
                                   "the hits, a second contact of the hammer, a loose sensor or support"},
                              "fasten sensors and support, and strike one point in one direction"));
  }
  const std::string misfit = named_modes(
      modes, much_misfit, [](const Mode& mode) { return fmt::format("({:.2g} times the noise)", much_misfit(mode)); });
  if (!misfit.empty()) out.push_back(misfit_warning(misfit, modes.front(), residual_end_Hz, force_known));
  return out;
}

}  // namespace percuss::pipeline
