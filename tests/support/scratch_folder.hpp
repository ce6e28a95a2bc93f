#pragma once
#include <string>
#include <vector>

#include "core/io/temporary_folder.hpp"

namespace percuss::test {

/// A temporary folder for one test, removed with its contents.
class ScratchFolder : public TemporaryFolder {
 public:
  ScratchFolder() : TemporaryFolder("percuss-test") {}

  /// The names of the files and folders in it, in no order.
  std::vector<std::string> names() const;
};

/// The content of a file; empty when it cannot be read.
std::string bytes_of(const std::string& path);
/// Replaces the content of a file, or creates it. Throws std::runtime_error when it cannot be written.
void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace percuss::test
