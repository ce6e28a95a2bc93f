#include "acquire/formats/sound/sound_format.hpp"

#include <array>
#include <cmath>

#include "acquire/formats/sound/read_sound.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/formats/sound/write_sound.hpp"
#include "acquire/record/record_losses.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 3> kSoundExtensions{".wav", ".rf64", ".w64"};

Measurement open_sound_file(const FormatInput& input, const FrfReadOptions& options, Content /*content*/) {
  return open_sound(input.path, options.read);
}

// W64 has no custom chunks.
std::vector<std::string> w64_losses(const Record& record) {
  std::vector<std::string> losses;
  if (!record.geometry.empty()) losses.emplace_back("the geometry");
  add_lost_lines(record.trace_lines, 0, losses);
  add_lost_places(record, losses);
  if (record.rows.size() > 1) losses.emplace_back("where hits begin, their points and runs");
  if (record.fs_Hz != std::round(record.fs_Hz)) losses.emplace_back("the sampling rate's fraction");
  losses.emplace_back("the channels' names");
  return losses;
}

std::vector<std::string> sound_losses(const std::string& path, const Record& record) {
  if (file_extension(path) == ".w64") return w64_losses(record);
  std::vector<std::string> losses;
  const bool kept = calibration_holds_geometry(record.geometry);
  if (!record.geometry.empty() && !kept) losses.emplace_back("the geometry (its points are numbered too far apart)");
  add_lost_lines(record.trace_lines, kept ? record.trace_lines.size() : 0, losses);
  return losses;
}

}  // namespace

const FileFormat kSoundFormat{.name = "sound",
                              .extensions = kSoundExtensions,
                              .written = kSoundExtensions,
                              .sandboxed = true,
                              .detect = [](const FileHead& head) { return is_sound(head.bytes); },
                              .open = open_sound_file,
                              .write_record = write_sound,
                              .record_losses = sound_losses};

}  // namespace percuss::acquire
