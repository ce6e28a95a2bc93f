#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "acquire/formats/mat/mat_completeness.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "support/files/mat_variables.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// The choice of variables of a MAT file by options, and headers in either byte order.
namespace percuss::acquire::mat_options_test {

using test::accel_mps2;
using test::force_N;
using test::input_error_of;
using test::mat_numbers;
using test::mat_record_of;
using test::mat_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A force of three samples, and two channels.
MatFile example(const std::vector<MatVariable>& more = {}) {
  MatFile file =
      mat_record_of({mat_numbers("force", {3, 1}, {1, 2, 3}), mat_numbers("accel", {3, 2}, {4, 5, 6, 7, 8, 9})});
  file.variables.insert(file.variables.end(), more.begin(), more.end());
  return file;
}

std::string refusal_of(const MatFile& file, const ReadOptions& options = {}) {
  return input_error_of([&] { open_mat(file, options); });
}

TEST(MatOptions, AreNotNeededWhereUnitsTellTheSignals) {
  const Record record =
      open_mat(mat_record_of({mat_numbers("x", {3, 1}, {4, 5, 6}), mat_text("x_unit", "m/s^2"),
                              mat_numbers("y_N", {3, 1}, {1, 2, 3}), mat_numbers("p_Pa", {3, 1}, {7, 8, 9})}));
  EXPECT_EQ(record.force.name, "y_N");
  EXPECT_THAT(force_N(record), ElementsAre(1, 2, 3));
  ASSERT_EQ(record.accel.size(), 1U);
  EXPECT_THAT(accel_mps2(record), ElementsAre(4, 5, 6));
}

TEST(MatOptions, NameColumnsOfMatricesOnly) {
  const MatFile file = mat_record_of({mat_numbers("data", {3, 2}, {7, 8, 9, 10, 11, 12}), mat_text("label", "abcdef"),
                                      mat_numbers("cube", {2, 2, 2}, {1, 2, 3, 4, 5, 6, 7, 8})});
  const Record record = open_mat(
      file,
      {.force_channel = "data(:,1)", .accel_channels = {"data(:,2)"}, .setup = {{.name = "data(:,1)", .sign = -1}}});
  EXPECT_THAT(force_N(record), ElementsAre(-7, -8, -9));
  EXPECT_THAT(accel_mps2(record), ElementsAre(10, 11, 12));
  for (const char* name : {"label(:,1)", "cube(:,1)", "none(:,1)", "data(:,0)", "data(:,3)"}) {
    EXPECT_THAT(refusal_of(file, {.force_channel = name, .accel_channels = {"data(:,2)"}}),
                HasSubstr("no column \"" + std::string(name) + "\""));
  }
}

TEST(MatOptions, DoNotMakeComplexNumbersReal) {
  MatVariable complex = mat_numbers("data", {3, 2}, {7, 8, 9, 10, 11, 12});
  complex.imaginary = {0, 1, 0, 1, 0, 1};
  const MatFile file = mat_record_of({complex, mat_numbers("plain", {3, 1}, {1, 2, 3})});
  EXPECT_THAT(refusal_of(file, {.force_channel = "data(:,1)", .accel_channels = {"plain"}}),
              HasSubstr("data(:,1) is complex"));
  EXPECT_THAT(refusal_of(file, {.force_channel = "plain", .accel_channels = {"data"}}), HasSubstr("data is complex"));
}

// The hammer was plugged into the first channel, and the first sensor into the hammer's.
TEST(MatOptions, ExchangeTheForceAndAChannelByTheirNames) {
  const MatFile two_dimensions = example({mat_numbers("angle_deg", {1, 2}, {0, 90})});
  // [hits, channels, samples] in MATLAB's order: the first dimension runs fastest.
  const MatFile three_dimensions = mat_record_of(
      {mat_numbers("force", {2, 3}, {1, 10, 2, 20, 3, 30}),
       mat_numbers("accel", {2, 2, 3}, {4, 40, 7, 70, 5, 50, 8, 80, 6, 60, 9, 90}), mat_text("force_unit", "N"),
       mat_text("accel_unit", "m/s^2"), mat_numbers("angle_deg", {1, 2}, {0, 90})});
  for (const MatFile& file : {two_dimensions, three_dimensions}) {
    for (const ReadOptions& options : {ReadOptions{.force_channel = "accel 1",
                                      .accel_channels = {"force", "accel 2"},
                                      .force_unit = "N",
                                      .accel_unit = "m/s^2"},
                                       ReadOptions{.force_unit = "N",
                                       .accel_unit = "m/s^2",
                                       .setup = {{.name = "accel 1", .role = "force"},
                                                 {.name = "force", .role = "acceleration"},
                                                 {.name = "accel 2", .role = "acceleration"}}}}) {
      const Record record = open_mat(file, options);
      EXPECT_EQ(record.force.name, "accel 1");
      EXPECT_THAT(force_N(record), ElementsAre(4, 5, 6));
      ASSERT_EQ(record.accel.size(), 2U);
      EXPECT_EQ(record.accel[0].name, "force");
      EXPECT_THAT(accel_mps2(record, 0), ElementsAre(1, 2, 3));
      EXPECT_EQ(record.accel[1].name, "accel 2");
      EXPECT_THAT(accel_mps2(record, 1), ElementsAre(7, 8, 9));
      EXPECT_EQ(record.accel[0].angle_rad, 0) << "the place of the channel that is the force";
      EXPECT_NEAR(record.accel[1].angle_rad.value(), 1.5707963, 1e-6);
    }
  }
  const Record alone = open_mat(three_dimensions, {.force_channel = "accel 2", .force_unit = "N"});
  ASSERT_EQ(alone.accel.size(), 1U);
  EXPECT_THAT(accel_mps2(alone), ElementsAre(4, 5, 6));
  EXPECT_EQ(alone.accel[0].angle_rad, 0);
  EXPECT_THAT(refusal_of(three_dimensions, {.force_channel = "accel 1"}), HasSubstr("not a force"));
  EXPECT_THAT(refusal_of(three_dimensions, {.force_channel = "accel 3"}), HasSubstr("no column \"accel 3\""));
}

TEST(MatOptions, SetUpAChannelByItsName) {
  const Record record = open_mat(example(), {.setup = {{.name = "accel 2", .sign = -1}}});
  ASSERT_EQ(record.accel.size(), 2U);
  EXPECT_THAT(accel_mps2(record, 0), ElementsAre(4, 5, 6));
  EXPECT_THAT(accel_mps2(record, 1), ElementsAre(-7, -8, -9));
}

TEST(MatOptions, IgnoreAndChooseChannels) {
  const Record second = open_mat(example(), {.setup = {{.name = "accel 1", .role = "ignore"}}});
  ASSERT_EQ(second.accel.size(), 1U);
  EXPECT_THAT(accel_mps2(second), ElementsAre(7, 8, 9));
  EXPECT_THAT(
      refusal_of(example(), {.setup = {{.name = "ACCEL 1", .role = "ignore"}, {.name = "accel 2", .role = "ignore"}}}),
      HasSubstr("every acceleration is ignored"));
  EXPECT_THAT(refusal_of(example(), {.accel_channels = {"1", "accel 1"}}), HasSubstr("requested twice"));
  EXPECT_THAT(refusal_of(example(), {.accel_channels = {"3"}}),
              HasSubstr("channel \"3\" does not exist or is requested twice, among 2 channels"));
}

TEST(MatOptions, TakeDescriptionsOfTheRightShapeOnly) {
  const std::vector<double> corners{0, 1, 0, 0};  // (0, 0) and (1, 0)
  const MatVariable geometry = mat_numbers("geometry", {2, 2}, corners);
  const Record good = open_mat(example({geometry, mat_numbers("trace_lines", {1, 2}, {0, 1})}), {});
  EXPECT_EQ(good.geometry, (std::vector<std::vector<double>>{{0, 0}, {1, 0}}));
  ASSERT_EQ(good.trace_lines.size(), 1U);
  for (const MatVariable& lines : {mat_text("trace_lines", "01"), mat_numbers("trace_lines", {1, 2, 1}, {0, 1}),
                                   mat_numbers("trace_lines", {2, 1}, {0, 1})})
    EXPECT_THAT(open_mat(example({geometry, lines}), {}).trace_lines, IsEmpty());
  for (const double end : {0.5, 2.0}) {
    const Record missing = open_mat(example({geometry, mat_numbers("trace_lines", {1, 2}, {0, end})}), {});
    EXPECT_THAT(missing.trace_lines, IsEmpty());
    EXPECT_THAT(missing.notes, testing::Contains(Message("trace_lines is not used: a line to a missing point")));
  }
  for (const MatVariable& other : {mat_text("geometry", "0011"), mat_numbers("geometry", {2, 1, 2}, corners),
                                   mat_numbers("geometry", {4, 1}, corners), mat_numbers("geometry", {1, 4}, corners)})
    EXPECT_THAT(open_mat(example({other}), {}).geometry, IsEmpty());
  const Record angles =
      open_mat(example({mat_numbers("angle_deg", {1, 2}, {180, kNaN}), mat_text("position_m", "ab")}), {});
  EXPECT_DOUBLE_EQ(angles.accel[0].angle_rad.value(), std::acos(-1));
  EXPECT_FALSE(angles.accel[1].angle_rad.has_value());
  EXPECT_FALSE(angles.accel[0].position_m.has_value());
}

TEST(MatOptions, TakeDescriptionsOfRealNumbersOnly) {
  const auto complex = [](const std::string& name, const std::vector<std::size_t>& shape,
                          const std::vector<double>& real) {
    MatVariable out = mat_numbers(name, shape, real);
    out.imaginary = std::vector<double>(real.size(), 1);
    return out;
  };
  const Record record =
      open_mat(example({complex("geometry", {2, 2}, {0, 1, 0, 0}), complex("angle_deg", {1, 2}, {0, 90}),
                        complex("position_m", {1, 2}, {0, 1})}),
               {});
  EXPECT_THAT(record.geometry, IsEmpty());
  EXPECT_FALSE(record.accel[1].angle_rad.has_value());
  EXPECT_FALSE(record.accel[1].position_m.has_value());
  EXPECT_EQ(refusal_of(example({complex("point", {1, 1}, {1})})),
            "not one whole number for each of 1 hits (x.mat: point); store one per hit");
}

TEST(MatOptions, NumberHitsByWholeNumbers) {
  EXPECT_EQ(open_mat(example({mat_numbers("point", {1, 1}, {3})}), {}).rows[0].point, 3);
  EXPECT_EQ(open_mat(example({mat_numbers("run", {1, 1}, {-3})}), {}).rows[0].run, -3);
  EXPECT_EQ(refusal_of(example({mat_numbers("point", {1, 1}, {-3})})),
            "-3 is not a point number (x.mat: point); number points from 0 to 1000000000");
  EXPECT_EQ(open_mat(example({mat_text("point", "7")}), {}).rows[0].point, 0);
  for (const MatVariable& point : {mat_numbers("point", {1, 1}, {1.5}), mat_numbers("point", {1, 1}, {3e9}),
                                   mat_numbers("point", {1, 1}, {kNaN}), mat_numbers("point", {2, 1}, {1, 2})}) {
    EXPECT_EQ(refusal_of(example({point})),
              "not one whole number for each of 1 hits (x.mat: point); store one per hit");
  }
}

/// Two hits of four samples as the fields of a structure, with further variables.
acquire::MatFile in_structure(const std::vector<MatVariable>& more) {
  std::vector<MatVariable> all{mat_numbers("test.force", {2, 4}, {0, 0, 1, 2, 0, 0, 0, 0}),
                               mat_numbers("test.accel", {2, 4}, {0, 0, 1, 2, 1, 2, 1, 2})};
  all.insert(all.end(), more.begin(), more.end());
  return test::mat_record_of(all);
}

TEST(MatOptions, AreReadFromTheStructureOfTheForce) {
  const Record record = open_mat(
      in_structure({mat_numbers("test.point", {2, 1}, {4, 2}), mat_numbers("test.run", {1, 1}, {3}),
                    mat_numbers("test.geometry", {2, 2}, {0, 1, 0, 0}), mat_numbers("test.trace_lines", {1, 2}, {0, 1}),
                    mat_numbers("test.angle_deg", {1, 1}, {180}), mat_numbers("test.position_m", {1, 1}, {0.25}),
                    mat_numbers("other.point", {2, 1}, {8, 9})}),
      {});
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.rows[0].point, 4);
  EXPECT_EQ(record.rows[1].point, 2);
  EXPECT_EQ(record.rows[0].run, 3) << "one number states the run of all hits";
  EXPECT_EQ(record.rows[1].run, 3);
  EXPECT_EQ(record.geometry.size(), 2U);
  EXPECT_EQ(record.trace_lines.size(), 1U);
  EXPECT_DOUBLE_EQ(record.accel[0].angle_rad.value(), std::acos(-1));
  EXPECT_EQ(record.accel[0].position_m, 0.25);
}

