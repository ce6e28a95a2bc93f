#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/io/temporary_files.hpp"

namespace percuss {
inline namespace core {

/// Synchronises the folder of a file, so that a new name in it survives a loss of power. Failures are ignored: some
/// network drives cannot synchronise a folder.
void sync_folder(const std::string& path);

/// A file under a temporary name in its folder, or without a name. The implementation of AtomicFile.
/// errors  InputError from every member, as AtomicFile
class PendingFile {
 public:
  /// `follows_links`: replace the target of a symbolic link at the path, and remove abandoned files. Otherwise a link
  /// is an error, and abandoned files are removed only before a named temporary file is created.
  PendingFile(std::string path, bool force, bool unnamed_if_possible, bool follows_links);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void write(std::string_view bytes) const;
  /// Synchronises the bytes to the disk.
  void complete() const;
  /// Throws when a file has appeared at the path that may not be replaced.
  void check_absent() const;
  /// Gives the file its name, in few system calls.
  void publish();
  /// Removes a published file, unless it replaced another one.
  void withdraw() const;
  /// Synchronises the folder. Allocates no memory, so that it cannot fail after the file is published.
  void sync_folder() const noexcept;

  const std::string& temporary_path() const { return temporary_path_; }

 private:
  void check_target(bool follows_links);
  void open_unnamed();
  void open_named();
  [[noreturn]] void fail(std::string_view problem) const;

  std::string path_, target_, folder_, temporary_path_;
  bool force_, unnamed_ = false, replaces_ = false, published_ = false;
  int descriptor_ = -1;
  std::optional<TemporaryFile> named_;
};

}  // namespace core
}  // namespace percuss
