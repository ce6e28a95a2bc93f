#include "expectation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::stress {
namespace {

constexpr double kMaxDampingBound = 0.1;  // bound over damping ratio
constexpr double kMinSeparation = 10;     // distance over its bound
constexpr double kNear = 3;               // bandwidths within which a reported mode may stand for a true one

double width_Hz(const identify::Pole& pole) { return 2 * pole.damping_ratio * pole.freq_Hz; }

bool is_resolvable(const TrueMode& mode) { return mode.damping_bound <= kMaxDampingBound * mode.pole.damping_ratio; }

bool are_separable(const TrueMode& a, const TrueMode& b) {
  const double apart_Hz = std::abs(a.pole.freq_Hz - b.pole.freq_Hz);
  // The errors of a close pair are opposite. They cancel in its centre and add up in its distance.
  return apart_Hz > kRoundingOfPole * a.pole.freq_Hz && apart_Hz > kMinSeparation * (a.freq_bound_Hz + b.freq_bound_Hz);
}

ModeError mode_error_of(const identify::Mode& mode, const identify::Pole& truth) {
  const auto beyond = [](double error, double rounding, double std) {
    return std::max(0.0, std::abs(error) - rounding) / std;
  };
  return {.freq_sigmas = beyond(mode.pole.freq_Hz - truth.freq_Hz, kRoundingOfPole * truth.freq_Hz, mode.freq_std_Hz),
          .damping_sigmas = beyond(mode.pole.damping_ratio - truth.damping_ratio, kRoundingOfPole, mode.damping_std)};
}

double larger_sigmas(const ModeError& error) { return std::max(error.freq_sigmas, error.damping_sigmas); }

bool is_candidate_for(const identify::Mode& mode, const identify::Pole& truth) {
  const double off_Hz = std::abs(mode.pole.freq_Hz - truth.freq_Hz);
  return off_Hz <= std::max(kNear * width_Hz(truth), kMaxSigmas * mode.freq_std_Hz);
}

std::string text_of(const identify::Mode& mode) {
  return fmt::format("{:.9g} ± {:.2g} Hz, {:.6g} ± {:.2g}", mode.pole.freq_Hz, mode.freq_std_Hz,
                     mode.pole.damping_ratio, mode.damping_std);
}

class Judge {
 public:
  Judge(const CommandResult& outcome, const std::vector<TrueMode>& truth, const Expectation& expected)
      : outcome_(outcome), truth_(truth), expected_(expected) {}

  Result run() {
    result_.said = outcome_.said;
    if (outcome_.exit_code != 0) result_.said.insert(fmt::format("exit {}", outcome_.exit_code));
    for (std::size_t t = 0; t < truth_.size(); ++t) {
      const TrueMode& mode = truth_[t];
      const auto [first, last] = cluster(t);
      if (must_be_found(mode) && first == last) ++result_.wanted;
      result_.freq_bound = std::max(result_.freq_bound, 2 * mode.freq_bound_Hz / width_Hz(mode.pole));
    }
    if (is_accepted_refusal()) return result_;
    if (outcome_.exit_code != expected_.exit_code) {
      fail(fmt::format("exit code {}: {}", outcome_.exit_code, outcome_.message));
      return result_;
    }
    for (const std::string& code : expected_.says) {
      if (!outcome_.said.contains(code)) fail("does not say " + code);
    }
    const std::string unusable = unusable_number(outcome_.modes);
    if (!unusable.empty()) fail(unusable);
    warned_ = !expected_.warns.empty() && outcome_.said.contains(expected_.warns);
    if (unusable.empty()) judge_modes();
    return result_;
  }

 private:
  void fail(const std::string& why) { result_.failures.push_back(why); }

  bool has_reason(const std::string& reason) const {
    return !reason.empty() && (outcome_.said.contains(reason) || outcome_.message.find(reason) != std::string::npos);
  }

  // If true, the judgement is complete.
  bool is_accepted_refusal() {
    if (outcome_.exit_code == 0) return false;
    const bool other = std::any_of(expected_.or_refused.begin(), expected_.or_refused.end(),
                                   [&](const std::string& reason) { return has_reason(reason); });
    const bool either = (outcome_.exit_code == 3 || outcome_.exit_code == 4) && other;
    const bool as_expected = outcome_.exit_code == expected_.exit_code && has_reason(expected_.reason);
    return either || as_expected;
  }

