#include "acquire/geometry/geometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::geometry_test {

using std::numbers::pi;
using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kRounding = 1e-12;

std::string rejection_of(const std::string& text) {
  return input_error_of([&] { parse_geometry(text, "g.csv"); });
}

TEST(Geometry, ExampleReadsBack) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("g.csv"), geometry_example());
  const Geometry geometry = read_geometry(folder.file("g.csv"));
  ASSERT_EQ(geometry.points.size(), 24U);
  EXPECT_TRUE(geometry.tube);
  EXPECT_EQ(geometry.points[9].point, 9);
  EXPECT_DOUBLE_EQ(geometry.points[9].position_m, 0.102);
  EXPECT_DOUBLE_EQ(geometry.points[9].angle_rad, pi / 4);
  EXPECT_DOUBLE_EQ(geometry.points[9].radius_m, 0.0333);
}

TEST(Geometry, KnowsUnitsInNamesAndInALineOfTheirOwn) {
  for (const char* text :
       {"point,position_in,angle_rad\n3,2,1.5\n", "angle (rad);Point;position [in]\n1,5;3;2\n",
        "point\tposition\tangle\n\tin\trad\n3\t2\t1.5\n", "point position_mm theta_rad\n3 50.8 1.5\n",
        "\xEF\xBB\xBF# a survey\r\npoint,Position_cm,angle_rad,remark\r\n\r\n3,5.08,1.5,\r\n"}) {
    const Geometry geometry = parse_geometry(text, "g.csv");
    ASSERT_EQ(geometry.points.size(), 1U) << text;
    EXPECT_EQ(geometry.points[0].point, 3) << text;
    EXPECT_NEAR(geometry.points[0].position_m, 2 * kInch_m, kRounding) << text;
    EXPECT_NEAR(geometry.points[0].angle_rad, 1.5, kRounding) << text;
  }
}

TEST(Geometry, KeepsCoordinatesThatFormNoTube) {
  const Geometry plate = parse_geometry("point,x_mm,y_mm,z_mm\n0,0,0,0\n1,100,0,0\n2,0,100,0\n3,100,100,0\n", "g.csv");
  EXPECT_FALSE(plate.tube);
  EXPECT_NEAR((*plate.points[3].xyz_m)[1], 0.1, kRounding);
}

TEST(Geometry, ReadsDirectionsOfAnyLength) {
  using Direction = std::array<double, 3>;
  const Geometry given =
      parse_geometry("point,x_m,y_m,dx,dy,dz\n0,0,0,0,0,-2\n1,1,0,3,0,4\n2,1,1,,,\n3,0,1,,-1,\n", "g.csv");
  ASSERT_EQ(given.points.size(), 4U);
  EXPECT_EQ(given.points[0].along, Direction({0, 0, -1}));
  ASSERT_TRUE(given.points[1].along);
  EXPECT_NEAR(given.points[1].along->at(0), 0.6, kRounding);
  EXPECT_NEAR(given.points[1].along->at(2), 0.8, kRounding);
  EXPECT_FALSE(given.points[2].along) << "empty cells";
  EXPECT_EQ(given.points[3].along, Direction({0, -1, 0}));
  const Geometry named = parse_geometry("point;x_m;Direction\n0;0;-x\n1;1;+Z\n2;2;y\n3;3;\n4;4\n5;5;Z-\n", "g.csv");
  ASSERT_EQ(named.points.size(), 6U);
  EXPECT_EQ(named.points[0].along, Direction({-1, 0, 0}));
  EXPECT_EQ(named.points[1].along, Direction({0, 0, 1}));
  EXPECT_EQ(named.points[2].along, Direction({0, 1, 0}));
  EXPECT_FALSE(named.points[3].along || named.points[4].along);
  EXPECT_EQ(named.points[5].along, Direction({0, 0, -1}));
  const Geometry units = parse_geometry("point,x,dz\n,mm,\n1,5,1\n", "g.csv");
  EXPECT_EQ(units.points[0].along, Direction({0, 0, 1})) << "a line of units";
}

