#include "commands/info/info_frfs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/option_names.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/units.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

bool has_coherence(const acquire::FrfRecord& record) {
  return std::all_of(record.frfs.begin(), record.frfs.end(),
                     [](const acquire::PointFrf& f) { return !f.frf.coherence.empty(); });
}

}  // namespace

std::string optional_text(const std::optional<double>& value, double factor) {
  return value ? fmt::format("{:.6g}", *value * factor) : "-";
}

Json optional_json(const std::optional<double>& value, double factor) {
  return value ? Json(*value * factor) : Json(nullptr);
}

Json note_texts(const std::vector<Message>& notes) {
  Json texts = Json::array();
  for (const Message& note : notes) texts.push_back(note.text);
  return texts;
}

std::string notes_paragraphs(const std::vector<Message>& notes, std::size_t width) {
  constexpr std::size_t kMaxBytes = 2000, kIndent = 2;
  std::string text;
  for (const Message& note : notes) {
    const std::string line = "note: " + one_line(note.written(flag_of), kMaxBytes);
    text += "  " + report::wrapped(line, width, kIndent) + '\n';
  }
  return text;
}

Json frfs_json(const acquire::FrfRecord& record) {
  Json channels = Json::array();
  for (const acquire::SignalInfo& signal : record.accel) {
    channels.push_back({{"name", signal.name},
                        {"to_si", signal.to_SI},
                        {"angle_deg", optional_json(signal.angle_rad, kRadian_deg)},
                        {"position_m", optional_json(signal.position_m, 1)}});
  }
  return {{"path", record.files.front().path},
          {"bytes", record.files.front().bytes},
          {"kind", record.format},
          {"frf_kind", name_of(record.kind)},
          {"lines", record.lines.count},
          {"df_hz", record.lines.df_Hz()},
          {"low_hz", record.lines.freq_Hz(0)},
          {"high_hz", record.lines.freq_Hz(record.lines.count - 1)},
          {"points", record.frfs.size() / record.accel.size()},
          {"coherence", has_coherence(record)},
          {"channels", channels},
          {"notes", note_texts(record.notes)}};
}

std::string frfs_text(const acquire::FrfRecord& record, std::size_t width) {
  const std::size_t points = record.frfs.size() / record.accel.size();
  std::string text = fmt::format(
      "{}: {}, {}, {} lines of {:.7g} Hz from {:.7g} to {:.7g} Hz, {} point{}, {}\n",
      one_line(input_name(record.files.front().path), 400), record.format, name_of(record.kind), record.lines.count,
      record.lines.df_Hz(), record.lines.freq_Hz(0), record.lines.freq_Hz(record.lines.count - 1), points,
      points == 1 ? "" : "s", has_coherence(record) ? "with coherence" : "without coherence");
  using Align = report::TextTable::Align;
  report::TextTable table(
      {{"  name"}, {"SI per unit", Align::right}, {"angle/°", Align::right}, {"position/m", Align::right}, {""}});
  for (const acquire::SignalInfo& signal : record.accel) {
    table.add({"  " + one_line(signal.name, 40), fmt::format("{:.6g}", signal.to_SI),
               optional_text(signal.angle_rad, kRadian_deg), optional_text(signal.position_m, 1), ""});
  }
  return text + table.text(width) + notes_paragraphs(record.notes, width);
}

}  // namespace percuss::tools
