#pragma once
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "commands/record/record_flags.hpp"
#include "pipeline/live/session_quality.hpp"
#include "pipeline/run_analyses.hpp"

namespace percuss::tools {

/// The analysis of a finished session, computed once: from the session's own samples, with the options of
/// `percuss analyze`.
class SessionResult {
 public:
  /// `record` is the session's, `path` the file that was written, `accepted` the number of blows that count.
  SessionResult(acquire::Record record, const std::string& path, const pipeline::AnalysisOptions& options,
                std::size_t accepted);

  const pipeline::Analysis& analysis() const { return *runs_.front().analysis; }
  const pipeline::SessionQuality& quality() const { return quality_; }
  /// Number of warnings of the analysis, without infos, that `quality` does not name among its problems.
  std::size_t further_warnings() const;
  /// The document that `percuss analyze FILE --json` prints.
  std::string document() const;

 private:
  std::vector<pipeline::RunAnalysis> runs_;
  pipeline::SessionQuality quality_;
};

/// The command that analyses the written file: analyze, or survey with a geometry.
std::string analysis_command(const RecordFlags& flags);

/// Writes the report with the command that a user would run on the file: analyze, or survey with a geometry. A file
/// that appeared during the session is kept, unless --force is given. Returns the command's exit code. If the command
/// fails, prints the reason, and the command line that writes the report later.
int write_session_report(const RecordFlags& flags);

}  // namespace percuss::tools
