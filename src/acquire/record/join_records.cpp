#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "acquire/record/joined_notes.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/record.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameRate = 1e-6;  // relative

void require_alike(const Record& first, const Record& other) {
  if (!(std::abs(other.fs_Hz / first.fs_Hz - 1) <= kSameRate)) {
    throw InputError(
        fmt::format("sampling rate {:.10g} Hz where {} has {:.10g} Hz", other.fs_Hz, first.source(), first.fs_Hz),
        other.source(), "analyse the file alone, or each file as one test", {"files"});
  }
  if (other.has_force != first.has_force) {
    throw InputError(fmt::format("{} force where {} has {}", other.has_force ? "a" : "no", first.source(),
                                 first.has_force ? "one" : "none"),
                     other.source(), "give only files with a force, or only files without");
  }
  if (other.accel.size() != first.accel.size()) {
    throw InputError(
        fmt::format("{} acceleration channels where {} has {}", other.accel.size(), first.source(), first.accel.size()),
        other.source(), "choose the same channels in each file", {"accel_channel"});
  }
}

void note_other_names(const Record& first, const Record& other, std::vector<Message>& notes) {
  const auto compare = [&](const SignalInfo& a, const SignalInfo& b) {
    if (a.name == b.name) return;
    notes.emplace_back(fmt::format("{} of {} is taken as the same channel as {} of {}", b.name, other.source(), a.name,
                                   first.source()));
  };
  compare(first.force, other.force);
  for (std::size_t c = 0; c < first.accel.size(); ++c) compare(first.accel[c], other.accel[c]);
}

// Hits in different directions at one point are different degrees of freedom, which no average may mix.
void require_one_direction(const Record& before, const Record& record) {
  if (before.sensor_roves != record.sensor_roves) return;
  for (const PointMotion& motion : record.motions) {
    const PointMotion* const known = find_motion(before.motions, motion.point, motion.channel);
    if (known == nullptr || move_alike({motion}, {*known})) continue;
    throw InputError(fmt::format("another direction at point {} than in the files before", motion.point),
                     record.source(), "analyse the file alone, or take each file as further points", {"files"});
  }
}

// A file without point numbers is one point. The next file's points follow the points of the files before it.
int number_of_points(const Record& record) {
  int last = 0;
  for (const auto& row : record.rows) last = std::max(last, row.point);
  return last + 1;
}

struct Source {
  std::size_t record, row;
};

struct Joined {
  std::vector<Record> records;
  std::vector<Source> rows;
};

}  // namespace

Record join_records(std::vector<Record> records, FileGrouping grouping) {
  if (records.empty()) throw InputError("nothing to join", "no files", "name at least one file");
  if (records.size() == 1) return std::move(records.front());
  Record out = records.front();
  out.files.clear();
  out.rows.clear();
  out.notes.clear();
  out.faults.clear();
  out.contiguous.clear();
  out.continuous = true;
  auto joined = std::make_shared<Joined>();
  std::int64_t points = 0;
  std::vector<NotesOfFile> notes;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Record& record = records[r];
    require_alike(records.front(), record);
    note_other_names(records.front(), record, out.notes);
    notes.push_back({record.source(), record.notes});
    for (RecordFault fault : record.faults) {
      if (fault.row >= 0) fault.row += static_cast<int>(out.rows.size());
      out.faults.push_back(fault);
    }
    for (std::size_t row = 0; row < record.rows.size(); ++row) {
      RowInfo info = record.rows[row];
      info.file += out.files.size();
      if (grouping == FileGrouping::points) {
        require_point_number(info.point + points, record.source());
        info.point += static_cast<int>(points);
      }
      out.rows.push_back(info);
      joined->rows.push_back({r, row});
    }
    if (grouping == FileGrouping::points && r > 0) {
      for (const DrivingPlace& at : record.driving)
        out.driving.push_back({at.point + static_cast<int>(points), at.channel});
    }
    if (r > 0) {
      if (grouping != FileGrouping::points) require_one_direction(out, record);
      join_motions(grouping == FileGrouping::points ? static_cast<int>(points) : 0, record, out, out.notes);
    }
    points += number_of_points(record);
    out.files.insert(out.files.end(), record.files.begin(), record.files.end());
    if (record.files.empty()) out.files.push_back({.path = record.source()});
    out.continuous = out.continuous && (record.rows.size() == 1 || record.continuous);
    if (record.format != out.format) out.format = "several";
  }
  const std::vector<Message> of_files = joined_notes(notes);
  out.notes.insert(out.notes.end(), of_files.begin(), of_files.end());
  joined->records = std::move(records);
  out.read_force_N = [joined](std::size_t row, std::size_t first, std::span<double> samples) {
    const auto [record, its_row] = joined->rows.at(row);
    joined->records[record].read_force_N(its_row, first, samples);
  };
  out.read_accel_mps2 = [joined](std::size_t row, std::size_t channel, std::size_t first, std::span<double> samples) {
    const auto [record, its_row] = joined->rows.at(row);
    joined->records[record].read_accel_mps2(its_row, channel, first, samples);
  };
  return out;
}

}  // namespace percuss::acquire
