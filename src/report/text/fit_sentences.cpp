#include "report/text/fit_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

// What the fit of all modes together gave.
enum class JointOutcome { taken, worse, unsettled };

JointOutcome joint_fit_of(const std::vector<identify::Mode>& modes) {
  const auto all = [&](const auto& which) { return !modes.empty() && std::all_of(modes.begin(), modes.end(), which); };
  if (all([](const identify::Mode& mode) { return std::isinf(mode.joint_misfit); })) return JointOutcome::unsettled;
  return all([](const identify::Mode& mode) { return mode.joint_misfit > 0; }) ? JointOutcome::worse
                                                                               : JointOutcome::taken;
}

// Which modes the fit of all modes together does not describe.
void add_exceptions(const std::vector<identify::Mode>& modes, std::vector<std::string>& out) {
  const auto count = [&](const auto& which) {
    return static_cast<std::size_t>(std::count_if(modes.begin(), modes.end(), which));
  };
  const std::size_t local = count([](const identify::Mode& mode) { return mode.joint_misfit > 0; });
  const std::size_t moving = count([](const identify::Mode& mode) { return mode.freq_scatter_Hz > 0; });
  if (local > 0 && local < modes.size()) {
    out.push_back(
        fmt::format("However, {} of {} keep{} the fit over {} own spectral lines ((4.2), (4.14)), which leaves less "
                    "residual than the joint fit.",
                    local, counted(modes.size(), "mode"), local == 1 ? "s" : "", local == 1 ? "its" : "their"));
  }
  if (moving > 0) {
    out.push_back(
        fmt::format("{} of {} {} fitted at each point alone, because the frequency differs from point to "
                    "point; the means over the points are stated (4.15).",
                    moving, counted(modes.size(), "mode"), moving == 1 ? "was" : "were"));
  }
}

// The parts of the ± that any mode has.
std::string std_sentence(const std::vector<identify::Mode>& modes) {
  const auto any = [&](const auto& has) { return std::any_of(modes.begin(), modes.end(), has); };
  std::vector<std::string> parts{"the noise (4.12)"};
  if (any([](const auto& m) { return m.freq_std_parts_Hz.hits > 0 || m.damping_std_parts.hits > 0; }))
    parts.emplace_back("the scatter between the hits (4.19)");
  if (any([](const auto& m) { return m.freq_scatter_Hz > 0; }))
    parts.emplace_back("the scatter between the points (4.15)");
  if (any([](const auto& m) { return m.freq_std_parts_Hz.misfit > 0 || m.damping_std_parts.misfit > 0; }))
    parts.emplace_back("the misfit of the model (4.20)");
  std::string list;
  for (std::size_t i = 0; i < parts.size(); ++i)
    list += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + parts[i];
  return fmt::format("Each ± is one standard deviation, from {}{}.", list,
                     parts.size() == 1 ? " alone" : ", where a mode shows them");
}

}  // namespace

const char* effort_sentence(identify::Effort effort, const std::vector<identify::Mode>& modes) {
  const JointOutcome joint = joint_fit_of(modes);
  if (effort == identify::Effort::best && joint == JointOutcome::worse) {
    return "A fit of all modes together to all lines of all FRFs was tried (effort best; (4.8) to (4.10)). Around each "
           "mode, it leaves more residual than a fit over the mode's own spectral lines ((4.2), (4.14)): all "
           "modes keep these fits.";
  }
  if (effort == identify::Effort::best && joint == JointOutcome::unsettled) {
    return "A fit of all modes together to all lines of all FRFs was tried (effort best; (4.8) to (4.10)) and did not "
           "converge: all modes keep the fits over their own spectral lines ((4.2), (4.14)).";
  }
  switch (effort) {
    case identify::Effort::quick:
      return "Each peak was fitted over its own spectral lines (effort quick; (4.2), (4.14)).";
    case identify::Effort::standard:
      return "Modes with and without a peak were fitted over their own spectral lines (effort standard; (4.2), "
             "(4.14)).";
    case identify::Effort::best:
      return "All modes were fitted together to all lines of all FRFs by maximum likelihood (effort best; (4.8) to "
             "(4.10)).";
  }
  return "";
}

std::vector<std::string> fit_sentences(const std::vector<identify::Mode>& modes) {
  std::vector<std::string> out;
  add_exceptions(modes, out);
  if (!modes.empty()) out.push_back(std_sentence(modes));
  return out;
}

}  // namespace percuss::report