TEST(MatOptions, AreReadFromTheOnlyStructureThatHasThem) {
  const MatVariable other = mat_numbers("setup.point", {1, 2}, {5, 6});
  EXPECT_EQ(open_mat(in_structure({other}), {}).rows[1].point, 6);
  EXPECT_EQ(open_mat(in_structure({other, mat_numbers("more.point", {1, 2}, {7, 8})}), {}).rows[1].point, 0);
  EXPECT_EQ(open_mat(in_structure({other, mat_numbers("point", {1, 2}, {1, 2})}), {}).rows[1].point, 2);
}

TEST(MatOptions, AreNamedWhereAStructureHoldsSomethingElse) {
  EXPECT_EQ(test::input_error_of([] {
              open_mat(in_structure({mat_numbers("test.point", {3, 1}, {1, 2, 3})}), {});
            }),
            "not one whole number for each of 2 hits (x.mat: test.point); store one per hit");
  const Record record = open_mat(in_structure({mat_numbers("setup.run", {3, 1}, {1, 2, 3})}), {});
  EXPECT_EQ(record.rows[0].run, 0);
  EXPECT_THAT(record.notes,
              testing::Contains(Message("setup.run is not used: it is not one whole number for each of 2 hits")));
}

TEST(MatOptions, NameTheRate) {
  const auto rate_Hz = [](const MatVariable& named) {
    return open_mat(example({named}), {.fs_variable = named.name}).fs_Hz;
  };
  EXPECT_EQ(rate_Hz(mat_numbers("speed", {1, 1}, {500})), 500);
  EXPECT_EQ(rate_Hz(mat_numbers("speed", {3, 1}, {0, 0.5, 1})), 2);
  MatVariable complex = mat_numbers("speed", {1, 1}, {500});
  complex.imaginary = {1};
  for (const MatVariable& other : {mat_text("speed", "500"), complex, mat_numbers("speed", {0, 0}, {})})
    EXPECT_THAT(input_error_of([&] { rate_Hz(other); }), HasSubstr("not a number (x.mat: speed)"));
}

