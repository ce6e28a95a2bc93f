#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"

namespace percuss::tools {

/// The description of a file of FRFs, as JSON and as text.
nlohmann::ordered_json frfs_json(const acquire::FrfRecord& record);
std::string frfs_text(const acquire::FrfRecord& record, std::size_t width);

/// The texts of notes for a document, which names no options.
nlohmann::ordered_json note_texts(const std::vector<Message>& notes);

/// The notes for a terminal, a paragraph each, with their options as flags.
std::string notes_paragraphs(const std::vector<Message>& notes, std::size_t width);

/// `value` × `factor`; null or "-" if there is no value.
nlohmann::ordered_json optional_json(const std::optional<double>& value, double factor);
std::string optional_text(const std::optional<double>& value, double factor);

}  // namespace percuss::tools
