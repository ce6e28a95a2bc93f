#include "acquire/formats/text/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/role_guess.hpp"
#include "acquire/channels/signal_overrides.hpp"
#include "acquire/channels/unit_notes.hpp"
#include "acquire/formats/text/csv_captures.hpp"
#include "acquire/formats/text/csv_rows.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "acquire/formats/text/csv_times.hpp"
#include "acquire/formats/text/frf_text_columns.hpp"
#include "acquire/record/sample_gap.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

// The data shared by the read functions of a record.
struct OpenCsv {
  explicit OpenCsv(const FileBytes& bytes) : table(bytes, layout_of_text(bytes, CsvContent::time_record)) {}
  CsvTable table;
  std::vector<CsvRow> rows;
  std::size_t force_column = 0;
  double force_to_N = 1;
  std::vector<std::size_t> accel_columns;
  std::vector<double> accel_to_mps2;
};

SignalInfo describe_force(const CsvColumn& column, const ReadOptions& options, const std::string& file,
                          std::vector<Message>& notes) {
  SignalInfo signal{.name = column.name, .unit = column.unit};
  const SignalOverrides choice = force_overrides(options, setup_of(column, options));
  const bool assumed = !states_scale(signal, choice);
  apply_force_overrides(signal, choice, file + ": column " + column.name, notes);
  if (assumed) mark_unit_assumed(signal);
  return signal;
}

SignalInfo describe_accel(const CsvColumns& columns, const ReadOptions& options, std::size_t index,
                          const std::string& file) {
  const CsvColumn& column = columns.accel[index];
  const std::size_t count = columns.accel.size();
  SignalInfo signal{.name = column.name, .unit = column.unit};
  SignalOverrides choice = accel_overrides(options, setup_of(column, options), index, count, file);
  if (columns.has_force) choice.sign *= response_sign(setup_of(columns.force, options));
  const bool assumed = !states_scale(signal, choice);
  apply_overrides(signal, choice, response_quantity(signal, choice, columns.has_force),
                  file + ": column " + column.name);
  if (assumed) mark_unit_assumed(signal);
  return signal;
}

void describe_signals(const CsvColumns& columns, const ReadOptions& options, OpenCsv& open, Record& record) {
  const std::string file = input_name(open.table.path());
  record.has_force = columns.has_force;
  if (record.has_force) {
    record.force = describe_force(columns.force, options, file, record.notes);
    open.force_column = columns.force.index;
    open.force_to_N = record.force.to_SI;
  }
  for (std::size_t c = 0; c < columns.accel.size(); ++c) {
    record.accel.push_back(describe_accel(columns, options, c, file));
    open.accel_columns.push_back(columns.accel[c].index);
    open.accel_to_mps2.push_back(record.accel.back().to_SI);
  }
  note_assumed_units(record);
}

// Divides the rows into captures, if no column numbers the hits. A capture is searched for hits like a separate file.
void divide_rows(OpenCsv& open, const CsvColumns& columns, const std::optional<CsvTimes>& times, Record& record) {
  if (columns.hit) return;
  const std::size_t signal = columns.has_force ? columns.force.index : columns.accel.front().index;
  const std::size_t before = open.rows.size();
  open.rows = divide_into_captures(open.table, times, signal, open.rows);
  if (open.rows.size() == before) return;
  record.continuous = true;
  const char* const mark = open.table.lines_after_header().empty() ? "the time starts again" : "the header is repeated";
  record.notes.push_back(
      information(fmt::format("the file is read as {} captures: {} between them", open.rows.size(), mark)));
}

void require_samples(const OpenCsv& open) {
  for (const auto& row : open.rows) {
    if (row.info.samples < 2) {
      throw InputError("fewer than two samples", open.table.place(row.first_line),
                       "record for longer, or delete the line");
    }
  }
}

void describe_rows(const OpenCsv& open, Record& record) {
  for (const auto& row : open.rows) {
    for (const CsvGap& gap : row.gaps) {
      const SampleGap in_record{.row = record.rows.size(), .first = gap.first, .count = gap.count};
      record.faults.push_back(fault_of(in_record, record.fs_Hz));
    }
    record.rows.push_back(row.info);
  }
}

void read_lines(const OpenCsv& open, std::size_t column, double to_SI, std::size_t line, std::span<double> out) {
  open.table.read(column, line, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] *= to_SI;
    if (!(std::abs(out[i]) <= kMaxSample)) {
      throw InputError("too large once scaled to SI", open.table.place(line + i, column),
                       "correct the number or the scale");
    }
  }
}

// Reads samples of a row, with straight lines across its gaps.
void read_scaled(const OpenCsv& open, std::size_t row, std::size_t column, double to_SI, std::size_t first,
                 std::span<double> out) {
  assert(row < open.rows.size() && first + out.size() <= open.rows[row].info.samples);
  const CsvRow& csv_row = open.rows[row];
  const std::size_t last = first + out.size();
  std::size_t at = first, missing = 0;  // next sample to give; samples that the gaps before it lack
  const auto read_until = [&](std::size_t end) {
    if (at >= end) return;
    read_lines(open, column, to_SI, csv_row.first_line + at - missing, out.subspan(at - first, end - at));
    at = end;
  };
  for (const CsvGap& gap : csv_row.gaps) {
    const std::size_t gap_end = gap.first + gap.count;
    if (gap.first >= last) break;
    if (gap_end > first) {
      read_until(gap.first);
      std::array<double, 2> beside{};
      read_lines(open, column, to_SI, csv_row.first_line + gap.first - 1 - missing, beside);
      const double step = (beside[1] - beside[0]) / static_cast<double>(gap.count + 1);
      for (; at < std::min(gap_end, last); ++at)
        out[at - first] = beside[0] + static_cast<double>(at - gap.first + 1) * step;
    }
    missing += gap.count;
  }
  read_until(last);
}

