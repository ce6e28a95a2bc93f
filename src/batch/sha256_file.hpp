#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/atomic_file.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {

/// The SHA-256 of a record's bytes. errors  InputError: the file cannot be opened; MachineFault: it cannot be read
std::string sha256_of_record(const std::string& path);

/// Writes a text file in pieces and computes its length and SHA-256. errors  InputError as AtomicFile
class Sha256File {
 public:
  Sha256File(const std::string& path, bool force, AtomicFile::Links links = AtomicFile::Links::followed)
      : file_(path, force, AtomicFile::Temporary::unnamed_if_possible, links) {}
  void add(std::string_view text);
  /// Renames the file to its path. Call it once, last.
  void commit();
  // After commit():
  std::uint64_t bytes() const { return bytes_; }
  const std::string& sha256() const { return sha256_; }

 private:
  void flush();

  AtomicFile file_;
  report::Digest digest_;
  std::string text_, sha256_;
  std::uint64_t bytes_ = 0;
};

}  // namespace percuss::batch
