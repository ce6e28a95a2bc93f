#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "acquire/record/record.hpp"
#include "commands/record/record_flags.hpp"

namespace percuss::tools {

/// Checks, before anything is recorded, that the end of the session can write the output and the report; decides
/// whether it may replace the report.
/// errors  OptionError: no output, or a name of another kind; InputError, as when the files are written
void check_session_files(RecordFlags& flags);

/// The journal of an earlier session that would be overwritten. Empty: none.
struct UnfinishedSession {
  std::string journal;
  std::optional<std::size_t> blows;  // nothing if the journal cannot be read

  /// "the 3 blows of its journal".
  std::string content() const;
};

/// errors  InputError: there is one, and --force is not given
UnfinishedSession find_unfinished(const RecordFlags& flags);

/// The command that goes on with the session: "percuss record --resume test.h5".
std::string resume_command(const std::string& output);

/// Writes the record of the session. The blows are in its journal too, until the caller removes it.
/// errors  InputError: the remedy says that the blows are safe, and how to write them
void write_session(const RecordFlags& flags, const acquire::Record& record);

}  // namespace percuss::tools