constexpr std::size_t kRisingSamples = 256;  // enough to tell frequencies from a signal
// The smallest step at which a first column without a name may be frequencies. A time step of this many seconds would
// mean a sampling rate of only 20 Hz.
constexpr double kMinFrequencyStep_Hz = 0.05;

std::vector<double> first_samples(const CsvTable& table, std::size_t index, std::size_t max_samples) {
  std::vector<double> samples(std::min(table.lines(), max_samples));
  table.read(index, 0, samples);
  return samples;
}

// Whether one column after the first is active for a much shorter time than all others, as a hammer's force is. The
// share of lines in which the imaginary part of a resonance is active is a fifth of the share for its real part: too
// little difference for a hammer. A column that cannot be read is no candidate.
bool shows_hammer(const std::vector<CsvColumn>& columns,
                  const std::function<std::vector<double>(std::size_t, std::size_t)>& read) {
  std::vector<double> shares;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (!columns[i].has_numbers) continue;
    try {
      shares.push_back(active_share(read(columns[i].index, kGuessedSamples)));
    } catch (const InputError&) {
      continue;
    }
  }
  std::sort(shares.begin(), shares.end());
  return shares.size() > 1 && kMaxDissimilarityRatio * shares[0] < shares[1];
}

// The sampling rate of times in ms, if they are no plausible times in s; otherwise 0. Also 0 for numbers that rise by
// 1: they count the samples.
double rate_of_ms_Hz(const std::vector<double>& times) {
  if (times.back() - times.front() == static_cast<double>(times.size() - 1)) return 0;
  const double rate_Hz = static_cast<double>(times.size() - 1) / (times.back() - times.front());
  return rate_Hz < kMinTestRate_Hz ? 1000 * rate_Hz : 0;
}

// The first samples of a column. If they are times that start again in each capture, only the times of the first
// capture.
std::vector<double> samples_for_guess(const CsvTable& table, std::size_t index, std::size_t max_samples) {
  std::vector<double> samples = first_samples(table, index, max_samples);
  const auto back = std::adjacent_find(samples.begin(), samples.end(), std::greater<>());
  if (index > 0 || back == samples.end()) return samples;
  std::vector<double> first(samples.begin(), back + 1);
  return rises_evenly(first) ? first : samples;
}

// The guess must not fail: the caller reports the missing roles.
RoleGuess guess_of(const CsvTable& table, const CsvColumns& known, const ReadOptions& options) {
  const auto read = [&](std::size_t index, std::size_t max) { return samples_for_guess(table, index, max); };
  RoleGuess guess = guess_roles(table.header().columns, known, options, read);
  const std::vector<CsvColumn>& columns = table.header().columns;
  if (columns.front().index == 0 && columns.front().has_numbers) {
    const std::vector<double> first = read(0, kRisingSamples);
    const bool pairs = !table.header().named && columns.size() >= 3 && columns.size() % 2 == 1 && first.size() > 1 &&
                       first[1] - first[0] >= kMinFrequencyStep_Hz && !shows_hammer(columns, read);
    guess.frf_table = (names_frfs(table.header()) || pairs) && rises_evenly(first);
    if (!guess.frf_table && !options.fs_Hz && columns.front().unit.empty() && rises_evenly(first))
      guess.assumed_rate_Hz = rate_of_ms_Hz(first);
  }
  const bool stated = table.header().fs_Hz || options.fs_Hz || clock_column(table);
  if (stated) guess.assumed_rate_Hz = 0;
  guess.rate_known = guess.rate_known || stated;
  return guess;
}

CsvColumns columns_of(const CsvTable& table, const ReadOptions& options, const std::string& file) {
  try {
    return find_csv_columns(table.header(), options, file);
  } catch (AmbiguousColumns& error) {
    error.guess = guess_of(table, error.known, options);
    throw;
  }
}

}  // namespace

Record open_csv(const FileBytes& bytes, const ReadOptions& options) {
  auto open = std::make_shared<OpenCsv>(bytes);
  Record record;
  record.files.push_back({.path = bytes.path, .bytes = bytes.size});
  record.format = "CSV";
  const CsvColumns columns = columns_of(open->table, options, input_name(bytes.path));
  try {
    describe_signals(columns, options, *open, record);
  } catch (const InputError& error) {
    throw_with_columns_if_unscaled(error, open->table.header(), record.format);
    throw;
  }
  const auto unread =
      unread_hammer_note(open->table.header().columns, columns,
                         [&](std::size_t index, std::size_t max) { return first_samples(open->table, index, max); });
  if (unread) record.notes.push_back(*unread);
  open->rows = find_csv_rows(open->table, columns);
  const std::optional<CsvTimes> times = read_csv_times(open->table, columns);
  divide_rows(*open, columns, times, record);
  require_samples(*open);
  record.fs_Hz = find_csv_rate_Hz(open->table, columns, times, open->rows, options, record.notes);
  describe_rows(*open, record);
  record.read_force_N = [open](std::size_t row, std::size_t first, std::span<double> out) {
    read_scaled(*open, row, open->force_column, open->force_to_N, first, out);
  };
  if (!record.has_force) record.read_force_N = no_force();
  record.read_accel_mps2 = [open](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    read_scaled(*open, row, open->accel_columns.at(channel), open->accel_to_mps2.at(channel), first, out);
  };
  return record;
}

}  // namespace percuss::acquire
