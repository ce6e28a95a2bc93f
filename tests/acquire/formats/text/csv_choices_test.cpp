#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"

// Records without a force, without units, and with too many columns.
namespace percuss::acquire::csv_choices_test {

using test::accel_mps2;
using test::csv_record;
using test::force_N;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CsvChoices, AllowARecordWithoutAForce) {
  const std::string text = "time_s,acc_m/s2\n0,1\n0.5,2\n1.0,3\n";
  EXPECT_THAT(input_error_of([&] { csv_record(text); }), HasSubstr("no force column found"));
  const Record record = csv_record(text, {.force_optional = true});
  EXPECT_FALSE(record.has_force);
  EXPECT_THAT(force_N(record), ElementsAre(0, 0, 0));
  EXPECT_THAT(accel_mps2(record), ElementsAre(1, 2, 3));
}

TEST(CsvChoices, TakeNumbersWithASensitivityAsVolts) {
  const std::string text = "time,force,acc\n0,1,2\n0.5,3,4\n1.0,1,2\n";
  const Record record =
      csv_record(text, {.fs_Hz = 2, .force_sensitivity_V_per_N = 0.5, .accel_sensitivity_V_per_mps2 = {0.25}});
  EXPECT_THAT(force_N(record), ElementsAre(2, 6, 2));
  EXPECT_THAT(accel_mps2(record), ElementsAre(8, 16, 8));
  EXPECT_THAT(record.notes, IsEmpty());
}

TEST(CsvChoices, RefuseMoreThan4095Columns) {
  const auto record = [](std::size_t columns) {
    std::string line = "0.5";
    for (std::size_t c = 1; c < columns; ++c) line += ";0.5";
    return csv_record(line + "\n" + line + "\n" + line + "\n",
                      {.fs_Hz = 100, .force_channel = "1", .accel_channels = {"2"}});
  };
  EXPECT_THAT(accel_mps2(record(4095)), ElementsAre(0.5, 0.5, 0.5));
  EXPECT_THAT(input_error_of([&] { record(4096); }), HasSubstr("more than 4095 columns"));
}

}  // namespace percuss::acquire::csv_choices_test
