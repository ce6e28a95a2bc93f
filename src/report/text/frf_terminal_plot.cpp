#include "report/text/frf_terminal_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kRows = 8, kMaxColumns = 100, kMinColumns = 40, kLabelColumns = 8;
constexpr std::size_t kDotsDown = 4, kDotsAcross = 2;  // of a braille character
constexpr double kRange_dB = 80;                       // lower levels are antiresonances or noise

// Levels over the band, one per column of dots: the highest level of all FRFs in the column.
std::vector<double> levels_dB(const pipeline::Analysis& analysis, std::size_t columns) {
  std::vector<double> highest(columns, -std::numeric_limits<double>::infinity());
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    for (std::size_t k = 0; k < frf.frf.value.size(); ++k) {
      const double part = (analysis.lines().freq_Hz(k) - low_Hz) / (high_Hz - low_Hz);
      if (!(part >= 0 && part < 1)) continue;
      double& at = highest[static_cast<std::size_t>(part * static_cast<double>(columns))];
      at = std::max(at, 20 * std::log10(std::abs(frf.frf.value[k])));
    }
  }
  for (std::size_t i = 1; i < columns; ++i) {  // fewer spectral lines than columns
    if (std::isinf(highest[i])) highest[i] = highest[i - 1];
  }
  return highest;
}

std::string braille(unsigned dots) {
  return {static_cast<char>(0xE2), static_cast<char>(0xA0U + (dots >> 6U)), static_cast<char>(0x80U + (dots & 0x3FU))};
}

// The dots of a curve through the levels, [row][column] as bits of braille characters.
class Dots {
 public:
  explicit Dots(std::size_t columns) : columns_(columns), bits_(kRows * columns) {}
  void set(std::size_t across, std::size_t down) {
    constexpr std::array<std::array<unsigned, 4>, 2> kBits{{{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}}};
    bits_[(down / kDotsDown) * columns_ + across / kDotsAcross] |= kBits.at(across % kDotsAcross).at(down % kDotsDown);
  }
  std::string row(std::size_t row) const {
    std::string out;
    for (std::size_t c = 0; c < columns_; ++c) out += braille(bits_[row * columns_ + c]);
    return out;
  }

 private:
  std::size_t columns_;
  std::vector<unsigned> bits_;
};

// A mode's number under its frequency, unless it overlaps the number before.
std::string numbers_below(const pipeline::Analysis& analysis, std::size_t columns) {
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  std::string out(columns, ' ');
  std::size_t free = 0;
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const double part = (analysis.modes()[m].pole.freq_Hz - low_Hz) / (high_Hz - low_Hz);
    if (!(part >= 0 && part < 1)) continue;
    const auto at = static_cast<std::size_t>(part * static_cast<double>(columns));
    const std::string number = std::to_string(m + 1);
    if (at < free || at + number.size() > columns) continue;
    out.replace(at, number.size(), number);
    free = at + number.size() + 1;
  }
  return out;
}

}  // namespace

std::string frf_terminal_plot(const pipeline::Analysis& analysis, std::size_t width) {
  if (width < kLabelColumns + kMinColumns) return "";
  const std::size_t columns = std::min(width - kLabelColumns, kMaxColumns);
  const std::vector<double> level_dB = levels_dB(analysis, kDotsAcross * columns);
  const double top = *std::max_element(level_dB.begin(), level_dB.end());
  double bottom = top;
  for (const double level : level_dB) bottom = std::min(bottom, std::max(level, top - kRange_dB));
  if (!std::isfinite(top) || !(top > bottom)) return "";
  const std::size_t lowest = kRows * kDotsDown - 1;
  const auto down = [&](double level) {
    const double part = std::clamp((top - level) / (top - bottom), 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(part * static_cast<double>(lowest)));
  };
  Dots dots(columns);
  for (std::size_t i = 0; i < level_dB.size(); ++i) {
    const std::size_t here = down(level_dB[i]), before = down(level_dB[i == 0 ? 0 : i - 1]);
    for (std::size_t y = std::min(here, before); y <= std::max(here, before); ++y) dots.set(i, y);
  }
  std::string out;
  for (std::size_t row = 0; row < kRows; ++row) {
    const std::string label = row == 0           ? fmt::format("{:.0f} dB", top)
                              : row + 1 == kRows ? fmt::format("{:.0f} dB", bottom)
                                                 : "";
    out += fmt::format("{:>{}} ", label, kLabelColumns - 1) + dots.row(row) + "\n";
  }
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  const std::string low = rounded_frequency_text(low_Hz), high = rounded_frequency_text(high_Hz);
  out += std::string(kLabelColumns, ' ') + numbers_below(analysis, columns) + "\n";
  return out + std::string(kLabelColumns, ' ') + low + std::string(columns - text_width(low) - text_width(high), ' ') +
         high + "\n";
}

}  // namespace percuss::report
