#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

inline constexpr std::string_view kCalibrationChunk = "CAL1";

/// The content of a sound file's chunk CAL1, for which the format has no place (docs/reference/formats.md).
struct SoundCalibration {
  struct Signal {
    std::string name;
    Quantity measures = Quantity::acceleration;
    double to_SI = 1;  // N or m/s² at full scale
    std::optional<double> angle_rad, position_m;
  };
  double fs_Hz = 0;
  std::vector<Signal> signals;  // [channels]
  std::vector<RowInfo> rows;    // end to end
  bool continuous = false;
  std::vector<std::vector<double>> geometry;  // rows of NaN where not known
  std::vector<TraceLine> trace_lines;
};

/// Whether the points are numbered densely enough. Otherwise geometry and lines are not written.
bool calibration_holds_geometry(const std::vector<std::vector<double>>& geometry);

/// JSON text. Equal calibrations give equal texts, every number is kept exactly.
std::string calibration_text(const SoundCalibration& calibration);
/// errors  InputError at `where`: invalid text.
SoundCalibration parse_calibration(std::string_view text, const std::string& where);

}  // namespace percuss::acquire
