#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/io/temporary_files.hpp"

namespace percuss {
inline namespace core {

/// A file that appears under its name only when it is complete. It is written under a temporary name in the same
/// folder, synchronised to the disk, then renamed. A killed writer leaves the old file, or none.
///   AtomicFile file("out.csv", force);
///   file.write("hit,t_s\n");
///   file.commit();
/// Where the file system allows it, the temporary file has no name, so that even SIGKILL leaves nothing behind.
/// Elsewhere it is called ".out.csv.percuss-PID", and the next writer of out.csv removes it after a kill.
/// errors  InputError from every member: the file exists and `force` is not set, the folder is missing, the disk is
/// full, …
class AtomicFile {
 public:
  /// The kind of temporary file. It is `named` wherever the file system or /proc does not support the other kind.
  enum class Temporary { unnamed_if_possible, named };
  /// A symbolic link at the path: its target is replaced, or it is an error. The latter is for folders of many files:
  /// their owner removes abandoned files once, with remove_abandoned_files().
  enum class Links { followed, refused };

  AtomicFile(std::string path, bool force, Temporary kind = Temporary::unnamed_if_possible,
             Links links = Links::followed);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes to the file.
  void write(std::string_view bytes);
  /// The path of the temporary file until commit(), for libraries that need a name. Use Temporary::named for libraries
  /// that do not accept /proc/self/fd/N.
  const std::string& temporary_path() const { return temporary_path_; }
  /// Renames the file to its path, with mode 0644 less the umask. Call it once.
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

/// Writes a whole file.
void write_file(const std::string& path, std::string_view bytes, bool force);

}  // namespace core
}  // namespace percuss
