#include "identify/started_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "identify/misfit/misfit.hpp"
#include "identify/model/close_poles.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/select/finished_modes.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kAtMode = 0.25;  // of the distance between two modes: a start nearer to one of them means that mode

std::vector<Pole> poles_of_modes(const std::vector<Mode>& modes) {
  std::vector<Pole> poles;
  poles.reserve(modes.size());
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  return poles;
}

bool ascending(const Mode& a, const Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; }

// Why a start is fitted.
enum class FitReason {
  names_none,  // it names no mode found
  beside,      // a start that names no mode lies near the mode that this start names
  between,     // it lies between two modes found and stands for one mode in their place
};
struct StartToFit {
  double asked_Hz = 0;
  FitReason why = FitReason::names_none;
};

// The starts to fit, and the modes found that are not fitted again.
struct StartsToFit {
  std::vector<StartToFit> starts;
  std::vector<Mode> kept;
};

// A pole from which a mode is fitted, and whether it comes from a joint fit.
struct FirstPole {
  Pole pole;
  bool joint = false;
};

// The FRFs without the contributions of these modes.
FrfDataset frfs_without(const FrfDataset& set, const std::vector<Mode>& modes) {
  FrfDataset rest = set;
  const std::vector<Eigen::VectorXcd> sums = modal_sums(set, modes);
  for (std::size_t o = 0; o < sums.size(); ++o) {
    for (std::size_t k = 0; k < rest.channels[o].frf.size(); ++k)
      rest.channels[o].frf[k] -= sums[o](static_cast<Index>(k));
  }
  return rest;
}

class StartedSearch {
 public:
  StartedSearch(const FrfDataset& set, std::vector<Mode> found, std::vector<double> start_Hz, Effort effort)
      : set_(set), found_(std::move(found)), start_Hz_(std::move(start_Hz)), effort_(effort) {}

  // Ends, because each pass but the last refuses a start or bars one from standing for two modes.
  StartedModes run() {
    StartedModes out;
    while (!try_starts(out.modes)) {
    }
    out.refused = std::move(refused_);
    out.joined = std::move(joined_);
    return out;
  }

 private:
  StartsToFit starts_to_fit() const {
    const std::vector<Pole> poles = poles_of_modes(found_);
    const auto named = modes_of_starts(set_.lines, found_, start_Hz_);
    std::vector<char> is_named(found_.size(), 0);
    for (const auto& mode : named) {
      if (mode) is_named[*mode] = 1;
    }
    std::vector<std::optional<FitReason>> again(found_.size());  // [modes] why a mode is fitted again
    for (std::size_t s = 0; s < start_Hz_.size(); ++s) {
      for (std::size_t m = 0; m < found_.size(); ++m) {
        const double apart_Hz = std::abs(poles[m].freq_Hz - start_Hz_[s]);
        const bool beside = apart_Hz < std::max(poles[m].half_power_Hz(), set_.lines.df_Hz());
        if (!named[s] && is_named[m] && beside) again[m] = FitReason::beside;
        if (named[s] && !is_named[m] && stands_for_both(start_Hz_[s], poles[*named[s]], poles[m]))
          again[*named[s]] = again[m] = FitReason::between;
      }
    }
    StartsToFit out;
    for (std::size_t s = 0; s < start_Hz_.size(); ++s) {
      const std::optional<FitReason> why = named[s] ? again[*named[s]] : FitReason::names_none;
      if (why) out.starts.push_back({start_Hz_[s], *why});
    }
    for (std::size_t m = 0; m < found_.size(); ++m) {
      if (!again[m]) out.kept.push_back(found_[m]);
    }
    return out;
  }

