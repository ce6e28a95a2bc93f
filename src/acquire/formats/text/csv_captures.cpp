#include "acquire/formats/text/csv_captures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "acquire/channels/role_guess.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameStart = 0.1;  // of the longest earlier capture: the first times of captures differ by some steps
constexpr std::size_t kMaxCaptures = 1'000'000;

// The lines of one row at which captures start, the row's first line included. Nothing if a time steps back, but not to
// about the first time of the row.
std::optional<std::vector<std::size_t>> capture_starts(const CsvTable& table, const CsvTimes* times,
                                                       const CsvRow& row) {
  const std::size_t end = row.first_line + row.info.samples;
  const auto& after_header = table.lines_after_header();
  auto header = std::upper_bound(after_header.begin(), after_header.end(), row.first_line);
  std::vector<std::size_t> starts = {row.first_line};
  if (times == nullptr) {
    for (; header != after_header.end() && *header < end; ++header) starts.push_back(*header);
    return starts;
  }
  const std::vector<double>& t = times->time_s;
  double longest_s = 0;  // of the earlier captures
  for (std::size_t i = row.first_line + 1; i < end; ++i) {
    const std::size_t start = starts.back();
    const double length_s = t[i - 1] - t[start];
    const double step_s = i - 1 > start ? length_s / static_cast<double>(i - 1 - start) : 0;
    const bool headed = header != after_header.end() && *header == i;
    if (headed) ++header;
    const bool back = t[i] < t[i - 1];
    const bool continues = !back && step_s > 0 && std::abs(t[i] - t[i - 1] - step_s) <= step_s / 2;
    if (!back && (!headed || continues)) continue;
    longest_s = std::max(longest_s, length_s);
    const double reach_s = std::max(kSameStart * longest_s, 1.5 * step_s);
    if (back && !(std::abs(t[i] - t[row.first_line]) <= reach_s)) return std::nullopt;
    if (starts.size() == kMaxCaptures) return std::nullopt;
    starts.push_back(i);
  }
  return starts;
}

// Whether a column that may hold something else than times rises evenly in every capture.
bool captures_rise_evenly(const CsvTimes& times, const std::vector<CsvRow>& captures) {
  return std::all_of(captures.begin(), captures.end(), [&](const CsvRow& row) {
    const auto t = std::span(times.time_s).subspan(row.first_line, row.info.samples);
    return t.size() < kMinRisingSamples ? std::is_sorted(t.begin(), t.end()) : rises_evenly(t);
  });
}

// Largest minus smallest number of a column in a row.
double range_of(const CsvTable& table, std::size_t column, const CsvRow& row) {
  std::array<double, 4096> block{};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t first = 0; first < row.info.samples; first += block.size()) {
    const auto part = std::span(block).first(std::min(block.size(), row.info.samples - first));
    table.read(column, row.first_line + first, part);
    const auto [least, most] = std::minmax_element(part.begin(), part.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  return high - low;
}

// Whether at least half of the captures hold a blow.
bool hold_blows(const CsvTable& table, std::size_t signal, const std::vector<CsvRow>& captures) {
  constexpr double kMinBlow = 0.05;  // of the strongest capture
  std::vector<double> ranges;
  try {
    for (const CsvRow& row : captures) ranges.push_back(range_of(table, signal, row));
  } catch (const InputError&) {
    return true;
  }
  const double least = kMinBlow * *std::max_element(ranges.begin(), ranges.end());
  const auto strong = std::count_if(ranges.begin(), ranges.end(), [&](double range) { return range >= least; });
  return 2 * static_cast<std::size_t>(strong) >= ranges.size();
}

}  // namespace

std::vector<CsvRow> divide_into_captures(const CsvTable& table, const std::optional<CsvTimes>& times,
                                         std::size_t signal, const std::vector<CsvRow>& rows) {
  if (times && times->problem) return rows;
  std::vector<CsvRow> captures;
  for (const CsvRow& row : rows) {
    const auto starts = capture_starts(table, times ? &*times : nullptr, row);
    if (!starts || captures.size() + starts->size() > kMaxCaptures) return rows;
    for (std::size_t i = 0; i < starts->size(); ++i) {
      CsvRow& capture = captures.emplace_back(row);
      capture.first_line = (*starts)[i];
      const std::size_t end = i + 1 < starts->size() ? (*starts)[i + 1] : row.first_line + row.info.samples;
      capture.info.samples = end - capture.first_line;
    }
  }
  if (captures.size() == rows.size()) return rows;
  if (times && times->kind != CsvTimeKind::named && !captures_rise_evenly(*times, captures)) return rows;
  return hold_blows(table, signal, captures) ? captures : rows;
}

}  // namespace percuss::acquire
