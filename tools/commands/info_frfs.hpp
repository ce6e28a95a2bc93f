#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "frf/frf_record.hpp"

namespace percuss::tools {

/// What percuss info says of a file of FRFs, as JSON and for people.
nlohmann::ordered_json frfs_json(const frf::FrfRecord& record);
std::string frfs_text(const frf::FrfRecord& record, std::size_t width);

/// The texts of notes.
nlohmann::ordered_json note_texts(const std::vector<Message>& notes);

/// `value` × factor, or what stands for nothing: null, "-".
nlohmann::ordered_json optional_json(const std::optional<double>& value, double factor);
std::string optional_text(const std::optional<double>& value, double factor);

}  // namespace percuss::tools
