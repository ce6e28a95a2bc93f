#include "acquire/formats/sound/write_sound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/record/file_format.hpp"
#include "core/error.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kBlockFrames = 16384;
constexpr double kMaxWav_bytes = 4e9;

// The force is signal 0 if the record has one. The accelerations follow.
std::size_t signal_count(const Record& record) { return record.accel.size() + (record.has_force ? 1 : 0); }

void read_signal(const Record& record, std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
  if (record.has_force && signal == 0) return record.read_force_N(row, first, out);
  record.read_accel_mps2(row, signal - (record.has_force ? 1 : 0), first, out);
}

// Calls work(row, first, count) for each block of samples.
template <class Work>
void for_each_block(const Record& record, Work&& work) {
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const std::size_t samples = record.rows[row].samples;
    for (std::size_t first = 0; first < samples; first += kBlockFrames)
      work(row, first, std::min(kBlockFrames, samples - first));
  }
}

// The smallest power of two that no sample exceeds: division by it does not round.
std::vector<double> full_scales(const Record& record) {
  std::vector<double> largest(signal_count(record)), part(kBlockFrames);
  for_each_block(record, [&](std::size_t row, std::size_t first, std::size_t count) {
    for (std::size_t s = 0; s < largest.size(); ++s) {
      const auto values = std::span(part).first(count);
      read_signal(record, row, s, first, values);
      largest[s] = std::max(largest[s], extremes_of(values).max_distance_from(0));
    }
  });
  for (double& value : largest) value = value > 0 ? std::exp2(std::ceil(std::log2(value))) : 1;
  return largest;
}

SoundCalibration calibration_of(const Record& record, const std::vector<double>& scales) {
  SoundCalibration out{.fs_Hz = record.fs_Hz,
                       .signals = {},
                       .rows = record.rows,
                       .continuous = record.continuous || record.rows.size() == 1,
                       .geometry = record.geometry,
                       .trace_lines = record.trace_lines};
  for (std::size_t s = 0; s < scales.size(); ++s) {
    const bool is_force = record.has_force && s == 0;
    const SignalInfo& info = is_force ? record.force : record.accel[s - (record.has_force ? 1 : 0)];
    out.signals.push_back({.name = info.name,
                           .measures = is_force ? Quantity::force : info.measures,
                           .to_SI = scales[s],
                           .angle_rad = info.angle_rad,
                           .position_m = info.position_m});
  }
  return out;
}

SoundKind sound_kind(const std::string& path) {
  const std::string extension = file_extension(path);
  return extension == ".w64" ? SoundKind::w64 : extension == ".rf64" ? SoundKind::rf64 : SoundKind::wav;
}

}  // namespace

void write_sound(const std::string& path, const Record& record, bool overwrite) {
  const std::size_t signals = signal_count(record);
  if (record.rows.empty() || signals == 0) throw InputError("nothing to write", path, "keep a hit and a channel");
  const SoundKind kind = sound_kind(path);
  std::vector<std::uint32_t> cues;
  double frames = 0;
  for (const RowInfo& row : record.rows) {
    cues.push_back(
        static_cast<std::uint32_t>(std::min(frames, static_cast<double>(std::numeric_limits<std::uint32_t>::max()))));
    frames += static_cast<double>(row.samples);
  }
  if (kind == SoundKind::wav && frames * static_cast<double>(signals * sizeof(double)) > kMaxWav_bytes)
    throw InputError("longer than a WAV file can be", path, "name it .rf64");
  const bool calibrated = kind != SoundKind::w64;
  const auto scales = calibrated ? full_scales(record) : std::vector<double>(signals, 1);
  const double rate_Hz =
      std::clamp(std::round(record.fs_Hz), 1.0, static_cast<double>(std::numeric_limits<int>::max()));
  SoundOutput out(path, overwrite, kind, signals, static_cast<int>(rate_Hz),
                  cues.size() > 1 ? cues : std::vector<std::uint32_t>{},
                  SoundOutput::Chunk{std::string(kCalibrationChunk), calibration_text(calibration_of(record, scales))});
  std::vector<double> part(kBlockFrames), values(kBlockFrames * signals);
  for_each_block(record, [&](std::size_t row, std::size_t first, std::size_t count) {
    for (std::size_t s = 0; s < signals; ++s) {
      read_signal(record, row, s, first, std::span(part).first(count));
      for (std::size_t n = 0; n < count; ++n) values[n * signals + s] = part[n] / scales[s];
    }
    out.append(std::span<const double>(values).first(count * signals));
  });
  out.commit();
}

}  // namespace percuss::acquire
