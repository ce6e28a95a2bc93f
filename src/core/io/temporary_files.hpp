#pragma once
#include <string>

namespace percuss {
inline namespace core {

/// A file under a temporary name. During the lifetime of this object, remove_temporary_files() removes the file, and a
/// lock (flock) distinguishes it from files that a killed process left behind.
class TemporaryFile {
 public:
  /// `descriptor` is open for the file at `path`. On a file system without locks, the file stays unlocked.
  TemporaryFile(std::string path, int descriptor);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// False when another process removed the file as abandoned before it was locked.
  bool still_there() const;

 private:
  std::string path_;
  int descriptor_;
};

/// Removes the temporary files of this process. Safe in handlers of signals that end the process (SIGINT, SIGTERM,
/// SIGHUP). Later use of the files fails.
void remove_temporary_files() noexcept;

/// Removes the temporary files (".NAME.percuss-PID") in `folder` whose names start with `prefix`, except files that a
/// running process has locked.
void remove_abandoned_files(const std::string& folder, const std::string& prefix);

}  // namespace core
}  // namespace percuss
