#include "core/io/write_all.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <thread>

namespace percuss::write_all_test {

// A pipe takes 64 KiB at a time.
TEST(WriteAll, WritesInPartsWhereItMust) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  std::string sent(1'000'000, ' '), got;
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<char>('a' + i % 23);
  std::thread reader([&] {
    std::array<char, 1000> block{};
    for (ssize_t n = 0; (n = ::read(ends[0], block.data(), block.size())) > 0;)
      got.append(block.data(), static_cast<std::size_t>(n));
  });
  EXPECT_TRUE(write_all(ends[1], sent));
  ::close(ends[1]);
  reader.join();
  ::close(ends[0]);
  EXPECT_EQ(got, sent);
}

TEST(WriteAll, ReportsAFullDisk) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  EXPECT_TRUE(write_all(full, ""));
  EXPECT_FALSE(write_all(full, "a"));
  EXPECT_EQ(errno, ENOSPC);
  ::close(full);
}

}  // namespace percuss::write_all_test
