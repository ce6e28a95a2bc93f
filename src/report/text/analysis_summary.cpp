#include "report/text/analysis_summary.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/io/significant_digits.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

std::string list_of(const std::vector<std::string>& items) {
  std::string out;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += i + 1 == items.size() ? " and " : ", ";
    out += items[i];
  }
  return out;
}

std::vector<std::string> frequencies_of(const std::vector<identify::Mode>& modes,
                                        const std::vector<identify::ModeClassification>& classifications,
                                        identify::ModeType type) {
  std::vector<std::string> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (classifications[m].type == type) out.push_back(significant(modes[m].pole.freq_Hz, 4));
  }
  return out;
}

}  // namespace

std::string summary_sentence(const pipeline::Analysis& analysis,
                             const std::vector<identify::ModeClassification>& classifications,
                             const std::vector<identify::Mode>* modes) {
  if (!analysis.possible()) return "No hit can be used: there are no FRFs and no modes.";
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  const std::string band = fmt::format("between {} and {} Hz", hertz_text(low_Hz), hertz_text(high_Hz));
  const std::vector<identify::Mode>& listed = modes != nullptr ? *modes : analysis.modes();
  const std::size_t count = listed.size();
  if (count == 0 && !analysis.options().modes.start_Hz.empty())
    return "No mode could be fitted at the starting frequencies.";
  if (count == 0) return fmt::format("No mode rises above the noise {}.", band);
  std::vector<std::string> parts;
  for (const identify::ModeType type :
       {identify::ModeType::bending, identify::ModeType::hoop, identify::ModeType::unknown}) {
    const auto found = frequencies_of(listed, classifications, type);
    if (found.empty()) continue;
    const bool named = type != identify::ModeType::unknown || !parts.empty();
    parts.push_back(fmt::format(
        "{}{}",
        named ? fmt::format("{} at ", type == identify::ModeType::unknown ? "of unknown type" : name_of(type)) : "at ",
        list_of(found)));
  }
  return fmt::format("{} mode{} {}: {} Hz.", count, count == 1 ? "" : "s", band, fmt::join(parts, " Hz; "));
}

}  // namespace percuss::report
