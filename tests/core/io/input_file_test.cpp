#include "core/io/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::input_file_test {

using test::input_error_of;
using testing::EndsWith;
using testing::HasSubstr;

constexpr std::size_t kLimit_bytes = std::size_t{1} << 20U;

std::string file_of(const test::ScratchFolder& folder, std::size_t size) {
  std::string path = folder.file("text.json");
  test::write_bytes(path, std::string(size, ' '));
  return path;
}

TEST(ReadInput, ReadsAFileUpToTheLimit) {
  const test::ScratchFolder folder;
  EXPECT_EQ(read_input(file_of(folder, kLimit_bytes), kLimit_bytes).size, kLimit_bytes);
}

// Only a record can be split or saved as HDF5.
TEST(ReadInput, SaysHowToMakeATooLongFileReadable) {
  const test::ScratchFolder folder;
  const std::string path = file_of(folder, kLimit_bytes + 1);
  EXPECT_THAT(input_error_of([&] { read_input(path, kLimit_bytes); }),
              testing::AllOf(HasSubstr("longer than 1 MiB"), EndsWith("; give a smaller file")));
  EXPECT_THAT(input_error_of([&] { read_input(path, kLimit_bytes, {}, {}, kSplitRecord); }),
              EndsWith("; split it, or save it as HDF5"));
  EXPECT_THAT(input_error_of([&] { lazy_input(path, kLimit_bytes); }), EndsWith("; split it, or save it as HDF5"));
}

}  // namespace percuss::input_file_test
