#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "metrics/compare.hpp"

namespace percuss::report {

/// Reads the documents with modes or deflections from a JSON file of percuss ("-" is standard input): an analysis (each
/// run is a document), a model of a beam, an impact, a bat or a shell, deflections. Other keys are ignored.
/// errors  InputError: not JSON, another kind of document, a required key missing or of another type.
std::vector<metrics::ComparedDocument> read_documents(const std::string& path);

/// The same for a text in memory; `where` names it in messages.
std::vector<metrics::ComparedDocument> parse_documents(std::string_view text, const std::string& where);

}  // namespace percuss::report
