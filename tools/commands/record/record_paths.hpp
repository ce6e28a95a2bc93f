#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace percuss::tools {

/// The files that the options of an interrupted session name. Relative paths began in the session's working folder;
/// they are looked for there, in the present folder and beside the journal.
class SessionPaths {
 public:
  /// `folder`: where the session began; empty if an older journal does not state it.
  SessionPaths(const std::string& folder, const std::string& journal);

  /// The path of a file from here: the first file with this SHA-256; otherwise the first file that exists; otherwise
  /// `path` itself.
  std::string find(const std::string& path, const std::string& sha256 = {}) const;
  /// The same for the file in the name of a device: "file:RECORD", "sim:SPEC,…", "plugin:PATH:…".
  std::string find_device(const std::string& device) const;
  /// Where a file of the session is written.
  std::string target(const std::string& path) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> bases_;
};

/// Whether two names mean one device: equal texts, or the same file.
bool names_same_device(const std::string& a, const std::string& b);

/// Whether two paths name one file, such as "t.h5", "./t.h5" and a link to it.
bool names_same_file(const std::string& a, const std::string& b);

}  // namespace percuss::tools
