#include "pipeline/warnings/three_wave_warnings.hpp"

#include <fmt/format.h>

#include <string>

#include "core/io/counted_words.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxThreeWaves = 4;  // modes that the message names

}  // namespace

std::vector<Warning> three_wave_warnings(const std::vector<identify::Mode>& modes,
                                         const std::vector<identify::ModeClassification>& classifications) {
  std::vector<std::string> named;
  for (std::size_t m = 0; m < classifications.size(); ++m) {
    if (classifications[m].possible_three_waves)
      named.push_back(fmt::format("mode {} ({:.5g} Hz)", m + 1, modes[m].pole.freq_Hz));
  }
  if (named.empty()) return {};
  return {with_remedy(
      {"three_waves", fmt::format("{} may have three waves around the barrel (n = 3): above twice the lowest hoop "
                                  "frequency, two sensors cannot tell this from bending, and the bending orders below "
                                  "do not decide it",
                                  limited_list(named.size(), kMaxThreeWaves, [&](std::size_t i) { return named[i]; }))},
      "strike a ring of points around the barrel, as a survey with angles")};
}

}  // namespace percuss::pipeline
