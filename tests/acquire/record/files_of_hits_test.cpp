#include "acquire/record/files_of_hits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace percuss::acquire::files_of_hits_test {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> stems_of(const std::vector<std::string>& paths) {
  std::vector<std::string> out;
  for (const FilesOfHits& group : files_of_hits(paths)) out.push_back(group.stem);
  return out;
}

TEST(FilesOfHits, GroupNamesThatDifferInTheirLastNumber) {
  const std::vector<FilesOfHits> groups =
      files_of_hits({"a/P1_1.csv", "a/P1_2.csv", "a/P2_1.csv", "a/P2_2.csv", "a/P10_1.csv"});
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].stem, "a/P1");
  EXPECT_THAT(groups[0].files, ElementsAre(0U, 1U));
  EXPECT_THAT(groups[1].files, ElementsAre(2U, 3U));
  EXPECT_EQ(groups[2].stem, "a/P10");
  EXPECT_THAT(groups[2].files, ElementsAre(4U)) << "a hit was deleted";
}

TEST(FilesOfHits, KnowTheWaysToNumberHits) {
  for (const std::vector<std::string>& paths :
       std::vector<std::vector<std::string>>{{"P1-1.csv", "P1-2.csv", "P2-1.csv", "P2-2.csv"},
                                             {"P1 (1).csv", "P1 (2).csv", "P2 (1).csv", "P2 (2).csv"},
                                             {"P1_hit1.csv", "P1_hit2.csv", "P2_hit1.csv", "P2_hit2.csv"},
                                             {"P1_Hit_1.csv", "P1_Hit_2.csv", "P2_Hit_1.csv", "P2_Hit_2.csv"},
                                             {"P1h1.h5", "P1h2.h5", "P2h1.h5", "P2h2.h5"}})
    EXPECT_THAT(stems_of(paths), ElementsAre("P1", "P2")) << paths.front();
  EXPECT_THAT(stems_of({"P1_1.csv", "P2_1.csv", "P1_2.csv", "P2_2.csv"}), ElementsAre("P1", "P2")) << "in any order";
}

TEST(FilesOfHits, LeaveOtherNamesAlone) {
  for (const std::vector<std::string>& paths : std::vector<std::vector<std::string>>{
           {},
           {"P1.csv", "P2.csv", "P3.csv"},
           {"P_1.csv", "P_2.csv", "P_3.csv"},                      // one name: points
           {"A1.csv", "A2.csv", "B1.csv", "B2.csv"},               // a grid of letters and numbers
           {"r1_P1.csv", "r1_P2.csv", "r2_P1.csv", "r2_P2.csv"},   // runs of points
           {"hit1.csv", "hit2.csv"},                               // no name of a point
           {"P1_1.csv", "P2_1.csv", "P3_1.csv"},                   // one file for each name
           {"P1_1.csv", "P1_2.csv", "P2_1.csv", "corner.csv"},     // a name without a number
           {"P1_1.csv", "P1_2.csv", "P2_3.csv", "P2_4.csv"},       // numbers that go on
           {"P1_1.csv", "P1_01.csv", "P2_1.csv", "P2_01.csv"},     // equal numbers
           {"p0.25.csv", "p0.50.csv", "p1.25.csv", "p1.50.csv"}})  // positions
    EXPECT_THAT(files_of_hits(paths), IsEmpty()) << testing::PrintToString(paths);
}

std::vector<std::vector<std::string>> stems_by_two_numbers(const std::vector<std::string>& paths) {
  std::vector<std::vector<std::string>> out;
  for (const auto& groups : groupings_by_two_numbers(paths)) {
    out.emplace_back();
    for (const FilesOfHits& group : groups) out.back().push_back(group.stem);
  }
  return out;
}

