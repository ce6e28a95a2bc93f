#include "core/io/csv_header.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::csv_header_test {

using testing::ElementsAre;
using testing::HasSubstr;

CsvHeader header_of(std::string_view text) {
  const char line_end = find_line_end(text);
  const auto probes = probe_lines(text, line_end);
  const CsvDialect dialect = find_dialect(probes, line_end);
  return read_csv_header(text, dialect, find_number_columns(probes, dialect), "x.csv");
}

std::vector<std::string> names_of(const CsvHeader& header) {
  std::vector<std::string> names;
  for (const auto& column : header.columns) names.push_back(column.name + "|" + column.unit);
  return names;
}

struct NameCase {
  const char *name, *base, *unit;
};

TEST(CsvHeader, SplitsUnitsOffNames) {
  for (const auto& c :
       {NameCase{"force_N", "force", "N"}, NameCase{"acc0_m_s2", "acc0", "m/s2"}, NameCase{"t_s", "t", "s"},
        NameCase{"Force (N)", "Force", "N"}, NameCase{"accel [g]", "accel", "g"}, NameCase{"Force/N", "Force", "N"},
        NameCase{"Acc(m/s^2)", "Acc", "m/s^2"}, NameCase{"Acc top (left) (g)", "Acc top (left)", "g"},
        NameCase{"Time (\xC2\xB5s)", "Time", "\xC2\xB5s"}, NameCase{"CH2", "CH2", ""},
        NameCase{"my force", "my force", ""}, NameCase{"N", "N", ""}, NameCase{"accel m/s2", "accel", "m/s2"}}) {
    const auto split = split_name(c.name);
    EXPECT_EQ(split.base, c.base) << c.name;
    EXPECT_EQ(split.unit, c.unit) << c.name;
  }
}

TEST(CsvHeader, ReadsUnitsFromASeparateLine) {
  const auto header = header_of("time,force,acc\ns,N,m/s\xB2\n0,1,2\n1,2,3\n");
  EXPECT_THAT(names_of(header), ElementsAre("time|s", "force|N", "acc|m/s\xC2\xB2"));
  EXPECT_EQ(header.lines, 2U);
}

TEST(CsvHeader, FindsNamesUnitsAndRateAmongOtherLines) {
  const auto header = header_of(
      "\"ID No.\",\"LOG-4\"\r\n\"Title\",\"\"\r\n\"Test Date\",\"2026/04/09\",\"15:54:47\"\r\n\"Sampling "
      "Rate(Hz)\",50\r\n"
      "\"CH Name\"\r\n\"CH "
      "No.\",\"CH2\",\"CH8\"\r\n\"Range\",2000,5\r\n\"Offset\",-97.5,-13.1\r\n\"Unit\",\"cm/s2\",\"V\"\r\n"
      "0.00,-1.2,1.5\r\n0.02,-1.4,1.7\r\n0.04,-1.3,1.8\r\n");
  EXPECT_THAT(names_of(header), ElementsAre("CH No.|", "CH2|cm/s2", "CH8|V"));
  EXPECT_EQ(header.fs_Hz, 50);
  EXPECT_EQ(header.lines, 9U);
}

TEST(CsvHeader, LeavesOutTextBesideTheNumbers) {
  const auto header = header_of(
      "CH No.,CH6,CH8,,\nUnit,cm/s2,V,,\n0,21,-3,max,10 m/s2\n0.02,20,-3,mass,2.5 kg\n0.04,19,-2,,\n0.06,19,-2,,\n");
  EXPECT_THAT(names_of(header), ElementsAre("CH No.|", "CH6|cm/s2", "CH8|V"));
}

TEST(CsvHeader, ReadsNamesFromACommentWhereNoOtherLineHasThem) {
  EXPECT_THAT(names_of(header_of("# a record, made today, by me\n# t_s, force_N, acc_g\n0,1,2\n1,2,3\n")),
              ElementsAre("t_s|s", "force_N|N", "acc_g|g"));
  EXPECT_THAT(names_of(header_of("t_s,force_N,acc_g\n# one, two, three\n0,1,2\n1,2,3\n")),
              ElementsAre("t_s|s", "force_N|N", "acc_g|g"));
}

TEST(CsvHeader, ReadsNamesWithBlanksInAlignedText) {
  EXPECT_THAT(names_of(header_of("Time (s)  Force (N)  Acc (g)\n0.0  1.0  2.0\n0.1  1.0  2.0\n")),
              ElementsAre("Time (s)|s", "Force (N)|N", "Acc (g)|g"));
  EXPECT_THAT(names_of(header_of("Time (s) Force (N) Acc (g)\n0.0 1.0 2.0\n0.1 1.0 2.0\n")),
              ElementsAre("Time (s)|s", "Force (N)|N", "Acc (g)|g"));
}

TEST(CsvHeader, NumbersColumnsWhenANameIsEmptyInBlankSeparatedText) {
  EXPECT_THAT(names_of(header_of("t \"\" a\n0 1 2\n1 2 3\n2 3 4\n")),
              ElementsAre("column 1|", "column 2|", "column 3|"));
}

TEST(CsvHeader, NumbersUnnamedColumns) {
  const auto header = header_of("0,1\n1,2\n");
  EXPECT_FALSE(header.named);
  EXPECT_EQ(header.lines, 0U);
  EXPECT_THAT(names_of(header), ElementsAre("column 1|", "column 2|"));
}

TEST(CsvHeader, CountsALineWithAGapAsData) { EXPECT_EQ(header_of("t,f,a\n0,,1\n1,2,3\n2,3,4\n").lines, 1U); }

TEST(CsvHeader, RejectsFrequencyResponses) {
  const std::string latin1 =
      "Frequency\t Real\t Imaginary\t\n\nUnits:\nHz\t(m/s\xB2)(N)\t \n0.0\t 1\t 2\n1.0\t 1\t 2\n";
  EXPECT_EQ(
      test::input_error_of([&] { header_of(latin1); }),
      "frequency, real, imaginary: this is an FRF, not a time record (x.csv); give the time signals it was made from");
  EXPECT_THAT(test::input_error_of([] { header_of("Freq (Hz),Level\n0,1\n1,2\n"); }), HasSubstr("spectrum"));
}

TEST(CsvHeader, ConvertsLatin1ToUtf8AndKeepsUtf8) {
  EXPECT_EQ(to_utf8("m/s\xB2"), "m/s\xC2\xB2");
  EXPECT_EQ(to_utf8("m/s\xC2\xB2"), "m/s\xC2\xB2");
  EXPECT_EQ(to_utf8("\xE2\x82\xAC \xF0\x9F\x98\x80"), "\xE2\x82\xAC \xF0\x9F\x98\x80");
  EXPECT_EQ(to_utf8("\xC0\xAF"), "\xC3\x80\xC2\xAF");  // overlong: not UTF-8
}

}  // namespace percuss::csv_header_test
