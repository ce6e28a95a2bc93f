#pragma once
#include <string>

namespace percuss::batch {

/// The first bytes of each file of a shard: the beginning of its label (ShardLabel).
std::string part_beginning();

/// An open file of a shard. A symbolic link is never followed.
/// errors  InputError naming the path: a link, a folder, a pipe or a device has the name; MachineFault
class PartFile {
 public:
  /// Opens an existing file for reading. Absent files are not an error.
  static PartFile existing(const std::string& path) { return {path, false}; }
  /// Opens a file for reading and appending, or creates it.
  static PartFile appended(const std::string& path) { return {path, true}; }
  ~PartFile();
  PartFile(PartFile&& from) noexcept;
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile& operator=(PartFile&&) = delete;

  bool present() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  /// The first bytes, at most `count`.
  std::string first_bytes(std::size_t count) const;
  /// Checks that the file is empty or begins like a file of a shard, so that it may be replaced or changed.
  /// errors  InputError: something else wrote the file
  void require_own() const;

 private:
  PartFile(const std::string& path, bool append);

  std::string path_;
  int descriptor_ = -1;
};

/// Removes the temporary files that killed processes left in a folder of results.
void remove_abandoned_parts(const std::string& folder);

}  // namespace percuss::batch
