#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/io/temporary_files.hpp"

namespace percuss::inline core {

/// A file that appears under its name when complete, or not at all: written aside in the same folder, brought to the
/// disk, then renamed. A writer that is killed leaves the old file or none.
///   AtomicFile file("out.csv", force);
///   file.write("hit,t_s\n");
///   file.commit();
/// Where the file system can, the file has no name until then, so that not even SIGKILL leaves anything behind;
/// elsewhere it is called ".out.csv.percuss-PID". A symbolic link is followed: the file it points to is replaced.
/// errors  InputError from every member: the file exists and `force` is not set, the folder is missing, the disk is
/// full, …
class AtomicFile {
 public:
  /// How the unfinished file is kept; `named` everywhere if the file system or /proc does not allow otherwise.
  enum class Temporary { unnamed_if_possible, named };

  AtomicFile(std::string path, bool force, Temporary aside = Temporary::unnamed_if_possible);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends.
  void write(std::string_view bytes);
  /// Where libraries that want a name may write instead, until commit; Aside::named for those that do not take
  /// /proc/self/fd/N.
  const std::string& temporary_path() const { return temporary_path_; }
  /// Puts the file in its place, with mode 0644 less the umask. Once.
  void commit();

 private:
  void open_unnamed(const std::string& folder);
  void open_named();
  void link_name();
  [[noreturn]] void fail(std::string_view problem) const;

  std::string path_, target_, temporary_path_;
  bool force_, unnamed_ = false, committed_ = false;
  int descriptor_ = -1;
  std::optional<TemporaryFile> named_;
};

/// The whole file at once.
void write_file(const std::string& path, std::string_view bytes, bool force);

}  // namespace percuss::inline core
