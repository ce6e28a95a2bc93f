#include "batch/line_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch::line_reader_test {

class LineReaderTest : public testing::Test {
 protected:
  std::string written(const std::string& bytes) {
    test::write_bytes(path_, bytes);
    return path_;
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("lines");
};

TEST_F(LineReaderTest, GivesLinesWithTheirPlaces) {
  LineReader lines(written("one\n\nthree"), 100);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "one");
  EXPECT_EQ(lines.end(), 4U);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "");
  EXPECT_TRUE(lines.ended());
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "three");
  EXPECT_FALSE(lines.ended());
  EXPECT_EQ(lines.number(), 3U);
  EXPECT_EQ(lines.offset(), 5U);
  EXPECT_EQ(lines.end(), 10U);
  EXPECT_FALSE(lines.next());
  EXPECT_FALSE(LineReader(written(""), 100).next());
}

// Lines longer and shorter than one read.
TEST_F(LineReaderTest, JoinsLinesReadInPieces) {
  std::vector<std::string> texts;
  std::string bytes;
  for (std::size_t i = 0; i < 60; ++i) {
    texts.emplace_back(i % 5 == 0 ? 5000 * i : i, static_cast<char>('a' + i % 26));
    bytes += texts.back() + "\n";
  }
  LineReader lines(written(bytes), 1'000'000);
  for (const std::string& text : texts) {
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), text);
    EXPECT_EQ(bytes.substr(lines.offset(), text.size()), text);
  }
  EXPECT_FALSE(lines.next());
}

TEST_F(LineReaderTest, RejectsLinesThatAreTooLong) {
  LineReader lines(written("short\n" + std::string(400'000, 'x') + "\n"), 1000);
  ASSERT_TRUE(lines.next());
  try {
    lines.next();
    FAIL() << "a line of 400000 bytes was accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("line 2 is longer than 1000 bytes"));
  }
}

}  // namespace percuss::batch::line_reader_test
