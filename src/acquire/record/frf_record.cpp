#include <fmt/format.h>

#include <cmath>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/joined_notes.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameSpacing = 1e-6;  // relative, between files

std::string input_name_of(const FrfRecord& record) { return input_name(record.source()); }

}  // namespace

FrfRecord join_frfs(std::vector<FrfRecord> records) {
  if (records.empty()) throw InputError("nothing to join", "no files", "name at least one file");
  FrfRecord out = std::move(records.front());
  std::vector<NotesOfFile> notes{{input_name_of(out), out.notes}};
  std::vector<Message> notes_of_all;
  for (std::size_t r = 1; r < records.size(); ++r) {
    FrfRecord& next = records[r];
    const bool spaced = std::abs(next.lines.df_Hz() / out.lines.df_Hz() - 1) <= kSameSpacing;
    if (!spaced || next.lines.first != out.lines.first || next.lines.count != out.lines.count) {
      throw InputError(
          fmt::format("{} lines every {:.6g} Hz from {:.6g} Hz, but {} has {} every {:.6g} Hz from {:.6g} Hz",
                      next.lines.count, next.lines.df_Hz(), next.lines.freq_Hz(0), input_name_of(out), out.lines.count,
                      out.lines.df_Hz(), out.lines.freq_Hz(0)),
          input_name_of(next), "analyse the file alone, or each file as one test", {"files"});
    }
    if (next.accel.size() != out.accel.size() || next.decay_per_s != out.decay_per_s) {
      throw InputError(fmt::format("the channels or the exponential window differ from {}", input_name_of(out)),
                       input_name_of(next), "analyse the file alone, or each file as one test", {"files"});
    }
    const int after = out.frfs.back().point + 1;
    require_point_number(std::int64_t{after} + next.frfs.back().point, input_name_of(next));
    for (PointFrf& frf : next.frfs) {
      frf.point += after;
      out.frfs.push_back(std::move(frf));
    }
    for (const DrivingPlace& at : next.driving) out.driving.push_back({at.point + after, at.channel});
    join_motions(after, next, out, notes_of_all);
    notes.push_back({input_name_of(next), next.notes});
    out.files.insert(out.files.end(), next.files.begin(), next.files.end());
    if (next.format != out.format) out.format = "several";
    if (next.estimator != out.estimator) out.estimator.clear();
  }
  out.notes = joined_notes(notes);
  out.notes.insert(out.notes.end(), notes_of_all.begin(), notes_of_all.end());
  return out;
}

}  // namespace percuss::acquire
