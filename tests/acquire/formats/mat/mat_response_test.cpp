#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "acquire/open_measurement.hpp"
#include "core/units.hpp"
#include "support/files/mat_builder.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// MAT files without a force.
namespace percuss::acquire::mat_response_test {

using test::accel_mps2;
using test::input_error_of;
using test::MatBuilder;
using test::MatLevel;
using testing::ElementsAre;
using testing::HasSubstr;

class MatResponse : public testing::Test {
 protected:
  Record opened(ReadOptions options = {}) const {
    options.force_optional = true;
    return open_record(path_, options);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat");
};

TEST_F(MatResponse, IsReadFromVectorsAndMatrices) {
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("acc1_g", {4, 1}, {1, 2, 3, 4})
      .numbers("acc2_g", {4, 1}, {5, 6, 7, 8});
  const Record vectors = opened();
  EXPECT_FALSE(vectors.has_force);
  ASSERT_EQ(vectors.accel.size(), 2U);
  EXPECT_EQ(vectors.rows.size(), 1U);
  EXPECT_DOUBLE_EQ(accel_mps2(vectors, 1)[3], 8 * kStandardGravity_mps2);

  for (const bool time_last : {false, true}) {  // two channels of four samples
    MatBuilder(path_, MatLevel::v73)
        .numbers("fs", {1, 1}, {1000})
        .numbers("accel", time_last ? std::vector<std::size_t>{2, 4} : std::vector<std::size_t>{4, 2},
                 time_last ? std::vector<double>{1, 5, 2, 6, 3, 7, 4, 8} : std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});
    const Record matrix = opened();
    ASSERT_EQ(matrix.accel.size(), 2U);
    EXPECT_THAT(accel_mps2(matrix, 0), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(accel_mps2(matrix, 1), ElementsAre(5, 6, 7, 8));
    EXPECT_THAT(test::texts(matrix.notes), testing::Contains(testing::HasSubstr("2 channels of one row")));
    EXPECT_THAT(accel_mps2(opened({.accel_channels = {"2"}}), 0), ElementsAre(5, 6, 7, 8));
  }
}

// The first file has percuss's own layout [hits, channels, samples]. In the second, the columns of a matrix are hits,
// not channels, because `point` has one number per column.
TEST_F(MatResponse, KnowsHitsByTheLayoutOrByAVariableOfTheirNumber) {
  std::vector<double> values;  // [hits, channels, samples] = [2, 3, 5]: 100 h + 10 c + i
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t h = 0; h < 2; ++h) values.push_back(static_cast<double>(100 * h + 10 * c + i));
  MatBuilder(path_, MatLevel::v5).numbers("fs", {1, 1}, {1000}).numbers("accel", {2, 3, 5}, values);
  const Record block = opened();
  EXPECT_EQ(block.rows.size(), 2U);
  ASSERT_EQ(block.accel.size(), 3U);
  EXPECT_THAT(accel_mps2(block, 2, 1), ElementsAre(120, 121, 122, 123, 124));

  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("point", {1, 2}, {3, 7})
      .numbers("accel", {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8});
  const Record hits = opened();
  ASSERT_EQ(hits.rows.size(), 2U);
  EXPECT_EQ(hits.accel.size(), 1U);
  EXPECT_EQ(hits.rows[1].point, 7);
  EXPECT_THAT(accel_mps2(hits, 0, 1), ElementsAre(5, 6, 7, 8));
}

TEST_F(MatResponse, IsRefusedWhereAChannelCouldBeTheForceOrTimeIsUnclear) {
  const auto with = [&](const std::string& name, const std::vector<std::size_t>& shape) {
    std::size_t count = 1;
    for (const std::size_t size : shape) count *= size;
    MatBuilder(path_, MatLevel::v5).numbers("fs", {1, 1}, {1000}).numbers(name, shape, std::vector<double>(count, 1.0));
    return input_error_of([&] { (void)opened(); });
  };
  EXPECT_THAT(with("data", {8, 2}), HasSubstr("could be the force"));
  EXPECT_THAT(with("accel", {8, 8}), HasSubstr("time is unclear"));
  EXPECT_THAT(with("accel", {2, 8, 3}), HasSubstr("neither the first dimension nor the last"));
  EXPECT_THAT(with("accel", {2, 2, 8, 2}), HasSubstr("three dimensions"));
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("acc1_g", {4, 1}, {1, 2, 3, 4})
      .numbers("acc2_g", {5, 1}, {5, 6, 7, 8, 9});
  EXPECT_THAT(input_error_of([&] { (void)opened(); }), HasSubstr("the first response has 1 hit of 4 samples"));
  MatBuilder(path_, MatLevel::v5).numbers("fs", {1, 1}, {1000}).numbers("data", {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(opened({.accel_channels = {"data"}}).accel.size(), 2U);
  EXPECT_TRUE(opened({.force_channel = "data(:,1)", .accel_channels = {"data(:,2)"}}).has_force);
}

}  // namespace percuss::acquire::mat_response_test
