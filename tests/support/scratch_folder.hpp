#pragma once
#include <string>

#include "core/io/temporary_folder.hpp"

namespace percuss::test {

/// A temporary folder for one test, removed with its contents.
class ScratchFolder : public TemporaryFolder {
 public:
  ScratchFolder() : TemporaryFolder("percuss-test") {}
};

std::string bytes_of(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace percuss::test
