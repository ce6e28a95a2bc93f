#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/atomic_file.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {

/// A text file written a piece at a time, of which the length and the SHA-256 are known at the end. errors  InputError
/// as AtomicFile.
class Sha256File {
 public:
  Sha256File(const std::string& path, bool force) : file_(path, force) {}
  void add(std::string_view text);
  /// Puts the file in its place. Once, last.
  void commit();
  // After that:
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
