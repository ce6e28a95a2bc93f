#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/option_names.hpp"
#include "core/error.hpp"
#include "frf/formats/frf_record.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {

/// The description of a file of FRFs, as JSON and as text.
nlohmann::ordered_json frfs_json(const frf::FrfRecord& record);
std::string frfs_text(const frf::FrfRecord& record, std::size_t width);

/// `value` × `factor`; null or "-" if there is no value.
nlohmann::ordered_json optional_json(const std::optional<double>& value, double factor);
std::string optional_text(const std::optional<double>& value, double factor);

/// The texts of a record's notes for a document, which names no options.
template <class Notes>
std::vector<std::string> note_texts(const Notes& notes) {
  std::vector<std::string> texts;
  for (const auto& note : notes) texts.push_back(Message{note}.text);
  return texts;
}

/// A record's notes for a terminal, a paragraph each, with their options as flags.
template <class Notes>
std::string notes_paragraphs(const Notes& notes, std::size_t width) {
  constexpr std::size_t kMaxBytes = 2000, kIndent = 2;
  std::string text;
  for (const auto& note : notes) {
    const std::string line = "note: " + one_line(Message{note}.written(flag_of), kMaxBytes);
    text += "  " + report::wrapped(line, width, kIndent) + '\n';
  }
  return text;
}

}  // namespace percuss::tools
