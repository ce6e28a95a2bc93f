#include "acquire/write_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "acquire/record/channel_name.hpp"
#include "acquire/record/stated_date.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

// No format keeps Record::driving.
constexpr const char* kDrivingPlaces = "which points were struck beside a sensor";

[[noreturn]] void refuse_name(const std::string& path, const std::vector<std::string>& extensions) {
  throw InputError("cannot tell what to write", path,
                   fmt::format("name a file that ends in {}", fmt::join(extensions, ", ")));
}

// No file that percuss writes keeps the directions of motion. The UFF format has them, but the writer omits them.
// `test` is a Record or FrfRecord.
template <class Test>
void add_lost_directions(const Test& test, std::vector<std::string>& losses) {
  if (!test.motions.empty()) losses.emplace_back("the directions of motion");
  if (test.sensor_roves) losses.emplace_back("that the sensors moved and the hammer did not");
}

// Whether any channel has a name that is more than its number. Readers name a channel without a name by its number.
bool has_own_names(const std::vector<SignalInfo>& channels) {
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::string& name = channels[c].name;
    if (!name.empty() && name != channel_name(c) && name != fmt::format("channel {}", c + 1)) return true;
  }
  return false;
}

}  // namespace

void write_record(const std::string& path, const Record& record, bool force) {
  const FileFormat* const format = written_format(path);
  if (format == nullptr || format->write_record == nullptr) refuse_name(path, record_extensions());
  format->write_record(path, record, force);
}

void write_frfs(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) {
  const FileFormat* const format = written_format(path);
  if (format == nullptr || format->write_frfs == nullptr) refuse_name(path, frf_extensions());
  format->write_frfs(path, record, kind, force);
}

std::vector<std::string> losses_of(const std::string& path, const Record& record) {
  const FileFormat* const format = written_format(path);
  if (format == nullptr) return {};
  auto losses = format->record_losses != nullptr ? format->record_losses(path, record) : std::vector<std::string>{};
  if (!record.trace_faces.empty() && !format->keeps_faces) losses.emplace_back("the faces between points");
  if (!record.driving.empty()) losses.emplace_back(kDrivingPlaces);
  add_lost_directions(record, losses);
  const bool marked =
      std::any_of(record.rows.begin(), record.rows.end(), [](const RowInfo& row) { return row.mark != RowMark::none; });
  if (!format->keeps_marks && marked) losses.emplace_back("which blows were rejected while they were recorded");
  const auto gaps =
      static_cast<std::size_t>(std::count_if(record.faults.begin(), record.faults.end(), [](const RecordFault& fault) {
        return fault.kind == FaultKind::missing_samples;
      }));
  if (!format->keeps_marks && gaps < record.faults.size()) losses.emplace_back("the faults of the capture");
  if (!format->keeps_marks && gaps > 0) losses.emplace_back("which samples were lost: straight lines take their place");
  if (!format->keeps_date && !common_date_of(record.files).empty()) losses.emplace_back("the date of the test");
  return losses;
}

std::vector<std::string> losses_of(const std::string& path, const FrfRecord& record) {
  const FileFormat* const format = written_format(path);
  if (format == nullptr) return {};
  auto losses = format->frf_losses != nullptr ? format->frf_losses(record) : std::vector<std::string>{};
  if (has_own_names(record.accel)) losses.emplace_back("the channels' names");
  if (!record.driving.empty()) losses.emplace_back(kDrivingPlaces);
  add_lost_directions(record, losses);
  if (format->keeps_frf_geometry) return losses;
  if (!record.geometry.empty()) losses.emplace_back("the geometry");
  if (!record.trace_lines.empty()) losses.emplace_back("the lines between points");
  if (!record.trace_faces.empty()) losses.emplace_back("the faces between points");
  return losses;
}

}  // namespace percuss::acquire