TEST(GroupingsByTwoNumbers, KnowAnyWords) {
  for (const std::string word : {"_Schlag", "_impact", "_run", "-S", "/blow "}) {
    std::vector<std::string> paths;
    for (const std::string name : {"a/P1", "a/P2", "a/P3"}) {
      for (const std::string hit : {"1", "2"}) paths.push_back(name + word + hit + ".h5");
    }
    const auto groupings = groupings_by_two_numbers(paths);
    ASSERT_EQ(groupings.size(), 2U) << word;
    ASSERT_EQ(groupings[0].size(), 3U) << "the number of the point stands first";
    EXPECT_EQ(groupings[0][1].stem, "a/P2");
    EXPECT_THAT(groupings[0][1].files, ElementsAre(2U, 3U));
    EXPECT_THAT(groupings[1].front().files, ElementsAre(0U, 2U, 4U));
  }
  EXPECT_THAT(
      stems_by_two_numbers({"d7/Schlag1_Punkt01.csv", "d7/Schlag1_Punkt02.csv", "d7/Schlag1_Punkt03.csv",
                            "d7/Schlag2_Punkt01.csv", "d7/Schlag2_Punkt02.csv", "d7/Schlag2_Punkt03.csv"}),
      ElementsAre(ElementsAre("d7/Schlag1", "d7/Schlag2"), ElementsAre("d7/Punkt01", "d7/Punkt02", "d7/Punkt03")));
  EXPECT_THAT(stems_by_two_numbers({"P1S1.h5", "P1S2.h5", "P1S3.h5", "P2S1.h5", "P2S2.h5", "P2S3.h5", "P3S2.h5"}),
              ElementsAre(ElementsAre("P1", "P2", "P3")))
      << "hits were deleted";
}

TEST(GroupingsByTwoNumbers, NeedAGridOfTwoNumbers) {
  for (const std::vector<std::string>& paths : std::vector<std::vector<std::string>>{
           {},
           {"P1.csv", "P2.csv", "P3.csv", "P4.csv"},                                      // one number
           {"M151_P1.csv", "M154_P2.csv", "M160_P4.csv", "M161_P5.csv"},                  // a count of captures
           {"A1.csv", "A2.csv", "B1.csv", "B2.csv"},                                      // other texts
           {"P1S1.csv", "P1S2.csv", "P2S3.csv", "P2S4.csv"},                              // numbers that go on
           {"P1S1.csv", "P1S01.csv", "P2S1.csv", "P2S01.csv"},                            // equal numbers
           {"P1S20240131.csv", "P1S20240201.csv", "P2S20240131.csv", "P2S20240201.csv"},  // dates
           {"P1S1M1.csv", "P1S2M2.csv", "P2S1M3.csv", "P2S2M4.csv"}})                     // three numbers
    EXPECT_THAT(groupings_by_two_numbers(paths), IsEmpty()) << testing::PrintToString(paths);
}

TEST(FilesCalledHits, AreGroupedByFolderAndName) {
  const std::vector<std::string> paths{"A/hit1.wav", "A/hit2.wav", "A/notes.csv", "B/Hit_1.wav",   "B/Hit_2.wav",
                                       "hit1.h5",    "hit2.h5",    "C_blow1.h5",  "C_blow (2).h5", "C_hit1.h5"};
  const std::vector<FilesOfHits> groups = files_called_hits(paths);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].stem, "A/");
  EXPECT_THAT(groups[0].files, ElementsAre(0U, 1U));
  EXPECT_EQ(groups[1].stem, "B/");
  EXPECT_EQ(groups[2].stem, "");
  EXPECT_EQ(groups[3].stem, "C");
  EXPECT_THAT(groups[3].files, ElementsAre(7U, 8U)) << "C_hit1 is of another word";
}

TEST(FilesCalledHits, HaveAWordForAHitAndDifferentNumbers) {
  EXPECT_THAT(files_called_hits({"bat1.h5", "bat2.h5", "P1_1.h5", "P1_2.h5", "h1.h5", "h2.h5"}), IsEmpty());
  EXPECT_THAT(files_called_hits({"white1.h5", "white2.h5", "whit1.h5", "whit2.h5"}), IsEmpty());
  EXPECT_THAT(files_called_hits({"hit1.h5", "hit1.csv", "hit2.h5"}), IsEmpty()) << "which of the two is hit 1?";
  EXPECT_THAT(files_called_hits({"hit1.h5"}), IsEmpty());
  EXPECT_THAT(files_called_hits({"hit20240131.h5", "hit20240201.h5"}), IsEmpty()) << "dates";
}

}  // namespace percuss::acquire::files_of_hits_test
