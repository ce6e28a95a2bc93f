#include <fmt/format.h>

#include <cmath>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/joined_notes.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameSpacing = 1e-6;  // relative, between files
constexpr double kSameDecay = 5e-3;    // relative: files and users may round to two digits, such as 4.6 for 4.605

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

FrfRecord with_exponential_window(FrfRecord frfs, double decay_per_s) {
  if (frfs.decay_per_s > 0) {
    if (std::abs(decay_per_s / frfs.decay_per_s - 1) <= kSameDecay) return frfs;
    throw InputError(
        fmt::format("an exponential window that decays by {:.5g} 1/s contradicts the FRFs, which state {:.5g} 1/s",
                    decay_per_s, frfs.decay_per_s),
        input_name_of(frfs), "leave it out", {"exponential"});
  }
  frfs.decay_per_s = decay_per_s;
  if (frfs.kind == FrfKind::accelerance) return frfs;
  const std::size_t left_out = frfs.lines.first == 0 ? 1 : 0;
  frfs.lines.first += left_out;
  frfs.lines.count -= left_out;
  for (PointFrf& one : frfs.frfs) {
    one.frf = lines_within(one.frf, left_out, frfs.lines.count);
    for (std::size_t k = 0; k < frfs.lines.count; ++k) {
      const Complex undamped(0, kTwoPi * frfs.lines.freq_Hz(k));
      const Complex ratio = (undamped + decay_per_s) / undamped;
      const Complex by = frfs.kind == FrfKind::mobility ? ratio : ratio * ratio;
      one.frf.value[k] *= by;
      if (!one.frf.std.empty()) one.frf.std[k] *= std::abs(by);
    }
  }
  return frfs;
}

}  // namespace percuss::acquire