TEST(Geometry, RefusesOtherDirections) {
  EXPECT_THAT(rejection_of("point,x_m,direction\n0,0,+w\n"),
              AllOf(HasSubstr("unknown direction \"+w\""), HasSubstr("write +x, -x")));
  EXPECT_THAT(rejection_of("point,x_m,direction\n0,0,-\n"), HasSubstr("unknown direction \"-\""));
  EXPECT_THAT(rejection_of("point,x_m,dx,dy\n0,0,0,0\n"), HasSubstr("the direction dx, dy, dz has no length"));
  EXPECT_THAT(rejection_of("point,x_m,dx\n0,0,up\n"), HasSubstr("dx \"up\" is"));
  EXPECT_THAT(rejection_of("point,x_m,dx,direction\n0,0,1,+x\n"), HasSubstr("two kinds of directions"));
}

TEST(Geometry, TakesAbsentCoordinatesAsZero) {
  const Geometry plate = parse_geometry("point,x_m,y_m\n1,0.1,0.2\n2,0.3,0.2\n", "g.csv");
  EXPECT_FALSE(plate.tube);
  EXPECT_EQ(*plate.points[1].xyz_m, (std::array<double, 3>{0.3, 0.2, 0}));
  const Geometry line = parse_geometry("point,position_mm\n0,100\n1,250\n", "g.csv");
  EXPECT_FALSE(line.tube);
  EXPECT_NEAR((*line.points[1].xyz_m)[0], 0.25, kRounding);
}

TEST(Geometry, FindsTheTubeInCoordinatesAboutAnyAxis) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Geometry geometry;
    for (int i = 0; i < 24; ++i) {
      const int ring = i / 6;
      const double angle = pi / 3 * (i % 6) + 0.1, radius = 0.03 + 0.002 * ring;  // tapered
      std::array<double, 3> xyz{};
      xyz[axis] = 0.05 * ring;
      xyz[(axis + 1) % 3] = 1 + radius * std::cos(angle);
      xyz[(axis + 2) % 3] = -2 + radius * std::sin(angle);
      geometry.points.push_back({.point = i, .xyz_m = xyz});
    }
    tube_from_coordinates(geometry);
    ASSERT_TRUE(geometry.tube) << axis;
    for (int i = 0; i < 24; ++i) {
      const int ring = i / 6;
      const GeometryPoint& p = geometry.points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(p.position_m, 0.05 * ring, kRounding);
      EXPECT_NEAR(std::remainder(p.angle_rad - pi / 3 * (i % 6) - 0.1, 2 * pi), 0, kRounding);
      EXPECT_NEAR(p.radius_m, 0.03 + 0.002 * ring, kRounding);
    }
  }
}

TEST(Geometry, ComesFromTheRecordItself) {
  const auto tube = geometry_of_record({{0.1, 90}, {0.2, 180}});
  ASSERT_TRUE(tube && tube->tube);
  EXPECT_EQ(tube->points[1].point, 1);
  EXPECT_DOUBLE_EQ(tube->points[0].angle_rad, pi / 2);
  const auto points = geometry_of_record({{0, 1, 0}, {0, -1, 0}});
  ASSERT_TRUE(points);
  EXPECT_FALSE(points->tube);
  EXPECT_FALSE(geometry_of_record({}));
  EXPECT_FALSE(geometry_of_record({{1}}));
}