  bool must_be_found(const TrueMode& mode) const {
    if (expected_.demand == Demand::as_the_bound_allows) return is_resolvable(mode);
    return expected_.demand == Demand::all;
  }

  // A mode and its inseparable neighbours.
  std::pair<std::size_t, std::size_t> cluster(std::size_t t) const {
    std::size_t first = t, last = t;
    while (first > 0 && !are_separable(truth_[first - 1], truth_[first])) --first;
    while (last + 1 < truth_.size() && !are_separable(truth_[last], truth_[last + 1])) ++last;
    return {first, last};
  }

  // One mode in place of several: within their range, and no wider than all of them together.
  bool stands_for_cluster(const identify::Mode& mode, std::size_t t) const {
    const auto [first, last] = cluster(t);
    if (first == last) return false;
    double low_Hz = std::numeric_limits<double>::infinity(), high_Hz = 0, min_damping = 1, max_damping = 0;
    for (std::size_t i = first; i <= last; ++i) {
      low_Hz = std::min(low_Hz, truth_[i].pole.freq_Hz);
      high_Hz = std::max(high_Hz, truth_[i].pole.freq_Hz);
      min_damping = std::min(min_damping, truth_[i].pole.damping_ratio);
      max_damping = std::max(max_damping, truth_[i].pole.damping_ratio);
    }
    max_damping += (high_Hz - low_Hz) / (2 * low_Hz);
    const double f = kMaxSigmas * mode.freq_std_Hz, d = kMaxSigmas * mode.damping_std;
    return mode.pole.freq_Hz >= low_Hz - f && mode.pole.freq_Hz <= high_Hz + f &&
           mode.pole.damping_ratio >= min_damping - d && mode.pole.damping_ratio <= max_damping + d;
  }

  void match() {
    struct Pair {
      double off;
      std::size_t mode, truth;
    };
    std::vector<Pair> pairs;
    for (std::size_t m = 0; m < outcome_.modes.size(); ++m) {
      for (std::size_t t = 0; t < truth_.size(); ++t) {
        if (is_candidate_for(outcome_.modes[m], truth_[t].pole))
          pairs.push_back({larger_sigmas(mode_error_of(outcome_.modes[m], truth_[t].pole)), m, t});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.off < b.off; });
    of_mode_.assign(outcome_.modes.size(), truth_.size());
    of_truth_.assign(truth_.size(), outcome_.modes.size());
    for (const Pair& pair : pairs) {
      if (of_mode_[pair.mode] != truth_.size() || of_truth_[pair.truth] != outcome_.modes.size()) continue;
      of_mode_[pair.mode] = pair.truth;
      of_truth_[pair.truth] = pair.mode;
    }
  }

  void judge_modes() {
    match();
    std::vector<char> stood_for(truth_.size(), 0);
    for (std::size_t m = 0; m < outcome_.modes.size(); ++m) {
      const identify::Mode& mode = outcome_.modes[m];
      const std::size_t t = of_mode_[m];
      if (t == truth_.size()) {
        if (!warned_) fail("spurious mode: " + text_of(mode));
        continue;
      }
      const auto [first, last] = cluster(t);
      const bool alone = std::count_if(of_truth_.begin() + static_cast<std::ptrdiff_t>(first),
                                       of_truth_.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                       [&](std::size_t found) { return found != outcome_.modes.size(); }) == 1;
      if (alone && stands_for_cluster(mode, t)) {
        for (std::size_t i = first; i <= last; ++i) stood_for[i] = 1;
        continue;
      }
      judge_mode(mode, truth_[t].pole);
    }
    for (std::size_t t = 0; t < truth_.size(); ++t) {
      if (of_truth_[t] != outcome_.modes.size() || stood_for[t]) continue;
      if (must_be_found(truth_[t]) && !is_named(truth_[t].pole) && (!warned_ || expected_.freq_relative))
        fail(fmt::format("missed: {:.9g} Hz, {:.6g}", truth_[t].pole.freq_Hz, truth_[t].pole.damping_ratio));
    }
  }

