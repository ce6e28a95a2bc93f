#pragma once
#include <string>

namespace percuss {
inline namespace core {

/// A path in the folder for temporary files (TMPDIR, else /tmp) whose end mkstemp and mkdtemp replace.
std::string temporary_template(const std::string& prefix);

/// A new folder in the folder for temporary files (TMPDIR, else /tmp), for this user only. The destructor removes it
/// with its contents.
/// errors  InputError: the folder cannot be made
class TemporaryFolder {
 public:
  /// Its name begins with `prefix`.
  explicit TemporaryFolder(const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace core
}  // namespace percuss
