#include <algorithm>
#include <cstdint>

#include "targets.hpp"

// The function that libFuzzer calls. CMake sets the target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto* const kTarget = [] {
    const auto all = percuss::fuzz::targets();
    return &*std::find_if(all.begin(), all.end(),
                          [](const auto& target) { return std::string_view(target.name) == PERCUSS_FUZZ_TARGET; });
  }();
  kTarget->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