  // Whether the warning unclaimed_peaks names a frequency near this mode. The mode may then be missing.
  bool is_named(const identify::Pole& truth) const {
    const double near_Hz = kNear * std::max(width_Hz(truth), outcome_.df_Hz);
    return std::any_of(outcome_.unexplained_Hz.begin(), outcome_.unexplained_Hz.end(),
                       [&](double freq_Hz) { return std::abs(freq_Hz - truth.freq_Hz) <= near_Hz; });
  }

  void judge_mode(const identify::Mode& mode, const identify::Pole& truth) {
    const ModeError error = mode_error_of(mode, truth);
    ++result_.found;
    result_.mode_errors.push_back(error);
    const double freq_relative = std::abs(mode.pole.freq_Hz / truth.freq_Hz - 1);
    const double damping_absolute = std::abs(mode.pole.damping_ratio - truth.damping_ratio);
    result_.freq_relative = std::max(result_.freq_relative, freq_relative);
    result_.damping_absolute = std::max(result_.damping_absolute, damping_absolute);
    const auto of_truth = fmt::format("{} for {:.9g} Hz, {:.6g}", text_of(mode), truth.freq_Hz, truth.damping_ratio);
    if (!warned_ && !(larger_sigmas(error) <= kMaxSigmas))
      fail(fmt::format("{:.1f} and {:.1f} standard deviations off: {}", error.freq_sigmas, error.damping_sigmas,
                       of_truth));
    if (expected_.freq_relative && !(freq_relative <= *expected_.freq_relative))
      fail(fmt::format("frequency off by {:.2g}: {}", freq_relative, of_truth));
    if (expected_.damping_absolute && !(damping_absolute <= *expected_.damping_absolute))
      fail(fmt::format("damping ratio off by {:.2g}: {}", damping_absolute, of_truth));
  }

  const CommandResult& outcome_;
  const std::vector<TrueMode>& truth_;
  const Expectation& expected_;
  Result result_;
  bool warned_ = false;                          // the outcome contains expected_.warns, which excuses errors
  std::vector<std::size_t> of_mode_, of_truth_;  // index of the partner; one past the last if none
};

}  // namespace

std::string text_of(const Expectation& expected) {
  if (!expected.text.empty()) return expected.text;
  if (expected.exit_code != 0) return fmt::format("exit {}: {}", expected.exit_code, expected.reason);
  std::string text = expected.demand == Demand::all                   ? "all modes, within 5σ"
                     : expected.demand == Demand::as_the_bound_allows ? "what the bound allows, within 5σ"
                                                                      : "every reported mode within 5σ";
  if (expected.freq_relative) text += fmt::format(", frequency to {:.0e}", *expected.freq_relative);
  if (expected.damping_absolute) text += fmt::format(", damping ratio to {:.0e}", *expected.damping_absolute);
  bool warns_required = false;
  for (const std::string& code : expected.says) {
    text += ", says " + code;
    if (code != expected.warns) continue;
    text += ", which excuses 5σ";
    warns_required = true;
  }
  if (!expected.warns.empty() && !warns_required) text += ", or says " + expected.warns;
  for (const std::string& reason : expected.or_refused) text += ", or refused: " + reason;
  return text;
}

std::vector<TrueMode> true_modes(const synth::Truth& truth) {
  std::vector<TrueMode> modes;
  for (std::size_t m = 0; m < truth.spec.modes.size(); ++m) {
    const synth::SynthMode& mode = truth.spec.modes[m];
    if (mode.freq_Hz < truth.spec.band_low_Hz || mode.freq_Hz > truth.spec.band_high_Hz) continue;
    bool seen = false;
    for (const auto& point : truth.residue_per_kg) {
      for (const auto& channel : point) seen = seen || channel[m] != 0;
    }
    if (!seen) continue;
    modes.push_back({.pole = {.freq_Hz = mode.freq_Hz, .damping_ratio = mode.damping_ratio}});
    if (!truth.bound) continue;
    modes.back().freq_bound_Hz = truth.bound->freq_std_Hz[m];
    modes.back().damping_bound = truth.bound->damping_ratio_std[m];
  }
  std::sort(modes.begin(), modes.end(),
            [](const TrueMode& a, const TrueMode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  return modes;
}

Result judge(const CommandResult& outcome, const std::vector<TrueMode>& truth, const Expectation& expected) {
  return Judge(outcome, truth, expected).run();
}

}  // namespace percuss::stress
