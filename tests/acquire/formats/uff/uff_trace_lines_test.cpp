#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "acquire/formats/uff/uff_trace_lines.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "core/error.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// Trace lines, and points without coordinates, in every format that stores them.
namespace percuss::acquire::uff_trace_lines_test {

using test::csv_bytes;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string set_of(int number, const std::string& lines) {
  return fmt::format("    -1\n{:6}\n{}    -1\n", number, lines);
}

UffTraceLines lines_in(const std::string& text) {
  const FileBytes file = csv_bytes(text);
  return read_uff_trace_lines(split_uff(file), file);
}

std::string head(int kind, int nodes) {
  return fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, kind, 1, 1, 7, nodes);
}

std::string cells(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size(); ++i) out += fmt::format("{:10}{}", numbers[i], i % 8 == 7 ? "\n" : "");
  return out.ends_with('\n') ? out : out + '\n';
}

TEST(UffTraceFaces, ArePlaneElementsAndShells) {
  const UffTraceLines found =
      lines_in(set_of(2412, head(94, 4) + cells({1, 2, 3, 4}) + head(91, 3) + cells({3, 4, 5}) + head(111, 4) +
                                cells({1, 2, 3, 4}) + head(11, 2) + cells({0, 1, 1}) + cells({4, 7})));
  EXPECT_THAT(found.faces, ElementsAre(TraceFace{1, 2, 3, 4}, TraceFace{3, 4, 5}));
}

TEST(UffTraceFaces, AreWrittenAndReadBack) {
  const std::vector<TraceFace> faces{{0, 1, 5, 4}, {4, 5, 9}, {0, 1, 2, 3, 4}};
  const UffTraceLines found = lines_in(set_of(2412, uff_element_lines(faces, 1)));
  EXPECT_THAT(found.faces, ElementsAre(TraceFace{1, 2, 6, 5}, TraceFace{5, 6, 10})) << "five corners are no element";
}

TEST(UffTraceLines, FollowSet82AndBreakAtZero) {
  const UffTraceLines found =
      lines_in(set_of(82, fmt::format("{:10}{:10}{:10}\nNONE\n", 1, 10, 0) + cells({1, 2, 3, 0, 5, 6, 0, 3, 2, 9})));
  EXPECT_THAT(found.lines, ElementsAre(TraceLine{1, 2}, TraceLine{2, 3}, TraceLine{5, 6}, TraceLine{2, 9}))
      << "2 and 3 are connected once";
}

TEST(UffTraceLines, AreTheEdgesOfElements) {
  EXPECT_THAT(lines_in(set_of(2412, head(11, 2) + cells({0, 1, 1}) + cells({4, 7}))).lines,
              ElementsAre(TraceLine{4, 7}))
      << "a rod; its orientation stands between header and nodes";
  EXPECT_THAT(lines_in(set_of(2412, head(91, 3) + cells({1, 2, 3}))).lines,
              ElementsAre(TraceLine{1, 2}, TraceLine{2, 3}, TraceLine{3, 1}));
  EXPECT_EQ(lines_in(set_of(2412, head(94, 4) + cells({1, 2, 3, 4}))).lines.size(), 4U);
  EXPECT_EQ(lines_in(set_of(2412, head(111, 4) + cells({1, 2, 3, 4}))).lines.size(), 6U);
  EXPECT_EQ(lines_in(set_of(2412, head(112, 6) + cells({1, 2, 3, 4, 5, 6}))).lines.size(), 9U);
  EXPECT_EQ(lines_in(set_of(2412, head(115, 8) + cells({1, 2, 3, 4, 5, 6, 7, 8}))).lines.size(), 12U);
  const UffTraceLines shared =
      lines_in(set_of(2412, head(94, 4) + cells({1, 2, 3, 4}) + head(94, 4) + cells({2, 5, 6, 3})));
  EXPECT_EQ(shared.lines.size(), 7U) << "two faces share an edge";
  const UffTraceLines other = lines_in(set_of(2412, head(122, 1) + cells({1}) + head(91, 3) + cells({1, 2, 3})));
  EXPECT_EQ(other.other_elements, 1U);
  EXPECT_EQ(other.lines.size(), 3U);
}

