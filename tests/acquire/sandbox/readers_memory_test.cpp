#include "acquire/sandbox/readers_memory.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "acquire/sandbox/sandbox_process.hpp"
#include "support/confinement.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::readers_memory_test {

TEST(ReadersMemory, LimitsTheSumOfAllReaders) {
  ReadersMemory memory(1000);
  const int a = 0, b = 0;
  EXPECT_TRUE(memory.store(&a, 0, 600));
  EXPECT_FALSE(memory.store(&b, 0, 600));
  memory.remove(&a);
  EXPECT_TRUE(memory.store(&b, 0, 600));
  EXPECT_FALSE(memory.store(&b, 0, 1001));
}

TEST(ReadersMemory, GrowsWithTheFiles) {
  ReadersMemory memory(1000);
  const int a = 0;
  EXPECT_TRUE(memory.store(&a, 100, 7400));
  EXPECT_FALSE(memory.store(&a, 100, 7401));
  memory.remove(&a);
  EXPECT_EQ(memory.limit_bytes(), 1000U);
}

#ifndef PERCUSS_SANITIZED  // sanitizers have an allocator of their own, which does not report its memory
TEST(ReadersMemory, CountsWhatAReaderHasTaken) {
  if (!test::has_seccomp()) return;
  const test::ScratchFolder folder;
  const std::string path = folder.file("a");
  test::write_bytes(path, "x");
  constexpr std::size_t kHoard_bytes = 100'000'000;
  std::vector<char> hoard;
  const auto open = [&] {
    hoard.assign(kHoard_bytes, 'x');
    return SandboxService{"described", {}};
  };
  const int others = 0;
  constexpr std::size_t kRest_bytes = ReadersMemory::kPool_bytes - kHoard_bytes;
  {
    const SandboxProcess reader(path, open);
    EXPECT_TRUE(readers_memory().store(&others, 0, kRest_bytes / 2));
    EXPECT_FALSE(readers_memory().store(&others, 0, kRest_bytes + 1000));
  }
  EXPECT_TRUE(readers_memory().store(&others, 0, kRest_bytes + 1000));
  readers_memory().remove(&others);
}
#endif

}  // namespace percuss::acquire::readers_memory_test