std::string words(const std::vector<std::uint32_t>& values, bool swapped) {
  std::string out;
  for (const std::uint32_t value : values) {
    const std::uint32_t stored = swapped ? __builtin_bswap32(value) : value;
    out.append(reinterpret_cast<const char*>(&stored), sizeof stored);
  }
  return out;
}

TEST(MatHeader, IsKnownByItsFirstBytes) {
  const auto head = [](const std::vector<std::uint32_t>& tag, const std::string& name, bool swapped = false) {
    return words(tag, swapped) + name;
  };
  const std::string name("xy\0", 3);
  EXPECT_TRUE(is_mat("MATLAB 5.0"));
  EXPECT_TRUE(is_mat(head({0, 3, 1, 0, 3}, name)));
  EXPECT_TRUE(is_mat(head({0, 3, 1, 1, 3}, name)));
  EXPECT_TRUE(is_mat(head({52, 3, 1, 0, 3}, name))) << "bytes of a sparse matrix";
  EXPECT_TRUE(is_mat(head({1000, 3, 1, 0, 3}, name, true)));
  EXPECT_TRUE(is_mat(head({0, 3, 1, 0, 3}, name, true))) << "the name's length alone shows the byte order";
  EXPECT_FALSE(is_mat(""));
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0}, "")));
  for (const std::uint32_t type : {100U, 999U, 1100U, 3U, 60U}) EXPECT_FALSE(is_mat(head({type, 3, 1, 0, 3}, name)));
  EXPECT_FALSE(is_mat(head({0, 0, 1, 0, 3}, name)));
  EXPECT_FALSE(is_mat(head({0, 3, 0, 0, 3}, name)));
  EXPECT_FALSE(is_mat(head({0, 3, 1, 2, 3}, name)));
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0, 1}, name))) << "an empty name";
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0, 65}, std::string(100, 'x'))));
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0, 4}, name))) << "the name ends beyond the bytes";
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0, 3}, "xyz")));
  EXPECT_FALSE(is_mat(head({0, 3, 1, 0, 3}, std::string("1y\0", 3))));
}

