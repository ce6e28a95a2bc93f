#pragma once
#include "acquire/record/record.hpp"
#include "commands/record/record_flags.hpp"
#include "pipeline/analysis_options.hpp"

namespace percuss::tools {

/// Writes the report by the same command that makes it from the file later: analyze, or survey with a geometry.
void write_session_report(const RecordFlags& flags);

/// The document that `percuss analyze FILE --json` prints, from the session's own samples. `record` is the session's,
/// `path` the file that was written.
std::string session_document(acquire::Record record, const std::string& path, const pipeline::AnalysisOptions& options);

}  // namespace percuss::tools
