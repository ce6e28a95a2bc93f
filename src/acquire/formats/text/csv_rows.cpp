#include "acquire/formats/text/csv_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/signal_overrides.hpp"
#include "acquire/record/note_on_rounding.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/sampling_rate.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/io/time_stamps.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using Labels = std::array<int, 3>;  // hit, point, run

int whole_number(std::string_view cell, const CsvTable& table, std::size_t line, std::size_t index) {
  const auto number = parse_number(cell, table.dialect().decimal_comma);
  const bool usable = number.problem == NumberProblem::none &&
                      std::abs(number.value) <= static_cast<double>(kMaxPointNumber) &&
                      std::rint(number.value) == number.value;
  if (usable) return static_cast<int>(number.value);
  throw InputError("\"" + one_line(to_utf8(trimmed(cell)), 40) + "\" is not a whole number", table.place(line, index),
                   "number the hits, points and runs from 0");
}

// A line where the column's value changes, and the new value.
struct Change {
  std::size_t line;
  int value;
};

std::vector<Change> changes_of(const CsvTable& table, std::size_t index) {
  constexpr std::size_t kMaxRows = 1'000'000;
  std::vector<Change> changes;
  std::string_view last;
  table.for_each_cell(index, [&](std::size_t line, std::string_view cell) {
    if (line > 0 && cell == last) return;
    last = cell;
    const int value = whole_number(cell, table, line, index);
    if (!changes.empty() && changes.back().value == value) return;
    if (changes.size() == kMaxRows) {
      throw InputError("more than a million hits", table.place(line, index), "sort the lines by hit, in order of time");
    }
    changes.push_back({line, value});
  });
  return changes;
}

void end_row(std::vector<CsvRow>& rows, std::size_t line) {
  if (!rows.empty()) rows.back().info.samples = line - rows.back().first_line;
}

[[noreturn]] void refuse_stamps(const CsvTable& table, std::size_t index, const std::vector<CsvRow>& rows,
                                const StampProblem& problem) {
  const std::string place = table.place(rows[problem.row].first_line + problem.at, index);
  if (problem.kind == StampProblemKind::rates_differ)
    throw InputError(problem.text, place, "give the hits of each sampling rate in files of their own");
  if (problem.kind == StampProblemKind::jump) {
    throw InputError(problem.text, place,
                     "samples seem lost: write the time with more digits, or delete the lines on the side of the jump "
                     "that lacks the hit");
  }
  throw InputError(problem.text, place, "state the sampling rate: the time column is then not used", {"fs"});
}

// The stamps of each row. They refer to `times`.
// errors  InputError: a line has no time
std::vector<TimeStamps> stamps_of(const CsvTable& table, const CsvTimes& times, const std::vector<CsvRow>& rows) {
  if (times.problem) throw InputError(*times.problem);
  // Stamps may lack trailing zeros. Of the last 64, the one with the most decimals shows the rounding.
  constexpr std::size_t kLast = 64;
  std::vector<int> decimals(rows.size(), -400);  // the fewest that decimals_of() returns
  std::size_t row = 0;
  table.for_each_cell(times.column.index, [&](std::size_t line, std::string_view cell) {
    while (line >= rows[row].first_line + rows[row].lines()) ++row;
    if (line + kLast >= rows[row].first_line + rows[row].lines())
      decimals[row] = std::max(decimals[row], times.decimals(cell));
  });
  std::vector<TimeStamps> stamps;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    stamps.push_back({std::span(times.time_s).subspan(rows[r].first_line, rows[r].lines()),
                      times.to_s * std::pow(10.0, -decimals[r])});
  }
  return stamps;
}

using RowGaps = std::vector<std::vector<StampGap>>;  // [rows]

RowGaps gaps_of_rows(const std::vector<TimeStamps>& stamps, std::optional<double> fs_Hz) {
  RowGaps gaps;
  for (const TimeStamps& row : stamps) gaps.push_back(gaps_of_stamps(row, fs_Hz));
  return gaps;
}

// Adds the missing samples to the rows.
void add_gaps(const RowGaps& gaps, std::vector<CsvRow>& rows) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::size_t missing = 0;
    for (const StampGap& gap : gaps[r]) {
      rows[r].gaps.push_back({.first = gap.at + missing, .count = gap.count});
      missing += gap.count;
    }
    rows[r].info.samples += missing;
  }
}

