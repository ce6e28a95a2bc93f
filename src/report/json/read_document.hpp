#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "metrics/compare.hpp"

namespace percuss::report {

/// The documents in one of percuss's JSON files ("-" is standard input) that have modes or deflections: an analysis
/// (each of its runs is one), a model of a beam, an impact, a bat or a shell, deflections. Keys that are not needed are
/// not looked at. InputError: not JSON, another kind of document, a needed key missing or of another type.
std::vector<metrics::ComparedDocument> read_documents(const std::string& path);

/// As read_documents, for a text in memory; `where` names it.
std::vector<metrics::ComparedDocument> parse_documents(std::string_view text, const std::string& where);

}  // namespace percuss::report
