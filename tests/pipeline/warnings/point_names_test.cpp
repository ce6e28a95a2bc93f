#include "pipeline/warnings/point_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace percuss::pipeline::point_names_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

// A record of files, each of which is a point, or has the stated point.
acquire::Record record_of(const std::vector<std::string>& paths, const std::vector<int>& points = {}) {
  acquire::Record record;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    record.files.push_back({.path = paths[i]});
    record.rows.push_back({.samples = 8, .file = i, .point = points.empty() ? static_cast<int>(i) : points[i]});
  }
  return record;
}

std::set<int> numbers(int first, int count) {
  std::set<int> out;
  for (int i = 0; i < count; ++i) out.insert(first + i);
  return out;
}

std::vector<std::string> files(const std::vector<int>& of) {
  std::vector<std::string> out;
  for (const int number : of) out.push_back("a/P" + std::to_string(number) + ".csv");
  return out;
}

std::vector<std::string> names_of(const acquire::Record& record, const std::set<int>& geometry = {}) {
  const PointNames names(record, record.points(), geometry);
  std::vector<std::string> out;
  for (const int point : record.points()) out.push_back(names.name(point));
  return out;
}

TEST(PointNames, ReadTheNumbersInNames) {
  EXPECT_THAT(numbers_in_names({"a/P1.csv", "a/P2.csv", "a/P10.csv"}), Optional(ElementsAre(1, 2, 10)));
  EXPECT_THAT(numbers_in_names({"2024_beam_pt01.h5", "2024_beam_pt02.h5"}), Optional(ElementsAre(1, 2)));
  EXPECT_THAT(numbers_in_names({"7", "9"}), Optional(ElementsAre(7, 9)));
  for (const std::vector<std::string>& names :
       std::vector<std::vector<std::string>>{{},
                                             {"P1.csv"},
                                             {"P1.csv", "P01.csv"},
                                             {"P1.csv", "Q2.csv"},
                                             {"P1.csv", "P2b.csv"},
                                             {"r1_P1.csv", "r2_P2.csv"},
                                             {"P1.csv", "P1.csv"},
                                             {"P20240101120000.csv", "P20240101120100.csv"}})
    EXPECT_FALSE(numbers_in_names(names).has_value()) << testing::PrintToString(names);
}

TEST(PointNames, ReadTheNumbersThatTheGeometryHas) {
  const std::vector<std::string> counted{"M151_P1.csv", "M154_P2.csv", "M160_P4.csv"};
  EXPECT_THAT(numbers_in_names(counted, numbers(1, 4)), Optional(ElementsAre(1, 2, 4)));
  EXPECT_THAT(numbers_in_names({"P1_M1.csv", "P2_M2.csv"}, numbers(1, 2)), Optional(ElementsAre(1, 2))) << "equal";
  EXPECT_FALSE(numbers_in_names(counted).has_value());
  EXPECT_FALSE(numbers_in_names(counted, numbers(1, 3)).has_value()) << "none fits";
  EXPECT_FALSE(numbers_in_names(counted, numbers(1, 200)).has_value()) << "both fit";
  EXPECT_FALSE(numbers_in_names({"M1_P1.csv", "M2_P1.csv", "M2_P2.csv"}, numbers(1, 2)).has_value()) << "not different";
  // A single number that differs counts, even if the geometry lacks it.
  EXPECT_THAT(numbers_in_names({"2024_P1.csv", "2024_P7.csv"}, numbers(1, 4)), Optional(ElementsAre(1, 7)));
  EXPECT_EQ(geometry_numbers(numbers(1, 4), numbers(0, 3), counted), GeometryNumbers::file_names);
  EXPECT_THAT(names_of(record_of(counted), numbers(1, 4)),
              ElementsAre("1 (M151_P1.csv)", "2 (M154_P2.csv)", "4 (M160_P4.csv)"));
}

TEST(PointNames, FindFilesThatArePoints) {
  const acquire::Record record = record_of({"P1.csv", "P2.csv", "P3.csv"});
  EXPECT_THAT(files_of_points(record, record.points()), ElementsAre("P1.csv", "P2.csv", "P3.csv"));
  for (const std::vector<int>& points : std::vector<std::vector<int>>{{0, 0, 0}, {1, 0, 2}, {0, 1, 3}}) {
    const acquire::Record other = record_of({"P1.csv", "P2.csv", "P3.csv"}, points);
    EXPECT_THAT(files_of_points(other, other.points()), IsEmpty()) << testing::PrintToString(points);
  }
  const acquire::Record arrays = record_of({"arrays", "arrays", "arrays"});
  EXPECT_THAT(files_of_points(arrays, arrays.points()), IsEmpty());
}

