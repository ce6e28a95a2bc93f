#include "acquire/formats/text/write_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "core/io/atomic_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kLinesAtOnce = 8192;  // a block's text is written in one call

template <class Number>
void append(std::string& text, Number number) {
  std::array<char, 32> digits{};  // the longest double takes 24
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

bool varies(const Record& record, int RowInfo::*number) {
  return std::any_of(record.rows.begin(), record.rows.end(),
                     [&](const RowInfo& row) { return row.*number != record.rows.front().*number; });
}

// Without a column `point`, a reader takes every row as point 0.
bool states_points(const Record& record) {
  return std::any_of(record.rows.begin(), record.rows.end(), [](const RowInfo& row) { return row.point != 0; });
}

std::string header(const Record& record) {
  std::string text = record.has_force ? "hit,t_s,force_N" : "hit,t_s";
  for (std::size_t c = 0; c < record.accel.size(); ++c)
    text += is_pressure(record.accel[c]) ? fmt::format(",mic{}_Pa", c) : fmt::format(",acc{}_m_s2", c);
  if (states_points(record)) text += ",point";
  if (varies(record, &RowInfo::run)) text += ",run";
  return text + "\n";
}

// The end of each line of a row.
std::string row_end(const Record& record, const RowInfo& row) {
  std::string text;
  if (states_points(record)) text += "," + std::to_string(row.point);
  if (varies(record, &RowInfo::run)) text += "," + std::to_string(row.run);
  return text + "\n";
}

void write_row(AtomicFile& file, const Record& record, std::size_t row) {
  const std::size_t samples = record.rows[row].samples;
  const std::string start = std::to_string(row) + ",", end = row_end(record, record.rows[row]);
  const std::size_t forces = record.has_force ? 1 : 0;
  std::vector<std::vector<double>> columns(forces + record.accel.size());
  std::string text;
  for (std::size_t first = 0; first < samples; first += kLinesAtOnce) {
    const std::size_t count = std::min(kLinesAtOnce, samples - first);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      columns[c].resize(count);
      if (c < forces) {
        record.read_force_N(row, first, columns[c]);
      } else {
        record.read_accel_mps2(row, c - forces, first, columns[c]);
      }
    }
    text.clear();
    for (std::size_t i = 0; i < count; ++i) {
      text += start;
      append(text, static_cast<double>(first + i) / record.fs_Hz);
      for (const auto& column : columns) append(text += ',', column[i]);
      text += end;
    }
    file.write(text);
  }
}

}  // namespace

void write_record_csv(const std::string& path, const Record& record, bool force) {
  AtomicFile file(path, force);
  file.write(header(record));
  for (std::size_t row = 0; row < record.rows.size(); ++row) write_row(file, record, row);
  file.commit();
}

}  // namespace percuss::acquire
