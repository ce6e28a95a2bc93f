#include "pipeline/source/band.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kMinBandFraction = 0.01;  // of the highest frequency
constexpr double kMargin = 0.15;           // of the band's width
constexpr std::size_t kMinBandLines = 16;

}  // namespace

double default_low_Hz(double highest_Hz) { return kMinBandFraction * highest_Hz; }

std::pair<double, double> band_with_margin(double low_Hz, double high_Hz) {
  const double margin = kMargin * (high_Hz - low_Hz);
  return {std::max(low_Hz - margin, 0.5 * low_Hz), high_Hz + margin};
}

void require_lines(const acquire::LineRange& lines, double low_Hz, double high_Hz, const std::string& where,
                   const std::string& remedy) {
  if (lines.count >= kMinBandLines) return;
  throw InputError(fmt::format("only {} spectral lines, {:.4g} Hz apart, lie in the band {:.6g}:{:.6g} Hz", lines.count,
                               lines.df_Hz(), low_Hz, high_Hz),
                   where, remedy, {"band"});
}

}  // namespace percuss::pipeline
