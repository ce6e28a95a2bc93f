#include "acquire/formats/mat/mat_named_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/formats/mat/mat_abscissa.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "support/files/mat_variables.hpp"
#include "support/record_samples.hpp"

// A matrix of samples beside a list of the names of its columns.
namespace percuss::acquire::mat_named_columns_test {

using test::accel_mps2;
using test::force_N;
using test::mat_numbers;
using test::mat_record_of;
using test::mat_text;
using testing::ElementsAre;

MatVariable data(const std::string& name = "data") { return mat_numbers(name, {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8}); }

std::vector<std::string> variables_after(MatFile file, const ReadOptions& options = {}) {
  split_named_columns(file, options);
  std::vector<std::string> names;
  for (const MatVariable& variable : file.variables) names.push_back(variable.name);
  return names;
}

TEST(MatNamedColumns, AreSignalsOfTheirNamesAndUnits) {
  MatFile file = mat_record_of({mat_text("names{1}", "Hammer"), mat_text("names{2}", "Acc tip"),
                                mat_text("units{1}", "kN"), mat_text("units{2}", "m/s^2"), data()});
  split_named_columns(file, {});
  const Record record = open_mat(std::move(file), {});
  EXPECT_EQ(record.force.name, "Hammer");
  EXPECT_THAT(force_N(record), ElementsAre(1000, 2000, 3000, 4000));
  ASSERT_EQ(record.accel.size(), 1U);
  EXPECT_EQ(record.accel.front().name, "Acc tip");
  EXPECT_THAT(accel_mps2(record), ElementsAre(5, 6, 7, 8));
}

TEST(MatNamedColumns, MayLieInRows) {
  MatFile file = mat_record_of({mat_text("labels{1}", "Force (N)"), mat_text("labels{2}", "Acc (m/s^2)"),
                                mat_numbers("data", {2, 4}, {1, 5, 2, 6, 3, 7, 4, 8})});
  split_named_columns(file, {});
  const Record record = open_mat(std::move(file), {});
  EXPECT_THAT(force_N(record), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(accel_mps2(record), ElementsAre(5, 6, 7, 8));
}

// MATLAB fills the rows of a char array with blanks, and stores it column by column.
TEST(MatNamedColumns, MayBeNamedByTheRowsOfACharArray) {
  const MatVariable too_long{.name = "channel_names", .shape = {2, 5}, .text = "FAoccrcc e ", .is_text = true};
  EXPECT_THAT(variables_after(mat_record_of({too_long, data()})),
              ElementsAre("channel_names", "data", "fs"));  // 11 bytes for 10 characters: not used
  const MatVariable right{.name = "channel_names", .shape = {2, 5}, .text = "FAocrcc e ", .is_text = true};
  EXPECT_THAT(variables_after(mat_record_of({right, data()})), ElementsAre("channel_names", "fs", "Force", "Acc"));
}

TEST(MatNamedColumns, MayNameTheTimesToo) {
  std::vector<double> with_times;
  for (int i = 0; i < 20; ++i) with_times.push_back(i * 1e-3);
  for (int i = 0; i < 20; ++i) with_times.push_back(i % 3);
  for (int i = 0; i < 20; ++i) with_times.push_back(i % 5);
  MatFile file = mat_record_of({mat_text("header{1}", "Time"), mat_text("header{2}", "Impact"),
                                mat_text("header{3}", "Acc"), mat_numbers("data", {20, 3}, with_times)});
  split_abscissas(file);
  EXPECT_THAT(variables_after(file),
              ElementsAre("header{1}", "header{2}", "header{3}", "fs", "data.t", "Impact", "Acc"));
}

TEST(MatNamedColumns, StayAMatrixWhereTheNamesDoNotTell) {
  const auto unchanged = [](const MatFile& file, const ReadOptions& options = {}) {
    return variables_after(file, options).size() == file.variables.size();
  };
  const MatVariable force = mat_text("names{1}", "Force"), accel = mat_text("names{2}", "Acc");
  EXPECT_FALSE(unchanged(mat_record_of({force, accel, data()})));
  EXPECT_TRUE(unchanged(mat_record_of({force, mat_text("names{2}", "Force"), data()}))) << "one name twice";
  EXPECT_TRUE(unchanged(mat_record_of({force, accel, mat_text("names{3}", "Acc 2"), data()}))) << "a name too many";
  EXPECT_TRUE(unchanged(mat_record_of({mat_text("names{1}", "A"), mat_text("names{2}", "B"), data()})))
      << "no word for a quantity";
  EXPECT_TRUE(unchanged(mat_record_of({force, accel, data(), data("more")}))) << "two matrices";
  EXPECT_TRUE(unchanged(mat_record_of({force, accel, data(), mat_numbers("Acc", {1, 1}, {1})})))
      << "a name that is taken";
  EXPECT_TRUE(unchanged(mat_record_of({force, accel, data()}), {.force_channel = "data(:,1)"}))
      << "a column is asked for";
  EXPECT_TRUE(unchanged(mat_record_of({force, accel, data()}), {.accel_channels = {"Data"}}))
      << "the matrix is asked for";
  MatFile frfs = mat_record_of({force, accel, data(), mat_numbers("H", {4, 1}, {1, 2, 3, 4})});
  frfs.variables[3].imaginary = {1, 2, 3, 4};
  EXPECT_TRUE(unchanged(frfs)) << "FRFs";
}

}  // namespace percuss::acquire::mat_named_columns_test
