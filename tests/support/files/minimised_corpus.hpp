#pragma once
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace percuss::test {

/// Unpacks the minimised inputs of a fuzz target into `folder`. Returns the folder of the inputs. Throws
/// std::runtime_error when tar fails.
inline std::string extract_minimised(const std::string& target, const std::string& folder) {
  const std::string archive = PERCUSS_SOURCE_DIR "/fuzz/minimised.tar.gz", name = "minimised/" + target;
  const std::string command = "tar -C '" + folder + "' -xzf '" + archive + "' " + name;
  if (std::system(command.c_str()) != 0) throw std::runtime_error("cannot unpack: " + command);
  return folder + "/" + name;
}

}  // namespace percuss::test