  // Whether a start that names one of two close modes lies well between them.
  bool stands_for_both(double asked_Hz, const Pole& named, const Pole& other) const {
    const double from_named_Hz = asked_Hz - named.freq_Hz, between_Hz = other.freq_Hz - named.freq_Hz;
    const bool kept_apart = std::find(apart_Hz_.begin(), apart_Hz_.end(), asked_Hz) != apart_Hz_.end();
    return !kept_apart && are_close(named, other) && from_named_Hz * between_Hz > 0 &&
           std::abs(from_named_Hz) > kAtMode * std::abs(between_Hz);
  }

  // The starts that stand for two modes found, with these modes.
  std::vector<JoinedModes> joined_modes() const {
    std::vector<JoinedModes> joined;
    const std::vector<Pole> poles = poles_of_modes(found_);
    const auto named = modes_of_starts(set_.lines, found_, start_Hz_);
    for (std::size_t s = 0; s < start_Hz_.size(); ++s) {
      for (std::size_t m = 0; named[s] && m < found_.size(); ++m) {
        const bool free = std::find(named.begin(), named.end(), std::optional(m)) == named.end();
        if (!free || !stands_for_both(start_Hz_[s], poles[*named[s]], poles[m])) continue;
        joined.push_back({start_Hz_[s], std::minmax({poles[*named[s]].freq_Hz, poles[m].freq_Hz})});
      }
    }
    return joined;
  }

  // True if no start was refused: `modes` are then complete.
  bool try_starts(std::vector<Mode>& modes) {
    const StartsToFit to_fit = starts_to_fit();
    joined_ = joined_modes();
    modes = found_;
    if (to_fit.starts.empty()) return true;
    std::vector<double> asked_Hz;
    for (const StartToFit& start : to_fit.starts) asked_Hz.push_back(start.asked_Hz);
    const FrfDataset rest = frfs_without(set_, to_fit.kept);
    FittedStarts first = fit_starts(rest, asked_Hz, effort_);
    if (!first.refused.empty()) {
      refuse(to_fit, first.refused);
      return false;
    }
    const auto fitted = fitted_together(to_fit.kept, first.modes);
    if (!fitted) {  // the modes found stay as they are, and the new ones keep their own fit
      modes = with_misfit(rest, finished_modes(rest, std::move(first.modes)));
      modes.insert(modes.end(), to_fit.kept.begin(), to_fit.kept.end());
      std::sort(modes.begin(), modes.end(), ascending);
      return true;
    }
    const std::vector<RefusedStart> refused = refused_of(asked_Hz, *fitted);
    if (!refused.empty()) {
      refuse(to_fit, refused);
      return false;
    }
    modes = with_misfit(set_, finished_modes(set_, *fitted));
    return true;
  }

