#include "build_description.hpp"

#include <fftw3.h>
#include <fmt/format.h>

#include <fstream>

#include "report/text/version.hpp"

namespace percuss::accuracy {
namespace {

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string build_description() {
#ifdef NDEBUG
  const char* build = "release build";
#else
  const char* build = "debug build: times mean little";
#endif
  return fmt::format("percuss {}, {}, {}, {}; {}", report::version(), compiler(), build, fftw_version, processor());
}

}  // namespace percuss::accuracy
