#pragma once
#include <string>

namespace percuss::inline core {

/// A file under a temporary name, known to remove_temporary_files() as long as this object lives. Marks the file
/// (flock) so that another process can tell it from one that a killed process left behind.
class TemporaryFile {
 public:
  /// `descriptor` is open for the file at `path`. The mark fails silently where the file system has no locks.
  TemporaryFile(std::string path, int descriptor);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// False when another process took it for abandoned before it was marked.
  bool still_there() const;

 private:
  std::string path_;
  int descriptor_;
};

/// Removes the temporary files of this process. For handlers of signals that end it (SIGINT, SIGTERM, SIGHUP), and safe
/// there; whoever uses the files afterwards fails.
void remove_temporary_files() noexcept;

/// Removes the files in `folder` whose names start with `prefix` and that no living process marks as its own.
void remove_abandoned_files(const std::string& folder, const std::string& prefix);

}  // namespace percuss::inline core