// The rate of the stamps. If only gaps make the stamps uneven, adds these gaps to the rows.
// errors  InputError: a line has no time
std::optional<StampedRate> stamped_rate(const CsvTable& table, const CsvTimes& times, std::vector<CsvRow>& rows,
                                        StampProblem& problem) {
  std::vector<TimeStamps> stamps = stamps_of(table, times, rows);
  auto rate = rate_of_time_stamps(stamps, problem);
  if (rate) return rate;
  const RowGaps gaps = gaps_of_rows(stamps, {});
  std::vector<std::vector<double>> filled(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    filled[r] = with_missing_stamps(stamps[r].time_s, gaps[r]);
    stamps[r].time_s = filled[r];
  }
  StampProblem of_filled;
  rate = rate_of_time_stamps(stamps, of_filled);
  if (rate) add_gaps(gaps, rows);
  return rate;
}

// The rate from header and time column. Prefers the exact rate of the header if the rounded stamps allow it.
double agreed_rate_Hz(const CsvHeader& header, const StampedRate& stamped, const std::string& stamps,
                      const std::string& file, std::vector<Message>& notes) {
  constexpr double kSame = 1e-3;  // allowed between a header's nominal rate and a measured clock
  if (header.fs_Hz && *header.fs_Hz >= stamped.lowest_Hz && *header.fs_Hz <= stamped.highest_Hz) return *header.fs_Hz;
  if (header.fs_Hz && !(std::abs(*header.fs_Hz / stamped.fs_Hz - 1) <= kSame)) {
    throw InputError(fmt::format("two sampling rates: {:.6g} Hz by \"{}\" and {:.6g} Hz by {}", *header.fs_Hz,
                                 header.fs_line, stamped.fs_Hz, stamps),
                     file + ": header", "state the right one", {"fs"});
  }
  if (header.fs_Hz) {
    notes.emplace_back(fmt::format("sampling rate {:.10g} Hz from the time column; the header says {:.10g} Hz",
                                   stamped.fs_Hz, *header.fs_Hz));
  } else if (!stamped.note.empty()) {
    notes.push_back(note_on_rounding(stamped.note, largest_error_of(stamped), "fs"));
  }
  return stamped.fs_Hz;
}

double header_rate_Hz(const CsvHeader& header, const std::string& file) {
  if (header.fs_Hz) return checked_rate_Hz(*header.fs_Hz, file + ": " + header.fs_line);
  throw InputError("no sampling rate: no time column and no line that states it", file, "state it in Hz", {"fs"});
}

// The rate from times of day; from the header where they give none, for instance in whole seconds.
double clock_rate_Hz(const CsvTable& table, const CsvTimes& times, std::vector<CsvRow>& rows, const std::string& file,
                     std::vector<Message>& notes) {
  const CsvHeader& header = table.header();
  StampProblem problem;
  std::optional<StampedRate> stamped;
  try {
    stamped = stamped_rate(table, times, rows, problem);
  } catch (const InputError&) {
    if (!header.fs_Hz) throw;
  }
  if (!stamped && header.fs_Hz) return header_rate_Hz(header, file);
  if (!stamped) refuse_stamps(table, times.column.index, rows, problem);
  return agreed_rate_Hz(header, *stamped, "the times of day in column " + std::to_string(times.column.index + 1), file,
                        notes);
}

// Whether the times never fall within the row.
bool keeps_rising(const CsvTimes& times, const CsvRow& row) {
  if (times.time_s.size() < row.first_line + row.lines()) return true;  // not known
  const auto t = std::span(times.time_s).subspan(row.first_line, row.lines());
  return std::is_sorted(t.begin(), t.end());
}

// Adds a note if the first and the last time of the first row contradict the stated rate. Times that start again within
// the row state no rate.
void note_other_times(const CsvTable& table, const CsvColumns& columns, const std::optional<CsvTimes>& times,
                      const std::vector<CsvRow>& rows, double fs_Hz, std::vector<Message>& notes) {
  if (!columns.time || rows.front().lines() < 2) return;
  if (times && !keeps_rising(*times, rows.front())) return;
  const auto to_s = s_per_unit(columns.time->unit);
  const auto time_at = [&](std::size_t line) {
    return parse_number(table.cell(columns.time->index, line), table.dialect().decimal_comma);
  };
  const auto first = time_at(rows.front().first_line);
  const auto last = time_at(rows.front().first_line + rows.front().lines() - 1);
  if (!to_s || first.problem != NumberProblem::none || last.problem != NumberProblem::none) return;
  const double length_s = (last.value - first.value) * *to_s;
  if (!(length_s > 0)) return;
  note_other_rate("the column " + columns.time->name, static_cast<double>(rows.front().info.samples - 1) / length_s,
                  fs_Hz, notes);
}

}  // namespace