class MatCompleteness : public testing::Test {
 protected:
  std::string refusal(const std::string& bytes, MatLevel level) const {
    test::write_bytes(path_, bytes);
    return input_error_of([&] { require_complete_mat(path_, level); });
  }
  void expect_complete(const std::string& bytes, MatLevel level) const {
    test::write_bytes(path_, bytes);
    EXPECT_NO_THROW(require_complete_mat(path_, level));
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("x.mat");
};

// A big-endian file of level 5 with the column x = (1, 2, 3).
std::string big_endian_level5() {
  std::string out = "MATLAB 5.0 MAT-file";
  out.resize(124, ' ');
  out += std::string("\x01\x00MI", 4);
  const std::string matrix = words({6, 8, 6, 0, 5, 8, 3, 1, 1, 1}, true) + std::string("x\0\0\0\0\0\0\0", 8) +
                             words({9, 24, 0x3FF00000U, 0, 0x40000000U, 0, 0x40080000U, 0}, true);
  return out + words({14, static_cast<std::uint32_t>(matrix.size())}, true) + matrix;
}

TEST_F(MatCompleteness, FollowsBothByteOrders) {
  const std::string five = big_endian_level5();
  expect_complete(five, MatLevel::v5);
  const MatFile read = read_mat_file(path_);
  ASSERT_EQ(read.variables.size(), 1U);
  EXPECT_EQ(read.variables[0].name, "x");
  EXPECT_THAT(read.variables[0].real, ElementsAre(1, 2, 3));
  EXPECT_THAT(refusal(five.substr(0, five.size() - 1), MatLevel::v5), HasSubstr("the file ends within a variable"));
  for (const std::uint32_t type : {0U, 1000U}) {
    const std::string four = words({type, 1, 1, 0, 2}, true) + std::string("x\0", 2) + std::string(8, '\0');
    expect_complete(four, MatLevel::v4);
    EXPECT_THAT(refusal(four.substr(0, four.size() - 1), MatLevel::v4), HasSubstr("the file ends within a variable"));
  }
}

TEST_F(MatCompleteness, LeavesOtherVariablesToTheLibrary) {
  const std::string five = big_endian_level5();
  expect_complete(five + words({99, 1000}, true), MatLevel::v5);
  expect_complete(words({60, 1000, 1, 0, 2}, false), MatLevel::v4);
  EXPECT_THAT(refusal(words({0, 1000, 1, 0, 2}, false), MatLevel::v4), HasSubstr("the file ends within a variable"));
  EXPECT_THAT(refusal(five.substr(0, 126), MatLevel::v5), HasSubstr("reading failed"));
  std::string many;
  for (int n = 0; n < 100'001; ++n) many += words({50, 1, 1, 0, 2}, false) + std::string("x\0\1", 3);
  expect_complete(many.substr(0, many.size() - 1), MatLevel::v4);  // variable 100 001 is not examined
}

}  // namespace percuss::acquire::mat_options_test
