#include "acquire/write_record.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "acquire/write_csv.hpp"
#include "acquire/write_hdf5.hpp"
#include "acquire/write_mat.hpp"
#include "acquire/write_uff.hpp"
#include "core/error.hpp"

namespace percuss {
namespace {

std::string kind_of(const std::string& path) {
  std::string kind = std::filesystem::path(path).extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kind;
}

bool is_uff_name(const std::string& kind) { return kind == ".uff" || kind == ".unv"; }

}  // namespace

const std::vector<std::string>& record_extensions() {
  static const std::vector<std::string> kExtensions{".h5", ".hdf5", ".csv", ".mat", ".uff", ".unv"};
  return kExtensions;
}

void write_record(const std::string& path, const Record& record, bool force) {
  const std::string kind = kind_of(path);
  if (kind == ".csv") return write_record_csv(path, record, force);
  if (kind == ".mat") return write_mat(path, record, force);
  if (is_uff_name(kind)) return write_uff(path, record, force);
  if (kind == ".h5" || kind == ".hdf5") return write_hdf5(path, record, force);
  throw InputError("cannot tell what to write", path, "name a file that ends in .h5, .csv, .mat, .uff or .unv");
}

std::vector<std::string> losses_of(const std::string& path, const Record& record) {
  const std::string kind = kind_of(path);
  const auto any = [&](auto place) {
    return std::any_of(record.accel.begin(), record.accel.end(), [&](const auto& s) { return (s.*place).has_value(); });
  };
  const bool coordinates = !record.geometry.empty() && record.geometry.front().size() == 3;
  std::vector<std::string> out;
  const bool geometry_kept = kind != ".csv" && (!is_uff_name(kind) || coordinates);
  if (!record.geometry.empty() && !geometry_kept)
    out.emplace_back(kind == ".csv" ? "the geometry" : "the geometry (positions and angles instead of coordinates)");
  if (kind == ".csv" && any(&SignalInfo::angle_rad)) out.emplace_back("the sensors' angles");
  if (kind == ".csv" && any(&SignalInfo::position_m)) out.emplace_back("the sensors' positions");
  if (kind == ".csv" && record.continuous && record.rows.size() > 1)
    out.emplace_back("that every row may hold several hits");
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    if (record.accel[c].name == "accel " + std::to_string(c + 1)) continue;
    out.emplace_back("the channels' names");
    break;
  }
  return out;
}

}  // namespace percuss