  // All modes fitted together; nothing if a pole moves too far, or if a mode of a joint fit falls back to a local fit.
  std::optional<std::vector<FittedMode>> fitted_together(const std::vector<Mode>& kept,
                                                         const std::vector<FittedMode>& started) const {
    std::vector<FirstPole> first_poles;
    for (const Mode& mode : kept) first_poles.push_back({mode.pole, mode.joint_misfit == 0});
    for (const FittedMode& mode : started) first_poles.push_back({mode.mode.pole, false});
    std::sort(first_poles.begin(), first_poles.end(),
              [](const FirstPole& a, const FirstPole& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
    SequentialFitOptions options = sequential_fit_options(effort_);
    options.keep_all = true;
    for (const FirstPole& first : first_poles) options.start.push_back(first.pole);
    std::vector<FittedMode> fitted = fit_sequentially(set_, options);
    if (effort_ == Effort::best && !fitted.empty()) refine_jointly(set_, fitted);
    const auto stays = [&](const FirstPole& first, const FittedMode& mode) {
      const double moved_Hz = std::abs(mode.mode.pole.freq_Hz - first.pole.freq_Hz);
      return moved_Hz <= resolved_width_Hz(first.pole, set_.lines) && !(first.joint && mode.mode.joint_misfit > 0);
    };
    if (!std::equal(first_poles.begin(), first_poles.end(), fitted.begin(), fitted.end(), stays)) return std::nullopt;
    return fitted;
  }

  // The starts among asked_Hz whose modes in the fit of all modes are refused.
  std::vector<RefusedStart> refused_of(const std::vector<double>& asked_Hz,
                                       const std::vector<FittedMode>& fitted) const {
    std::vector<RefusedStart> refused;
    const auto named = match_starts_to_poles(set_.lines, start_Hz_, poles_of(fitted), kAnyDistance);
    for (std::size_t s = 0; s < start_Hz_.size(); ++s) {
      if (!named[s] || std::find(asked_Hz.begin(), asked_Hz.end(), start_Hz_[s]) == asked_Hz.end()) continue;
      if (auto why = refusal_of(set_.lines, start_Hz_[s], fitted[*named[s]])) refused.push_back(*why);
    }
    return refused;
  }

  // A start that names a mode is never refused. If it lies between two modes, they stay separate modes. If it is fitted
  // again because of a start near its mode, that start is refused in its stead.
  void refuse(const StartsToFit& to_fit, const std::vector<RefusedStart>& refused) {
    const auto of = [&](FitReason why) {
      std::vector<StartToFit> starts;
      std::copy_if(to_fit.starts.begin(), to_fit.starts.end(), std::back_inserter(starts),
                   [&](const StartToFit& start) { return start.why == why; });
      return starts;
    };
    const auto is_in = [](const std::vector<StartToFit>& starts, double asked_Hz) {
      return std::any_of(starts.begin(), starts.end(),
                         [&](const StartToFit& start) { return start.asked_Hz == asked_Hz; });
    };
    const std::vector<StartToFit> unnamed = of(FitReason::names_none), between = of(FitReason::between);
    bool progress = false;
    for (const RefusedStart& one : refused) {
      if (is_in(between, one.asked_Hz)) apart_Hz_.push_back(one.asked_Hz);
      if (is_in(unnamed, one.asked_Hz)) drop(one);
      progress = progress || is_in(between, one.asked_Hz) || is_in(unnamed, one.asked_Hz);
    }
    if (progress) return;
    const RefusedStart& first = refused.front();
    const auto nearest =
        std::min_element(unnamed.begin(), unnamed.end(), [&](const StartToFit& a, const StartToFit& b) {
          return std::abs(a.asked_Hz - first.asked_Hz) < std::abs(b.asked_Hz - first.asked_Hz);
        });
    drop({.asked_Hz = nearest->asked_Hz, .pole = first.pole});
  }

  void drop(const RefusedStart& one) {
    refused_.push_back(one);
    std::erase(start_Hz_, one.asked_Hz);
  }

  const FrfDataset& set_;
  std::vector<Mode> found_;
  std::vector<double> start_Hz_;
  Effort effort_;
  std::vector<double> apart_Hz_;  // starts between two modes that stay separate modes
  std::vector<RefusedStart> refused_;
  std::vector<JoinedModes> joined_;  // of the last pass
};

}  // namespace

StartedModes with_started_modes(const FrfDataset& set, std::vector<Mode> found, std::vector<double> start_Hz,
                                Effort effort) {
  return StartedSearch(set, std::move(found), std::move(start_Hz), effort).run();
}

std::vector<std::optional<std::size_t>> modes_of_starts(const acquire::LineRange& lines, const std::vector<Mode>& modes,
                                                        const std::vector<double>& start_Hz) {
  return match_starts_to_poles(lines, start_Hz, poles_of_modes(modes), kMaxBandwidthsFromStart);
}

std::vector<Mode> modes_at_starts(const acquire::LineRange& lines, const std::vector<Mode>& modes,
                                  const std::vector<double>& start_Hz) {
  std::vector<Mode> named;
  for (const auto& mode : modes_of_starts(lines, modes, start_Hz)) {
    if (mode) named.push_back(modes[*mode]);
  }
  std::sort(named.begin(), named.end(), ascending);
  return named;
}

}  // namespace percuss::identify