TEST(Geometry, TakesLengthsWithoutAUnitAsMetres) {
  const Geometry geometry = parse_geometry("point,x,y\n0,0,0\n1,0.5,0\n2,0.5,0.25\n", "g.csv");
  EXPECT_TRUE(geometry.unit_assumed);
  EXPECT_EQ(geometry.points.at(2).xyz_m, (std::array<double, 3>{0.5, 0.25, 0}));
  EXPECT_TRUE(parse_geometry("point,position,angle_deg\n0,0.1,0\n", "g.csv").unit_assumed);
  EXPECT_FALSE(parse_geometry("point,x_m,y_m\n0,120,0\n", "g.csv").unit_assumed);
  EXPECT_FALSE(parse_geometry("point,x,y\n,mm,mm\n0,120,0\n", "g.csv").unit_assumed);
}

TEST(Geometry, NamesLineAndRemedyOfAnError) {
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,0.1,zero\n"),
              AllOf(HasSubstr("angle \"zero\" is not a number (g.csv: line 2)"), HasSubstr("; write a number")));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,0.1,0\n\n0,0.2,0\n"),
              HasSubstr("point 0 is listed twice (g.csv: line 4)"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0.5,0.1,0\n"),
              HasSubstr("0.5 is not a point number (g.csv: line 2)"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n-1,0.1,0\n"), HasSubstr("-1 is not a point number"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,0.1\n"), HasSubstr("no cell for angle (g.csv: line 2)"));
  EXPECT_THAT(rejection_of("point,position_m,angle\n0,0.1,0\n"), HasSubstr("no unit for angle (g.csv: line 1)"));
  EXPECT_THAT(rejection_of("point,x_mm,y\n0,0.1,0\n"),
              AllOf(HasSubstr("no unit for y (g.csv: line 1)"), HasSubstr("call the column y_m, for instance")));
  EXPECT_THAT(
      rejection_of("point,x,y\n0,0,0\n1,120,0\n"),
      AllOf(HasSubstr("no unit for lengths of up to 120 (g.csv: line 1)"), HasSubstr("x_mm if they are in mm")));
  EXPECT_THAT(rejection_of("point,position\n0,12\n1,24\n"), HasSubstr("call the column position_mm"));
  EXPECT_THAT(rejection_of("point,position_kg,angle_deg\n0,0.1,0\n"), HasSubstr("g.csv: line 1"));
  EXPECT_THAT(rejection_of("point,x_m,angle_deg\n0,0.1,0\n"),
              HasSubstr("x, y, z (missing ones are 0), or position with or without angle"));
  EXPECT_THAT(rejection_of("x_m,y_m,z_m\n0,0.1,0\n"), HasSubstr("no column of points"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg,angle_rad\n0,0.1,0,0\n"),
              HasSubstr("two columns are called angle"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,nan,0\n"), HasSubstr("not finite"));
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,1e300,0\n"), HasSubstr("too large"));
}

TEST(Geometry, RefusesOtherTexts) {
  for (const std::string text :
       {"", "\n\n", "point,position_m,angle_deg\n", "0,1,2\n3,4,5\n", "{\"a\": 1}", "\x89HDF\r\n\x1a\n", ",,,\n,,,\n",
        "point\n1\n", "point,position_m,angle_deg\nm,m,deg\n"}) {
    EXPECT_THAT(rejection_of(text), HasSubstr("g.csv")) << text;
  }
  EXPECT_THAT(rejection_of(std::string("point,position_m,angle_deg\n0,\0,1\n", 33)), HasSubstr("not a text file"));
  EXPECT_THAT(rejection_of(std::string(std::size_t{17} << 20U, 'x')), HasSubstr("16 MiB"));
  const test::ScratchFolder folder;
  EXPECT_THAT(input_error_of([&] { read_geometry(folder.path()); }), HasSubstr("folder"));
  EXPECT_THAT(input_error_of([&] { read_geometry(folder.file("none")); }), HasSubstr("no such file"));
}

TEST(Geometry, ShowsNoControlCharactersOfTheFile) {
  EXPECT_THAT(rejection_of("point,position_m,angle_deg\n0,\x1b[2J,0\n"), testing::Not(HasSubstr("\x1b")));
}

}  // namespace percuss::acquire::geometry_test