TEST(UffTraceLines, AreReadUpToDamage) {
  const UffTraceLines found =
      lines_in(set_of(2412, head(91, 3) + cells({1, 2, 3}) + head(91, 3) + "         1      a  2\n"));
  EXPECT_EQ(found.lines.size(), 3U);
  EXPECT_THAT(found.unreadable, HasSubstr("x.csv: line 6"));
  EXPECT_THAT(lines_in(set_of(2412, head(91, 1'000'000'000))).lines, IsEmpty())
      << "a claimed count allocates no memory";
}

TEST(UffTraceLines, AreWrittenAsConnectedPaths) {
  const auto sets = uff_trace_line_sets({{0, 1}, {1, 2}, {4, 5}}, 1);
  EXPECT_THAT(sets, ElementsAre("         1         3        11\nNONE\n         1         2         3\n",
                                "         2         2        11\nNONE\n         5         6\n"));
}

class TraceLineFiles : public testing::Test {
 protected:
  TraceLineFiles() {
    record_.geometry = {{0, 0, 0}, {kNan, kNan, kNan}, {0.1, 0.25, -1}, {0.2, 0, 1e-7}};
    record_.trace_lines = {{0, 2}, {2, 3}, {3, 0}};
  }
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Record record_ = record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
  test::ScratchFolder folder_;
};

TEST_F(TraceLineFiles, AreKeptByEveryFormatThatHoldsThem) {
  for (const char* extension : {".h5", ".mat", ".uff", ".wav", ".rf64"}) {
    const std::string path = folder_.file(std::string("r") + extension),
                      again = folder_.file(std::string("s") + extension);
    write_record(path, record_, false);
    const Record read = open_record(path);
    EXPECT_EQ(read.trace_lines, record_.trace_lines) << extension;
    ASSERT_EQ(read.geometry.size(), 4U) << extension;
    EXPECT_TRUE(std::isnan(read.geometry[1][0])) << extension;
    EXPECT_EQ(read.geometry[2], record_.geometry[2]) << extension;
    EXPECT_EQ(open_record(path, {.sandboxed = true}).trace_lines, record_.trace_lines) << extension;
    write_record(again, read, false);
    EXPECT_TRUE(test::bytes_of(path) == test::bytes_of(again)) << extension;
    EXPECT_THAT(losses_of(path, record_), testing::Each(testing::Not(HasSubstr("lines")))) << extension;
  }
  EXPECT_THAT(losses_of("r.csv", record_), testing::Contains(HasSubstr("lines")));
}

TEST_F(TraceLineFiles, AreKeptWhenTheLastPointsHaveNoCoordinates) {
  record_.geometry.push_back({kNan, kNan, kNan});
  record_.trace_lines.push_back({3, 4});
  for (const char* extension : {".h5", ".mat", ".wav"}) {
    const std::string path = folder_.file(std::string("r") + extension);
    write_record(path, record_, false);
    EXPECT_EQ(open_record(path).trace_lines, record_.trace_lines) << extension;
  }
  const std::string path = folder_.file("r.uff");
  write_record(path, record_, false);
  EXPECT_EQ(open_record(path).trace_lines.size(), 3U) << "the universal file has no node of point 4 to draw to";
  EXPECT_THAT(losses_of(path, record_), testing::Contains("lines to points without coordinates"));
}

TEST_F(TraceLineFiles, AreReportedWhenTheyAreLost) {
  record_.geometry.assign(5000, {kNan, kNan, kNan});
  record_.geometry.back() = {1, 2, 3};
  record_.trace_lines = {{0, 4999}};
  const std::string path = folder_.file("r.wav");
  write_record(path, record_, false);
  EXPECT_THAT(open_record(path).geometry, IsEmpty());
  EXPECT_EQ(losses_of(path, record_).size(), 2U);
  record_.geometry = {{0.1, 90}, {0.2, 90}};
  record_.trace_lines = {{0, 1}};
  EXPECT_THAT(losses_of("r.uff", record_), testing::Contains("the lines between points"));
}

TEST_F(TraceLineFiles, AreRefusedUnlessTheyConnectExistingPoints) {
  for (const std::vector<double>& numbers : {std::vector<double>{0, 4}, {0, -1}, {0, 0.5}, {0, kNan}}) {
    test::Hdf5Builder(folder_.file("bad.h5"))
        .numbers("", "fs", {1000})
        .ramp("force", {1, 8})
        .ramp("accel", {1, 1, 8})
        .ramp("geometry", {4, 3})
        .values("trace_lines", {1, 2}, numbers);
    EXPECT_THAT(input_error_of([&] { open_record(folder_.file("bad.h5")); }), HasSubstr("bad.h5: /trace_lines"));
  }
}

}  // namespace percuss::acquire::uff_trace_lines_test
