#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "targets.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// CMake sets the target.
static const percuss::fuzz::Target& target() {
  static const auto* const kTarget = [] {
    const auto all = percuss::fuzz::targets();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [](const auto& one) { return std::string_view(one.name) == PERCUSS_FUZZ_TARGET; });
    if (found == all.end()) {
      std::fputs("there is no fuzz target " PERCUSS_FUZZ_TARGET "\n", stderr);
      std::abort();
    }
    return &*found;
  }();
  return *kTarget;
}

// The functions that libFuzzer calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target().run({reinterpret_cast<const char*>(data), size});
  return 0;
}

// Changes the structure of about half of the inputs, if the target has a mutator. Changes the bytes of the others.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  percuss::fuzz::Random random(seed);
  if (target().mutate != nullptr && random() % 2 == 0) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    target().mutate(bytes, random);
    if (!bytes.empty() && bytes.size() <= max_size) return bytes.copy(reinterpret_cast<char*>(data), max_size);
  }
  return LLVMFuzzerMutate(data, size, max_size);
}