TEST(PointNames, FindFilesThatAreHitsOfPoints) {
  const std::vector<std::string> paths{"a/P1_1.csv", "a/P1_2.csv", "a/P2_1.csv", "a/P2_2.csv"};
  const acquire::Record record = record_of(paths, {0, 0, 1, 1});
  EXPECT_THAT(files_of_points(record, record.points()), ElementsAre("a/P1", "a/P2"));
  EXPECT_THAT(names_of(record), ElementsAre("1 (P1)", "2 (P2)"));
  const acquire::Record other = record_of(paths, {0, 1, 0, 1});
  EXPECT_THAT(files_of_points(other, other.points()), IsEmpty()) << "the files state other points";
}

// P7.csv is missing: the point of the index 6 is P8.
TEST(PointNames, AreTheNumbersInTheNamesOfFiles) {
  const acquire::Record record = record_of(files({1, 2, 3, 4, 5, 6, 8}));
  EXPECT_THAT(names_of(record), ElementsAre("1 (P1.csv)", "2 (P2.csv)", "3 (P3.csv)", "4 (P4.csv)", "5 (P5.csv)",
                                            "6 (P6.csv)", "8 (P8.csv)"));
  EXPECT_EQ(names_of(record, numbers(1, 8)), names_of(record));
  const PointNames names(record, record.points());
  EXPECT_EQ(names.number(6), 8);
  EXPECT_EQ(names.list({6}, 8), "point 8 (P8.csv)");
  EXPECT_EQ(names.list({0, 6}, 8), "points 1 (P1.csv), 8 (P8.csv)");
  EXPECT_EQ(names.list({0, 5, 6}, 1), "points 1 (P1.csv) and 2 more");
}

TEST(PointNames, AreTheGeometrysNumbersWhereFilesHaveNone) {
  const acquire::Record record = record_of({"corner.csv", "edge.csv"});
  EXPECT_THAT(names_of(record), ElementsAre("0 (corner.csv)", "1 (edge.csv)"));
  EXPECT_THAT(names_of(record, {1, 2}), ElementsAre("1 (corner.csv)", "2 (edge.csv)"));
  const acquire::Record times = record_of({"t_101502.csv", "t_101733.csv"});
  EXPECT_THAT(names_of(times, {1, 2}), ElementsAre("1 (t_101502.csv)", "2 (t_101733.csv)"));
}

TEST(PointNames, AreTheRecordsNumbersOrSayThatTheyAreTheGeometrys) {
  acquire::Record record;
  record.files = {{.path = "plate.h5"}};
  for (int p = 0; p < 3; ++p) record.rows.push_back({.point = p});
  EXPECT_THAT(names_of(record), ElementsAre("0", "1", "2"));
  EXPECT_THAT(names_of(record, {0, 1, 2}), ElementsAre("0", "1", "2"));
  EXPECT_THAT(names_of(record, {1, 2, 3}), ElementsAre("1 of the geometry", "2 of the geometry", "3 of the geometry"));
  EXPECT_EQ(PointNames(record, record.points(), {1, 2, 3}).list({0, 2}, 8), "points 1, 3 of the geometry");
  EXPECT_EQ(PointNames().name(7), "7");
  record.motions = {{.point = 0, .place = 0}};
  EXPECT_THAT(names_of(record, {1, 2, 3}), ElementsAre("0", "1", "2")) << "a geometry numbers places";
}

TEST(GeometryNumbers, FollowTheNamesOfTheFiles) {
  const auto of = [](const std::vector<int>& files_of, const std::set<int>& geometry) {
    return geometry_numbers(geometry, numbers(0, static_cast<int>(files_of.size())), files(files_of));
  };
  EXPECT_EQ(of({1, 2, 3}, {1, 2, 3}), GeometryNumbers::file_names);
  EXPECT_EQ(of({3, 1, 2}, {1, 2, 3}), GeometryNumbers::file_names) << "in any order";
  EXPECT_EQ(of({1, 3}, {1, 2, 3}), GeometryNumbers::file_names) << "a missing file";
  EXPECT_EQ(of({0, 1, 2}, {0, 1, 2, 3}), GeometryNumbers::file_names);
  EXPECT_EQ(of({1, 2, 4}, {1, 2, 3}), GeometryNumbers::contradicted);
  EXPECT_EQ(of({2, 3, 4}, {1, 2, 3}), GeometryNumbers::contradicted) << "P2 is no first point";
  EXPECT_EQ(of({13, 14}, {1, 2, 3}), GeometryNumbers::contradicted);
  // The files count from 1 and the geometry from 0, or the reverse: none is missing.
  EXPECT_EQ(of({1, 2, 3}, {0, 1, 2}), GeometryNumbers::record);
  EXPECT_EQ(of({0, 1, 2}, {1, 2, 3}), GeometryNumbers::from_one);
  EXPECT_EQ(of({3, 1, 2}, {0, 1, 2}), GeometryNumbers::contradicted);
  EXPECT_EQ(of({1, 2}, {0, 2, 3}), GeometryNumbers::contradicted);
  // Times of a day.
  EXPECT_EQ(of({101502, 101733}, {1, 2}), GeometryNumbers::from_one);
  EXPECT_EQ(of({101502, 101733}, {0, 1}), GeometryNumbers::record);
  EXPECT_EQ(of({101502, 101733}, {1, 2, 3}), GeometryNumbers::contradicted) << "a missing file";
}

