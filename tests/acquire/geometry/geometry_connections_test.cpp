#include "acquire/geometry/geometry_connections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::acquire::geometry_connections_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using Line = std::array<int, 2>;
using Face = std::vector<int>;

const std::string kPoints = "point,x_m,y_m,z_m\n0,0,0,0\n1,1,0,0\n2,1,1,0\n3,0,1,0\n";

TEST(GeometryConnections, ReadsRowsOfLinesAndFaces) {
  const Geometry geometry =
      parse_geometry(kPoints + "line,0,1,2\nLINE,2,1\nface,0,1,2,3\n# a comment\nface,0 1 3\n", "g");
  ASSERT_EQ(geometry.points.size(), 4U);
  EXPECT_THAT(geometry.lines, ElementsAre(Line{0, 1}, Line{1, 2})) << "each line once";
  EXPECT_THAT(geometry.faces, ElementsAre(Face{0, 1, 2, 3}, Face{0, 1, 3}));
}

TEST(GeometryConnections, ReadsColumnsOfLinesAndFaces) {
  const Geometry geometry =
      parse_geometry("point;x_m;y_m;z_m;lines;faces\n0;0;0;0;1 3;1 2 / 2 3\n1;1;0;0;;\n2;1;1;0;1\n3;0;1;0;;\n", "g");
  EXPECT_THAT(geometry.lines, ElementsAre(Line{0, 1}, Line{0, 3}, Line{2, 1}));
  EXPECT_THAT(geometry.faces, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3}));
}

TEST(GeometryConnections, MayNamePointsListedLater) {
  const Geometry geometry = parse_geometry("point,position_m,angle_deg\nline,4,7\n4,0,0\n7,1,0\n", "g");
  EXPECT_THAT(geometry.lines, ElementsAre(Line{4, 7}));
  EXPECT_TRUE(geometry.tube);
}

TEST(GeometryConnections, AreAbsentWhereNoneIsStated) {
  const Geometry geometry = parse_geometry(kPoints, "g");
  EXPECT_TRUE(geometry.lines.empty());
  EXPECT_TRUE(geometry.faces.empty());
}

TEST(GeometryConnections, RejectsWhatConnectsNoPoints) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"line,0,9\n", "point 9 is connected, but not listed (g: line 6)"},
      {"line,0\n", "a line with fewer than two points"},
      {"face,0,1\n", "a face with fewer than three corners"},
      {"face,0,1,1\n", "point 1 is connected with itself"},
      {"line,2,2\n", "point 2 is connected with itself"},
      {"line,0,-1\n", "\"-1\" is not a point number"},
      {"line,0,1.5\n", "\"1.5\" is not a point number"},
      {"face,0,1,99999999999999999999\n", "is not a point number"},
      {"line,0,\x1b[31m\n", "is not a point number"},
  };
  for (const auto& [row, message] : wrong) {
    const std::string text = kPoints + row;
    EXPECT_THAT(input_error_of([&] { parse_geometry(text, "g"); }), HasSubstr(message)) << row;
  }
  std::string many = "face";
  for (int i = 0; i < 200; ++i) many += "," + std::to_string(i % 4);
  EXPECT_THAT(input_error_of([&] { parse_geometry(kPoints + many + "\n", "g"); }), HasSubstr("more than 100 corners"));
}

}  // namespace percuss::acquire::geometry_connections_test