std::size_t CsvRow::lines() const {
  return std::accumulate(gaps.begin(), gaps.end(), info.samples,
                         [](std::size_t left, const CsvGap& gap) { return left - gap.count; });
}

std::vector<CsvRow> find_csv_rows(const CsvTable& table, const CsvColumns& columns) {
  const std::array<const std::optional<CsvColumn>*, 3> sources = {&columns.hit, &columns.point, &columns.run};
  std::array<std::vector<Change>, 3> changes;
  std::set<std::size_t> starts = {0};
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (*sources[k]) changes[k] = changes_of(table, (*sources[k])->index);
    for (const auto& change : changes[k]) starts.insert(change.line);
  }
  for (const Change& change : changes[1])
    require_point_number(change.value, table.place(change.line, columns.point->index));
  std::vector<CsvRow> rows;
  std::set<Labels> seen;
  std::array<std::size_t, 3> at{};
  for (const std::size_t line : starts) {
    Labels labels{};
    for (std::size_t k = 0; k < sources.size(); ++k) {
      while (at[k] + 1 < changes[k].size() && changes[k][at[k] + 1].line <= line) ++at[k];
      if (!changes[k].empty()) labels[k] = changes[k][at[k]].value;
    }
    if (!seen.insert(labels).second) {
      throw InputError(fmt::format("hit {} occurs again after another hit", labels[0]), table.place(line),
                       "sort the lines by hit, in order of time");
    }
    end_row(rows, line);
    rows.push_back({{.samples = 0, .point = labels[1], .run = labels[2]}, line});
  }
  end_row(rows, table.lines());
  return rows;
}

double find_csv_rate_Hz(const CsvTable& table, const CsvColumns& columns, const std::optional<CsvTimes>& times,
                        std::vector<CsvRow>& rows, const ReadOptions& options, std::vector<Message>& notes) {
  if (options.fs_Hz) {
    // A column that holds no times does not matter: the stated rate replaces it.
    if (times && times->kind == CsvTimeKind::named && !times->problem)
      add_gaps(gaps_of_rows(stamps_of(table, *times, rows), options.fs_Hz), rows);
    note_other_times(table, columns, times, rows, *options.fs_Hz, notes);
    return checked_rate_Hz(*options.fs_Hz, "the rate stated");
  }
  const CsvHeader& header = table.header();
  const std::string file = input_name(table.path());
  if (!times || times->kind == CsvTimeKind::counted) return header_rate_Hz(header, file);
  if (times->kind == CsvTimeKind::clock)
    return checked_rate_Hz(clock_rate_Hz(table, *times, rows, file, notes), file + ": time stamps");
  const bool guessed = times->kind == CsvTimeKind::guessed;
  const CsvColumn& time = times->column;
  StampProblem problem;
  const auto stamped = stamped_rate(table, *times, rows, problem);
  const bool counts = stamped && std::abs(stamped->fs_Hz * times->to_s - 1) < 1e-9;
  // Such a first column is not the time: it is a count of samples or a signal.
  if (guessed && (!stamped || counts)) return header_rate_Hz(header, file);
  if (!stamped) refuse_stamps(table, time.index, rows, problem);
  // A guessed column with a name needs no check: may_be_time() has excluded the names of counts and signals. Without
  // names, ms are as likely as s.
  if (!(guessed && header.named) && !parse_unit(time.unit) && !header.fs_Hz) {
    require_plausible_times(stamped->fs_Hz, header.named ? "the column " + time.name : time.name,
                            file + ": time column",
                            "state the sampling rate, or write the unit into the header: Time (ms)");
  }
  if (guessed)
    notes.emplace_back(fmt::format("the first column ({}) rises evenly and is taken as time in s", time.name));
  return checked_rate_Hz(agreed_rate_Hz(header, *stamped, "the column " + time.name, file, notes),
                         file + ": time column");
}

}  // namespace percuss::acquire
