#include "acquire/write_record.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/formats/mat/write_mat.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/write_sound.hpp"
#include "acquire/formats/text/write_csv.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

std::string kind_of(const std::string& path) {
  std::string kind = std::filesystem::path(path).extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kind;
}

bool is_uff_name(const std::string& kind) { return kind == ".uff" || kind == ".unv"; }
bool is_sound_name(const std::string& kind) { return kind == ".wav" || kind == ".rf64" || kind == ".w64"; }

}  // namespace

const std::vector<std::string>& record_extensions() {
  static const std::vector<std::string> kExtensions{".h5",  ".hdf5", ".csv",  ".mat", ".uff",
                                                    ".unv", ".wav",  ".rf64", ".w64"};
  return kExtensions;
}

void write_record(const std::string& path, const Record& record, bool force) {
  const std::string kind = kind_of(path);
  if (kind == ".csv") return write_record_csv(path, record, force);
  if (kind == ".mat") return write_mat(path, record, force);
  if (is_uff_name(kind)) return write_uff(path, record, force);
  if (is_sound_name(kind)) return write_sound(path, record, force);
  if (kind == ".h5" || kind == ".hdf5") return write_hdf5(path, record, force);
  throw InputError("cannot tell what to write", path,
                   "name a file that ends in .h5, .csv, .mat, .uff, .unv, .wav, .rf64 or .w64");
}

std::vector<std::string> losses_of(const std::string& path, const Record& record) {
  const std::string kind = kind_of(path);
  const auto any = [&](auto place) {
    return std::any_of(record.accel.begin(), record.accel.end(), [&](const auto& s) { return (s.*place).has_value(); });
  };
  const bool coordinates = !record.geometry.empty() && record.geometry.front().size() == 3;
  const bool numbers_only = kind == ".csv" || kind == ".w64";
  std::vector<std::string> out;
  const bool too_far_apart = is_sound_name(kind) && !numbers_only && !calibration_holds_geometry(record.geometry);
  const bool geometry_kept = !numbers_only && !too_far_apart && (!is_uff_name(kind) || coordinates);
  if (!record.geometry.empty() && !geometry_kept) {
    out.emplace_back(numbers_only    ? "the geometry"
                     : too_far_apart ? "the geometry (its points are numbered too far apart)"
                                     : "the geometry (positions and angles instead of coordinates)");
  }
  const std::size_t lines_kept = !geometry_kept      ? 0
                                 : is_uff_name(kind) ? uff_drawable_lines(record.geometry, record.trace_lines).size()
                                                     : record.trace_lines.size();
  if (lines_kept < record.trace_lines.size()) {
    out.emplace_back(lines_kept == 0 ? "the lines between points" : "lines to points without coordinates");
  }
  if (numbers_only && any(&SignalInfo::angle_rad)) out.emplace_back("the sensors' angles");
  if (numbers_only && any(&SignalInfo::position_m)) out.emplace_back("the sensors' positions");
  if (kind == ".csv" && record.continuous && record.rows.size() > 1)
    out.emplace_back("that every row may hold several hits");
  if (kind == ".w64" && record.rows.size() > 1) out.emplace_back("where hits begin, their points and runs");
  if (kind == ".w64" && record.fs_Hz != std::round(record.fs_Hz)) out.emplace_back("the sampling rate's fraction");
  if (kind == ".wav" || kind == ".rf64") return out;
  const auto is_named = [&](std::size_t c) { return record.accel[c].name != "accel " + std::to_string(c + 1); };
  bool named = kind == ".w64";
  for (std::size_t c = 0; c < record.accel.size(); ++c) named = named || is_named(c);
  if (named) out.emplace_back("the channels' names");
  return out;
}

}  // namespace percuss::acquire
