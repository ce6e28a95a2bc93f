#include "acquire/formats/text/read_lvm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/text/text_check.hpp"
#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr std::string_view kTitle = "LabVIEW Measurement", kEnd = "***End_of_Header***";
constexpr std::size_t kMaxLvmChannels = 4096;
constexpr double kSameLvmStep = 1e-6;  // relative

using LvmCells = std::vector<std::string_view>;
using Tags = std::map<std::string, std::vector<std::string>>;

// A segment: samples [channel][sample] with names and units.
struct Segment {
  std::vector<std::string> names, units;
  double step_s = 0;
  std::vector<std::vector<double>> samples;
};

class LvmParser {
 public:
  explicit LvmParser(const FileBytes& file) : file_(file), rest_(file.view()) {}

  std::vector<Segment> parse() {
    find_separator();
    const Tags head = tags();
    decimal_comma_ = first(head, "Decimal_Separator") == ",";
    x_columns_ = first(head, "X_Columns");
    std::vector<Segment> segments;
    while (rest_.find_first_not_of(" \t\r\n\f,;") != std::string_view::npos) segments.push_back(segment());
    return segments;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(problem, fmt::format("{}: line {}", input_name(file_.path), line_), "export the file again");
  }

  std::string_view next_line() {
    ++line_;
    std::string_view line = take_line(rest_, '\n');
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  LvmCells cells(std::string_view line) const {
    LvmCells out;
    while (out.size() < 2 * kMaxLvmChannels + 2) {
      const auto end = std::min(line.find(separator_), line.size());
      out.push_back(line.substr(0, end));
      if (end == line.size()) break;
      line.remove_prefix(end + 1);
    }
    return out;
  }

  // The line of the tag Separator is "Separator<tab>Tab" or "Separator,Comma".
  void find_separator() {
    constexpr std::string_view kTag = "Separator";
    std::string_view head = file_.view().substr(0, file_.view().find(kEnd));
    while (!head.empty()) {
      const std::string_view line = trimmed(take_line(head, '\n'));
      if (!line.starts_with(kTag)) continue;  // Decimal_Separator is another tag
      if (line.substr(kTag.size()).find("Comma") != std::string_view::npos) separator_ = ',';
      return;
    }
  }

  // Lines "Name<separator>value<separator>value" up to the end of a header.
  Tags tags() {
    Tags out;
    while (!rest_.empty()) {
      const LvmCells line = cells(next_line());
      if (line.front().starts_with(kEnd)) return out;
      std::vector<std::string> values;
      for (std::size_t i = 1; i < line.size(); ++i) values.push_back(to_utf8(trimmed(line[i])));
      out[std::string(trimmed(line.front()))] = std::move(values);
    }
    fail("a header without its end");
  }

  static std::string first(const Tags& tags, const std::string& name) {
    const auto found = tags.find(name);
    return found == tags.end() || found->second.empty() ? "" : found->second.front();
  }

  double number(std::string_view text) const {
    const ParsedNumber parsed = parse_number(text, decimal_comma_);
    if (parsed.problem != NumberProblem::none)
      fail(fmt::format("\"{}\" is {}", one_line(text, 40), describe(parsed.problem)));
    return parsed.value;
  }

  Segment segment() {
    const Tags head = tags();
    const std::string channels_text = first(head, "Channels");
    if (channels_text.empty()) fail("a segment without the tag Channels");
    const double claimed = number(channels_text);
    if (!(claimed >= 1) || claimed > kMaxLvmChannels) fail("an unusable number of channels");
    const auto channels = static_cast<std::size_t>(claimed);
    Segment out;
    const auto labels = cells(next_line());
    const bool paired = x_columns_ == "Multi";
    const auto column = [&](std::size_t channel) { return paired ? 2 * channel + 1 : channel + 1; };
    const auto units = head.find("Y_Unit_Label");
    for (std::size_t c = 0; c < channels; ++c) {
      const bool named = column(c) < labels.size() && !trimmed(labels[column(c)]).empty();
      out.names.push_back(named ? to_utf8(trimmed(labels[column(c)])) : fmt::format("channel {}", c + 1));
      out.units.push_back(units != head.end() && c < units->second.size() ? units->second[c] : "");
    }
    const std::string step = first(head, "Delta_X");
    if (!step.empty()) out.step_s = number(step);
    out.samples.resize(channels);
    read_samples(out, column);
    return out;
  }

  template <class Column>
  void read_samples(Segment& out, Column&& column) {
    double first_x = 0, last_x = 0;
    bool timed = true;
    while (!rest_.empty()) {
      const std::string_view line = next_line();
      if (trimmed(line).empty()) {
        if (!out.samples.front().empty()) break;
        continue;
      }
      const LvmCells row = cells(line);
      if (row.front().starts_with("Channels")) {
        // The next segment begins here: puts the line back.
        rest_ = std::string_view(line.data(), static_cast<std::size_t>(rest_.data() + rest_.size() - line.data()));
        --line_;
        break;
      }
      for (std::size_t c = 0; c < out.samples.size(); ++c) {
        if (column(c) >= row.size()) fail(fmt::format("{} cells for {} channels", row.size(), out.samples.size()));
        out.samples[c].push_back(number(row[column(c)]));
      }
      timed = timed && !trimmed(row.front()).empty();
      if (timed) last_x = number(row.front());
      if (timed && out.samples.front().size() == 1) first_x = last_x;
    }
    const std::size_t count = out.samples.front().size();
    if (out.step_s == 0 && timed && count > 1) out.step_s = (last_x - first_x) / static_cast<double>(count - 1);
  }

  const FileBytes& file_;
  std::string_view rest_;
  char separator_ = '\t';
  bool decimal_comma_ = false;
  std::string x_columns_;
  std::size_t line_ = 0;
};

}  // namespace

bool is_lvm(std::string_view head) {
  head = without_byte_order_mark(head);
  return head.substr(0, kTitle.size()) == kTitle;
}

Record open_lvm(const FileBytes& file, const ReadOptions& options) {
  require_short_lines(file.view(), '\n', input_name(file.path));
  const auto segments = std::make_shared<const std::vector<Segment>>(LvmParser(file).parse());
  const std::string name = input_name(file.path);
  if (segments->empty()) throw InputError("no segment of data", name, "export the file again");
  const Segment& first = segments->front();
  SignalTable table;
  table.files.push_back({.path = file.path, .bytes = file.size});
  table.format = "LabVIEW";
  for (std::size_t c = 0; c < first.names.size(); ++c) {
    table.signals.push_back({.name = first.names[c]});
    if (parse_unit(first.units[c])) table.signals.back().unit = first.units[c];
  }
  for (const Segment& segment : *segments) {
    const bool alike = segment.names.size() == first.names.size() &&
                       std::abs(segment.step_s - first.step_s) <= kSameLvmStep * std::abs(first.step_s);
    if (!alike) throw InputError("segments with other channels or rates than the first one", name, "split the file");
    table.rows.push_back({.samples = segment.samples.front().size()});
  }
  table.continuous = segments->size() == 1;
  if (first.step_s > 0) table.fs_Hz = 1 / first.step_s;
  if (!(first.step_s > 0) && !options.fs_Hz)
    throw InputError("neither Delta_X nor a column of times", name, "state the sampling rate", {"fs"});
  table.read = [segments](std::size_t row, std::size_t signal, std::size_t start, std::span<double> out) {
    std::copy_n((*segments)[row].samples[signal].begin() + static_cast<std::ptrdiff_t>(start), out.size(), out.begin());
  };
  return record_of_table(std::move(table), options);
}

}  // namespace percuss::acquire
