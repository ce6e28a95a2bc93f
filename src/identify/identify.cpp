#include "identify/identify.hpp"

#include "identify/many_outputs.hpp"
#include "identify/peak_fit.hpp"
#include "identify/refine.hpp"

namespace percuss {

const char* name_of(Effort effort) {
  switch (effort) {
    case Effort::quick:
      return "quick";
    case Effort::standard:
      return "standard";
    case Effort::best:
      return "best";
  }
  return "";
}

std::vector<Mode> identify_modes(const FrfSet& set, const IdentifyOptions& options) {
  if (options.start_Hz.empty() && set.outputs.size() > kFewOutputs) {
    if (auto modes = identify_many(set, options)) return *std::move(modes);
  }
  const int rounds = options.effort == Effort::quick ? kFewRounds : kThorough;
  auto found = fit_peaks(set, {.rounds = rounds, .modes = options.modes, .start_Hz = options.start_Hz});
  if (options.effort == Effort::best && !found.empty()) refine(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (PeakMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

}  // namespace percuss
