#include "acquire/record/frf_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::acquire::frf_record_test {

using testing::HasSubstr;
using testing::SizeIs;

// Two channels, one point, lines at 0, 1, 2 Hz.
FrfRecord small_frfs() {
  FrfRecord out;
  out.files = {{.path = "x.csv"}};
  out.lines = lines_from_frequencies({0, 1, 2}, "x.csv");
  out.notes = {"assumed"};
  for (std::size_t c = 0; c < 2; ++c) {
    out.accel.push_back({.name = "accel " + std::to_string(c + 1)});
    out.frfs.push_back({.point = 0, .channel = c, .frf = {.value = std::vector<Complex>(3, Complex(1, 0))}});
  }
  return out;
}

TEST(JoinFrfs, MakesEveryFileAPoint) {
  std::vector<FrfRecord> files(3, small_frfs());
  const FrfRecord all = join_frfs(files);
  ASSERT_THAT(all.frfs, SizeIs(6));
  EXPECT_EQ(all.frfs[5].point, 2);
  EXPECT_EQ(all.frfs[5].channel, 1U);
  EXPECT_THAT(all.notes, SizeIs(1)) << "a note on every file is given once";
  EXPECT_THAT(all.files, SizeIs(3));
}

TEST(JoinFrfs, NamesTheFileThatANoteConcerns) {
  std::vector<FrfRecord> files(3, small_frfs());
  files[0].notes.emplace_back("only here");
  EXPECT_THAT(join_frfs(files).notes, testing::ElementsAre(Message("assumed"), Message("x.csv: only here")));
}

TEST(JoinFrfs, RefusesPointNumbersThatBecomeTooLarge) {
  FrfRecord far = small_frfs(), other = small_frfs();
  for (PointFrf& frf : far.frfs) frf.point = 1'000'000'000;
  other.files[0].path = "other.csv";
  EXPECT_THAT(test::input_error_of([&] {
                join_frfs({far, other});
              }),
              HasSubstr("1000000001 is not a point number (other.csv)"));
}

TEST(JoinFrfs, RefusesNoFiles) {
  EXPECT_THAT(test::input_error_of([] { join_frfs({}); }), HasSubstr("nothing to join"));
}

TEST(JoinFrfs, RefusesOtherLinesAndNamesTheFile) {
  const FrfRecord first = small_frfs();
  FrfRecord other = first;
  other.files[0].path = "other.csv";
  other.lines = lines_from_frequencies({0, 2, 4}, "other.csv");
  EXPECT_THAT(test::input_error_of([&] { join_frfs({first, other}); }), HasSubstr("other.csv"));
}

}  // namespace percuss::acquire::frf_record_test
