#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {
inline namespace core {

class PendingFile;

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
  /// The treatment of a symbolic link at the path. `followed` replaces the target of the link. `refused` makes the link
  /// an error; it is for folders of many files. An unnamed temporary file is then opened without a search for abandoned
  /// files: the owner of the folder calls remove_abandoned_files() once instead.
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
  const std::string& temporary_path() const;
  /// Renames the file to its path, with mode 0644 less the umask; within an OutputGroup, later. Call it once.
  void commit();

 private:
  std::unique_ptr<PendingFile> file_;
};

/// The outputs of one command: all files appear, or none. While the group exists, commit() of an AtomicFile on this
/// thread completes its temporary file; commit() of the group renames all of them.
///   OutputGroup outputs;
///   write_file("a.json", …);
///   write_file("b.html", …);
///   outputs.commit();
/// A group within a group leaves its files to the outer one. When a rename fails, the files that are new are removed
/// again; a file that was already replaced stays replaced.
class OutputGroup {
 public:
  OutputGroup();
  ~OutputGroup();
  OutputGroup(const OutputGroup&) = delete;
  OutputGroup& operator=(const OutputGroup&) = delete;
  /// errors  InputError: as AtomicFile::commit
  void commit();

 private:
  friend class AtomicFile;
  std::vector<std::unique_ptr<PendingFile>> files_;
  OutputGroup* outer_;
};

/// Writes a whole file.
void write_file(const std::string& path, std::string_view bytes, bool force);

}  // namespace core
}  // namespace percuss
