#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

class TemporaryFile;

/// Bytes as a file in the folder for temporary files (TMPDIR, else /tmp), readable by this user only. The destructor
/// removes its name; a process that has opened the file can still read it. A signal that ends this process removes it
/// too.
/// errors  InputError: the folder cannot be written, the disk is full
class SpooledFile {
 public:
  explicit SpooledFile(std::string_view bytes);
  ~SpooledFile();
  SpooledFile(const SpooledFile&) = delete;
  SpooledFile& operator=(const SpooledFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int descriptor_ = -1;
  std::unique_ptr<TemporaryFile> registered_;
};

}  // namespace core
}  // namespace percuss
