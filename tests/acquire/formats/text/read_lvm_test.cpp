#include "acquire/formats/text/read_lvm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"

namespace percuss::acquire::read_lvm_test {

using test::accel_mps2;
using test::csv_bytes;
using test::force_N;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kHead =
    "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nReader_Version\t2\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\n"
    "Multi_Headings\tYes\r\nX_Columns\tOne\r\nTime_Pref\tRelative\r\n***End_of_Header***\t\r\n\t\r\n";
const std::string kSegment =
    "Channels\t2\t\t\r\nSamples\t3\t3\t\r\nY_Unit_Label\tN\tg\t\r\nX_Dimension\tTime\tTime\t\r\nX0\t0.0\t0.0\t\r\n"
    "Delta_X\t0.001\t0.001\t\r\n***End_of_Header***\t\t\t\r\nX_Value\tHammer\tTip\tComment\r\n"
    "0.000\t1.5\t2\r\n0.001\t-2\t1\r\n0.002\t3\t0\r\n";

Record opened(const std::string& text, const ReadOptions& options = {}) { return open_lvm(csv_bytes(text), options); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

TEST(ReadLvm, TakesSegmentsAsRows) {
  const Record record = opened(kHead + kSegment + "\r\n" + replaced(kSegment, "1.5", "7"));
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.fs_Hz, 1000);
  EXPECT_EQ(record.force.name, "Hammer");
  EXPECT_THAT(force_N(record), ElementsAre(1.5, -2, 3));
  EXPECT_THAT(force_N(record, 1), ElementsAre(7, -2, 3));
  EXPECT_THAT(accel_mps2(record), ElementsAre(2 * kStandardGravity_mps2, kStandardGravity_mps2, 0));
  EXPECT_EQ(record.format, "LabVIEW");
}

TEST(ReadLvm, FollowsSeparatorAndDecimalMark) {
  const std::string german =
      replaced(replaced(kHead + kSegment, "Decimal_Separator\t.", "Decimal_Separator\t,"), "1.5", "1,5");
  EXPECT_EQ(force_N(opened(replaced(german, "0.00", "0,00")))[0], 1.5);
  const std::string commas = replaced(replaced(kHead, "Tab", "Comma") + kSegment, "\t", ",");
  EXPECT_EQ(force_N(opened(commas))[0], 1.5);
  const std::string reordered =
      replaced(commas, "Separator,Comma\r\nDecimal_Separator,.\r\n", "Decimal_Separator,.\r\nSeparator,Comma\r\n");
  ASSERT_NE(reordered, commas);
  EXPECT_EQ(force_N(opened(reordered))[0], 1.5);
}

TEST(ReadLvm, ReadsFilesWithoutTimesAndWithTimesPerChannel) {
  const std::string none =
      replaced(replaced(kHead + kSegment, "X_Columns\tOne", "X_Columns\tNo"), "0.000\t1.5", "\t1.5");
  EXPECT_THAT(force_N(opened(none)), ElementsAre(1.5, -2, 3));
  const std::string multi =
      replaced(replaced(kHead, "X_Columns\tOne", "X_Columns\tMulti") + kSegment.substr(0, kSegment.find("X_Value")),
               "\r\n\r\n", "\r\n") +
      "X_Value\tHammer\tX_Value\tTip\tComment\r\n0\t1\t0\t2\r\n0.001\t3\t0.001\t4\r\n";
  const Record record = opened(multi);
  EXPECT_THAT(force_N(record), ElementsAre(1, 3));
  EXPECT_EQ(record.accel[0].name, "Tip");
}

TEST(ReadLvm, RefusesDamagedFiles) {
  EXPECT_THAT(input_error_of([] { opened(kHead); }), HasSubstr("no segment"));
  EXPECT_THAT(input_error_of([] { opened("LabVIEW Measurement\n"); }), HasSubstr("without its end"));
  EXPECT_THAT(input_error_of([] { opened(kHead + replaced(kSegment, "-2", "two")); }),
              HasSubstr("\"two\" is not a number"));
  EXPECT_THAT(input_error_of([] { opened(kHead + replaced(kSegment, "0.001\t-2\t1", "0.001\t-2")); }),
              HasSubstr("2 cells for 2 channels"));
  EXPECT_THAT(input_error_of([] { opened(kHead + replaced(kSegment, "Channels\t2", "Channels\t1e9")); }),
              HasSubstr("number of channels"));
}

}  // namespace percuss::acquire::read_lvm_test
