#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/read_flags.hpp"

namespace percuss::tools {

/// The options of record, as typed.
struct RecordFlags {
  std::string output;  // -o, or the file of --resume
  std::string resume;
  std::string device;
  std::size_t hits = 5;
  std::vector<std::string> channel_list;  // as typed: "1", "3-5"
  std::vector<std::size_t> channels;      // of the device, from 1
  std::optional<double> fs_Hz, trigger_N, pretrigger_s, length_s;
  std::string geometry;
  std::string roving = "hammer";
  std::string band;
  std::string object = "auto";
  std::string until;
  std::string report;
  ReadFlags read;    // --setup
  std::string date;  // when the session began, for the file; empty for simulated and replayed devices
  bool fast = false, json = false, force = false, quiet = false;
  std::string session_report;      // where the interrupted session would have written its report
  bool replace_report = false;     // an existing report may be overwritten at the end
  std::vector<std::string> given;  // the options on the command line: "hits"

  bool is_given(const std::string& option) const {
    return std::find(given.begin(), given.end(), option) != given.end();
  }
};

/// Convert the options that a resumed session takes from its journal to one line of JSON, and back. --report and --fast
/// may be given anew. Checksums tell whether the geometry and the set-up are still the same.
/// errors  InputError at `where`: the text does not hold these options; InputError: the geometry or the set-up has
/// changed; OptionError: a given option contradicts the session
std::string settings_json(const RecordFlags& flags);
bool is_settings(const std::string& event);
void restore_settings(const std::string& event, const std::string& where, RecordFlags& flags);

/// The path of the journal of a session that records this file.
std::string journal_of(const std::string& output);

/// Records, and returns the exit code.
int run_record(RecordFlags flags);

}  // namespace percuss::tools
