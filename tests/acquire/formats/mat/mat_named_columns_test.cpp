#include "acquire/formats/mat/mat_named_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/formats/mat/mat_abscissa.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "support/record_samples.hpp"

// A matrix of samples beside a list of the names of its columns.
namespace percuss::acquire::mat_named_columns_test {

using test::accel_mps2;
using test::force_N;
using testing::ElementsAre;

MatVariable numbers(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<double>& real) {
  return {.name = name, .shape = shape, .real = real};
}

MatVariable text(const std::string& name, const std::string& content) {
  return {.name = name, .shape = {1, content.size()}, .text = content, .is_text = true};
}

MatVariable data(const std::string& name = "data") { return numbers(name, {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8}); }

MatFile file_of(const std::vector<MatVariable>& variables) {
  MatFile file{.path = "x.mat", .bytes = 1000, .variables = variables};
  file.variables.push_back(numbers("fs", {1, 1}, {1000}));
  return file;
}

std::vector<std::string> variables_after(MatFile file, const ReadOptions& options = {}) {
  split_named_columns(file, options);
  std::vector<std::string> names;
  for (const MatVariable& variable : file.variables) names.push_back(variable.name);
  return names;
}

TEST(MatNamedColumns, AreSignalsOfTheirNamesAndUnits) {
  MatFile file = file_of({text("names{1}", "Hammer"), text("names{2}", "Acc tip"), text("units{1}", "kN"),
                          text("units{2}", "m/s^2"), data()});
  split_named_columns(file, {});
  const Record record = open_mat(std::move(file), {});
  EXPECT_EQ(record.force.name, "Hammer");
  EXPECT_THAT(force_N(record), ElementsAre(1000, 2000, 3000, 4000));
  ASSERT_EQ(record.accel.size(), 1U);
  EXPECT_EQ(record.accel.front().name, "Acc tip");
  EXPECT_THAT(accel_mps2(record), ElementsAre(5, 6, 7, 8));
}

TEST(MatNamedColumns, MayLieInRows) {
  MatFile file = file_of({text("labels{1}", "Force (N)"), text("labels{2}", "Acc (m/s^2)"),
                          numbers("data", {2, 4}, {1, 5, 2, 6, 3, 7, 4, 8})});
  split_named_columns(file, {});
  const Record record = open_mat(std::move(file), {});
  EXPECT_THAT(force_N(record), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(accel_mps2(record), ElementsAre(5, 6, 7, 8));
}

// MATLAB fills the rows of a char array with blanks, and stores it column by column.
TEST(MatNamedColumns, MayBeNamedByTheRowsOfACharArray) {
  const MatVariable rows{.name = "channel_names", .shape = {2, 5}, .text = "FAoccrcc e ", .is_text = true};
  EXPECT_THAT(variables_after(file_of({rows, data()})), ElementsAre("channel_names", "data", "fs"));  // a byte too many
  const MatVariable right{.name = "channel_names", .shape = {2, 5}, .text = "FAocrcc e ", .is_text = true};
  EXPECT_THAT(variables_after(file_of({right, data()})), ElementsAre("channel_names", "fs", "Force", "Acc"));
}

TEST(MatNamedColumns, MayNameTheTimesToo) {
  std::vector<double> with_times;
  for (int i = 0; i < 20; ++i) with_times.push_back(i * 1e-3);
  for (int i = 0; i < 20; ++i) with_times.push_back(i % 3);
  for (int i = 0; i < 20; ++i) with_times.push_back(i % 5);
  MatFile file = file_of({text("header{1}", "Time"), text("header{2}", "Impact"), text("header{3}", "Acc"),
                          numbers("data", {20, 3}, with_times)});
  split_abscissas(file);
  EXPECT_THAT(variables_after(file),
              ElementsAre("header{1}", "header{2}", "header{3}", "fs", "data.t", "Impact", "Acc"));
}

TEST(MatNamedColumns, StayAMatrixWhereTheNamesDoNotTell) {
  const auto unchanged = [](const MatFile& file, const ReadOptions& options = {}) {
    return variables_after(file, options).size() == file.variables.size();
  };
  const MatVariable force = text("names{1}", "Force"), accel = text("names{2}", "Acc");
  EXPECT_FALSE(unchanged(file_of({force, accel, data()})));
  EXPECT_TRUE(unchanged(file_of({force, text("names{2}", "Force"), data()}))) << "one name twice";
  EXPECT_TRUE(unchanged(file_of({force, accel, text("names{3}", "Acc 2"), data()}))) << "a name too many";
  EXPECT_TRUE(unchanged(file_of({text("names{1}", "A"), text("names{2}", "B"), data()}))) << "no word for a quantity";
  EXPECT_TRUE(unchanged(file_of({force, accel, data(), data("more")}))) << "two matrices";
  EXPECT_TRUE(unchanged(file_of({force, accel, data(), numbers("Acc", {1, 1}, {1})}))) << "a name that is taken";
  EXPECT_TRUE(unchanged(file_of({force, accel, data()}), {.force_channel = "data(:,1)"})) << "a column is asked for";
  EXPECT_TRUE(unchanged(file_of({force, accel, data()}), {.accel_channels = {"Data"}})) << "the matrix is asked for";
  MatFile frfs = file_of({force, accel, data(), numbers("H", {4, 1}, {1, 2, 3, 4})});
  frfs.variables[3].imaginary = {1, 2, 3, 4};
  EXPECT_TRUE(unchanged(frfs)) << "FRFs";
}

}  // namespace percuss::acquire::mat_named_columns_test