TEST(NamedFiles, AreHitsWhereTheGeometryFitsTheGroups) {
  std::vector<std::string> paths;
  for (int p = 1; p <= 4; ++p) {
    for (int h = 1; h <= 3; ++h) paths.push_back("P" + std::to_string(p) + "_" + std::to_string(h) + ".csv");
  }
  const std::vector<acquire::FilesOfHits> groups = acquire::files_of_hits(paths);
  ASSERT_EQ(groups.size(), 4U);
  const auto judged = [&](const std::set<int>& geometry) { return judge_named_files(paths, groups, geometry); };
  EXPECT_EQ(judged(numbers(1, 4)), NamedFiles::hits);
  EXPECT_EQ(judged(numbers(0, 4)), NamedFiles::hits);
  EXPECT_EQ(judged(numbers(1, 7)), NamedFiles::hits) << "a part of the points";
  EXPECT_EQ(judged(numbers(1, 3)), NamedFiles::hits) << "the geometry lacks a point of either kind";
  EXPECT_EQ(judged({}), NamedFiles::undecided);
  EXPECT_EQ(judged(numbers(1, 12)), NamedFiles::undecided);
  EXPECT_EQ(judged(numbers(1, 40)), NamedFiles::undecided);
  EXPECT_EQ(judge_named_files(paths, {}, numbers(1, 4)), NamedFiles::points);
}

TEST(TwoNumbers, AreReadAsTheGeometryAllows) {
  std::vector<std::string> paths;
  for (int p = 1; p <= 4; ++p) {
    for (int h = 1; h <= 3; ++h) paths.push_back("P" + std::to_string(p) + "S" + std::to_string(h) + ".csv");
  }
  const auto judged = [&](const std::set<int>& geometry) {
    return judge_two_numbers(paths, acquire::groupings_by_two_numbers(paths), geometry);
  };
  ASSERT_EQ(judged({}).groupings.size(), 1U);
  EXPECT_EQ(judged({}).groupings.front().size(), 4U) << "the first number";
  EXPECT_FALSE(judged({}).certain);
  for (const std::set<int>& geometry : {numbers(1, 4), numbers(0, 4)}) {
    ASSERT_EQ(judged(geometry).groupings.size(), 1U);
    EXPECT_EQ(judged(geometry).groupings.front().size(), 4U);
    EXPECT_TRUE(judged(geometry).certain);
  }
  EXPECT_EQ(judged(numbers(1, 3)).groupings.front().size(), 3U) << "three points were struck in four runs";
  EXPECT_EQ(judged(numbers(1, 7)).groupings.size(), 2U) << "a part of the points";
  EXPECT_FALSE(judged(numbers(1, 7)).certain);
  EXPECT_FALSE(judged(numbers(1, 40)).certain) << "each file may be a point";
  EXPECT_TRUE(judged(numbers(1, 12)).groupings.empty()) << "each file is a point";
  EXPECT_TRUE(judged(numbers(8, 2)).groupings.empty());
}

TEST(PointNames, FindFilesWithTwoNumbersInTheirNames) {
  const acquire::Record record = record_of(
      {"S1_P01.csv", "S1_P02.csv", "S1_P03.csv", "S2_P01.csv", "S2_P02.csv", "S2_P03.csv"}, {0, 1, 2, 0, 1, 2});
  EXPECT_THAT(names_of(record, numbers(1, 3)), ElementsAre("1 (P01)", "2 (P02)", "3 (P03)"));
}

TEST(NamedAsPoints, AreNamesWithTheNumbersOfPoints) {
  EXPECT_TRUE(named_as_points({"P1.csv", "P2.csv"}));
  EXPECT_TRUE(named_as_points({"P1_hit1.csv", "P1_hit2.csv", "P2_hit1.csv", "P2_hit2.csv"}));
  EXPECT_FALSE(named_as_points({"hit1.csv", "hit2.csv"}));
  EXPECT_FALSE(named_as_points({"before.csv", "after.csv"}));
}

}  // namespace percuss::pipeline::point_names_test
