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

void require_band(std::pair<double, double> band_Hz, double fs_Hz, const std::string& where) {
  constexpr double kUsualRate_Hz = 1000;
  const auto [low_Hz, high_Hz] = band_Hz;
  if (low_Hz < high_Hz && low_Hz >= 0 && high_Hz <= fs_Hz / 2) return;
  if (low_Hz < high_Hz && low_Hz >= 0 && (fs_Hz < kUsualRate_Hz || low_Hz > fs_Hz / 2)) {
    throw InputError(fmt::format("the sampling rate looks wrong: {:.6g} Hz holds nothing above {:.6g} Hz, but the band "
                                 "is {:.6g}:{:.6g} Hz",
                                 fs_Hz, fs_Hz / 2, low_Hz, high_Hz),
                     where, "state the rate, or a band below half of it", {"fs", "band"});
  }
  throw InputError(
      fmt::format("the band {:.6g}:{:.6g} Hz does not fit a sampling rate of {:.6g} Hz", low_Hz, high_Hz, fs_Hz), where,
      "choose LO:HI with LO < HI <= half the sampling rate", {"band"});
}

void require_lines(const acquire::LineRange& lines, double low_Hz, double high_Hz, const std::string& where,
                   const std::string& remedy) {
  if (lines.count >= kMinBandLines) return;
  constexpr double kUnusualRate_Hz = 1e6;
  if (lines.fs_Hz > kUnusualRate_Hz) {
    throw InputError(fmt::format("the sampling rate looks wrong: at {:.6g} Hz the record lasts {:.3g} s, too short for "
                                 "the band {:.6g}:{:.6g} Hz",
                                 lines.fs_Hz, 1 / lines.df_Hz(), low_Hz, high_Hz),
                     where, "state the rate, or record longer", {"fs"});
  }
  throw InputError(fmt::format("only {} spectral lines, {:.4g} Hz apart, lie in the band {:.6g}:{:.6g} Hz", lines.count,
                               lines.df_Hz(), low_Hz, high_Hz),
                   where, remedy, {"band"});
}

}  // namespace percuss::pipeline
