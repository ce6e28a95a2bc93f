#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

inline constexpr std::string_view kCalibrationChunk = "CAL1";

/// The content of the chunk CAL1: data that sound formats have no field for (docs/reference/formats.md).
struct SoundCalibration {
  struct Signal {
    std::string name;
    Quantity measures = Quantity::acceleration;
    double to_SI = 1;  // N, m/s² or Pa at full scale
    std::optional<double> angle_rad, position_m;
  };
  double fs_Hz = 0;
  std::vector<Signal> signals;  // [channels]
  std::vector<RowInfo> rows;    // end to end
  bool continuous = false;
  std::vector<std::vector<double>> geometry;  // [points][2 or 3]; NaN for points without coordinates
  std::vector<TraceLine> trace_lines;
};

/// Whether the points are numbered densely enough for the chunk. Otherwise geometry and trace lines are not written.
bool calibration_holds_geometry(const std::vector<std::vector<double>>& geometry);

/// The content as JSON text. Equal calibrations give equal texts, and every number is exact.
std::string calibration_text(const SoundCalibration& calibration);
/// errors  InputError at `where`: invalid text.
SoundCalibration parse_calibration(std::string_view text, const std::string& where);

}  // namespace percuss::acquire
