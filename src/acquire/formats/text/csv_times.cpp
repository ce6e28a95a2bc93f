#include "acquire/formats/text/csv_times.hpp"

#include <algorithm>
#include <utility>

#include "acquire/channels/column_words.hpp"
#include "core/io/clock_text.hpp"
#include "core/io/csv_text.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// Gives the time of a cell, or throws InputError.
using TimeOfCell = std::function<double(std::size_t line, std::string_view cell)>;

TimeOfCell number_times(const CsvTable& table, std::size_t index, double to_s) {
  const bool comma = table.dialect().decimal_comma;
  return [&table, index, to_s, comma](std::size_t line, std::string_view cell) {
    const auto number = parse_number(cell, comma);
    if (number.problem == NumberProblem::none) return number.value * to_s;
    throw InputError("the time is " + std::string(describe(number.problem)), table.place(line, index),
                     "fill the gap, or state the sampling rate", {"fs"});
  };
}

// Times of day as seconds from the first stamp, so that their digits are kept. The record may pass midnight.
TimeOfCell clock_times(const CsvTable& table, std::size_t index) {
  constexpr double kDay_s = 86400;
  return [&table, index, first_s = 0.0, last_s = 0.0](std::size_t line, std::string_view cell) mutable {
    const auto clock = parse_clock(cell);
    if (!clock) {
      throw InputError("\"" + one_line(to_utf8(trimmed(cell)), 40) + "\" is no time of day", table.place(line, index),
                       "correct it, or state the sampling rate", {"fs"});
    }
    const bool next_day = line > 0 && clock->time_s < last_s - kDay_s / 2;
    last_s = clock->time_s + (next_day ? kDay_s : 0);
    if (line == 0) first_s = last_s;
    return last_s - first_s;
  };
}

// Reads the cells until one is no time.
void read_times(const CsvTable& table, TimeOfCell time_of, CsvTimes& times) {
  times.time_s.reserve(table.lines());
  table.for_each_cell(times.column.index, [&](std::size_t line, std::string_view cell) {
    if (times.problem) return;
    try {
      times.time_s.push_back(time_of(line, cell));
    } catch (const InputError& error) {
      times.problem = error;
    }
  });
}

bool may_count_samples(const CsvColumn& column, const CsvColumns& columns) {
  const auto is = [&](const CsvColumn& other) { return other.index == column.index; };
  return column.index == 0 && column.has_numbers && !is_helper(column, columns) &&
         !(columns.has_force && is(columns.force)) && std::none_of(columns.accel.begin(), columns.accel.end(), is) &&
         is_one_of(lower_case(column.base), kCountWords);
}

}  // namespace

std::optional<std::size_t> clock_column(const CsvTable& table) {
  constexpr std::size_t kLeftmost = 4;
  for (std::size_t index = 0; index < kLeftmost; ++index) {
    std::size_t clocks = 0;
    for (std::size_t line = 0; line < std::min<std::size_t>(2, table.lines()); ++line)
      clocks += parse_clock(table.cell(index, line)) ? 1U : 0U;
    if (clocks == 2) return index;
  }
  return std::nullopt;
}

std::optional<CsvTimes> read_csv_times(const CsvTable& table, const CsvColumns& columns) {
  CsvTimes times;
  const auto clock = columns.time ? std::nullopt : clock_column(table);
  if (clock) {
    times.kind = CsvTimeKind::clock;
    times.column.index = *clock;
    times.decimals = [](std::string_view cell) { return parse_clock(cell).value_or(ClockTime{}).decimals; };
    read_times(table, clock_times(table, *clock), times);
    return times;
  }
  const CsvColumn& first = table.header().columns.front();
  if (columns.time) {
    times.column = *columns.time;
  } else if (may_be_time(first, columns) || may_count_samples(first, columns)) {
    times.kind = may_be_time(first, columns) ? CsvTimeKind::guessed : CsvTimeKind::counted;
    times.column = first;
  } else {
    return std::nullopt;
  }
  const auto unit = parse_unit(times.column.unit);
  times.to_s = unit ? unit->to_SI : 1;
  times.decimals = [comma = table.dialect().decimal_comma](std::string_view cell) { return decimals_of(cell, comma); };
  read_times(table, number_times(table, times.column.index, times.to_s), times);
  return times;
}

}  // namespace percuss::acquire
