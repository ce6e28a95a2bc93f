#include "core/io/read_at.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "support/scratch_folder.hpp"

namespace percuss::read_at_test {

TEST(ReadAt, ReadsUntilTheFileEnds) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("a"), "0123456789");
  const int descriptor = ::open(folder.file("a").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(descriptor, 0);
  const auto text_at = [&](std::uint64_t offset, std::size_t bytes) {
    std::string out(bytes, '.');
    const ReadResult got = read_at(descriptor, offset, out.data(), bytes);
    EXPECT_EQ(got.error, 0);
    EXPECT_EQ(got.bytes, out.find_last_not_of('.') + 1);
    return out;
  };
  EXPECT_EQ(text_at(3, 4), "3456");
  EXPECT_EQ(text_at(7, 5), "789..");
  EXPECT_EQ(text_at(10, 2), "..");
  EXPECT_EQ(text_at(0, 0), "");
  ::close(descriptor);
}

TEST(ReadAt, ReportsTheErrorOfTheSystem) {
  char byte = 0;
  const ReadResult got = read_at(-1, 0, &byte, 1);
  EXPECT_EQ(got.bytes, 0U);
  EXPECT_EQ(got.error, EBADF);
}

}  // namespace percuss::read_at_test
