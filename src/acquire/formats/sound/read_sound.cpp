#include "acquire/formats/sound/read_sound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "acquire/channels/signal_table.hpp"
#include "acquire/channels/unit_notes.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

// Whether the user states units or scales.
bool has_scale_options(const ReadOptions& options) {
  return !options.force_scale.empty() || !options.accel_scale.empty() || options.force_sensitivity_V_per_N ||
         !options.accel_sensitivity_V_per_mps2.empty() || !options.pressure_sensitivity_V_per_Pa.empty() ||
         !options.force_unit.empty() || !options.accel_unit.empty() || !options.setup.empty();
}

bool has_sensitivities(const ReadOptions& options) {
  return options.force_sensitivity_V_per_N || !options.accel_sensitivity_V_per_mps2.empty() ||
         !options.pressure_sensitivity_V_per_Pa.empty() ||
         std::any_of(options.setup.begin(), options.setup.end(),
                     [](const ChannelSetup& channel) { return channel.sensitivity_V_per_SI.has_value(); });
}

void describe_uncalibrated(const SoundInput& sound, const ReadOptions& options, SignalTable& table) {
  table.fs_Hz = sound.rate_Hz();
  table.rows.push_back({.samples = sound.frames()});
  table.continuous = true;
  if (const auto whole = sound.frames_of_whole_file()) {
    const double fs_Hz = sound.rate_Hz();
    table.notes.emplace_back(fmt::format(
        "the file ends early: it holds {:.4g} of the {:.4g} s that its header states; copy or record it again",
        static_cast<double>(sound.frames()) / fs_Hz, static_cast<double>(*whole) / fs_Hz));
  }
  for (std::size_t c = 0; c < sound.channels(); ++c) {
    table.signals.push_back({.name = fmt::format("channel {}", c + 1)});
    // When the user names the force, the other channels are accelerations.
    if (!options.force_channel.empty()) table.signals.back().measures = Quantity::acceleration;
  }
  if (!has_scale_options(options)) {
    table.notes.push_back(full_scale_note());
  } else if (has_sensitivities(options) && (options.force_scale.empty() || options.accel_scale.empty())) {
    table.notes.emplace_back(
        "stored numbers are fractions of full scale, and full scale is taken as 1 V: if it is V volts, forces "
        "and responses must be multiplied by V; divide V by the sensitivity in V/N or V/(m/s²), and give the quotient "
        "as the scale",
        std::vector<OptionId>{"force_scale", "accel_scale"});
  }
}

// Divides the frames into the rows of the calibration, which begin at `starts`. In a truncated file the last rows are
// shorter or missing. Rows of fewer than two samples are left out.
void take_rows(const SoundCalibration& calibration, std::size_t frames, SignalTable& table,
               std::vector<std::size_t>& starts) {
  std::size_t left = frames;
  bool cut = false;
  for (RowInfo row : calibration.rows) {
    cut = cut || row.samples > left;
    row.samples = std::min(row.samples, left);
    if (row.samples >= 2) {
      starts.push_back(frames - left);
      table.rows.push_back(row);
    }
    left -= row.samples;
  }
  if (cut) {
    table.notes.emplace_back(
        fmt::format("the file ends early: {} of {} rows are present, the last one may be incomplete", table.rows.size(),
                    calibration.rows.size()));
  }
  if (calibration.rows.empty()) {
    starts.push_back(0);
    table.rows.push_back({.samples = frames});
  }
}

void describe_calibrated(const SoundInput& sound, const SoundCalibration& calibration, const std::string& where,
                         SignalTable& table, std::vector<std::size_t>& starts) {
  if (calibration.signals.size() != sound.channels()) {
    throw InputError(fmt::format("{} signals described for {} channels", calibration.signals.size(), sound.channels()),
                     where, "export the file again");
  }
  table.fs_Hz = calibration.fs_Hz > 0 ? calibration.fs_Hz : sound.rate_Hz();
  table.continuous = calibration.continuous || calibration.rows.empty();
  table.geometry = calibration.geometry;
  table.trace_lines = calibration.trace_lines;
  for (const SoundCalibration::Signal& signal : calibration.signals) {
    table.signals.push_back({.name = signal.name,
                             .unit = {},
                             .angle_rad = signal.angle_rad,
                             .position_m = signal.position_m,
                             .shape = {},
                             .measures = signal.measures,
                             .to_SI = signal.to_SI});
  }
  take_rows(calibration, sound.frames(), table, starts);
}

}  // namespace

Record open_sound(const std::string& path, const ReadOptions& options) {
  const auto sound = std::make_shared<const SoundInput>(path);
  SignalTable table;
  table.files.push_back({.path = path, .bytes = std::filesystem::file_size(path)});
  table.format = sound->format();
  const std::string where = path + ": " + std::string(kCalibrationChunk);
  std::vector<std::size_t> starts;
  if (const auto text = sound->chunk(kCalibrationChunk)) {
    describe_calibrated(*sound, parse_calibration(*text, where), where, table, starts);
  } else {
    describe_uncalibrated(*sound, options, table);
    starts.push_back(0);
  }
  table.read = [sound, starts](std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
    sound->read(signal, starts[row] + first, out);
  };
  return record_of_table(std::move(table), options);
}

}  // namespace percuss::acquire
