#include "core/io/thousands_separators.hpp"

#include <gtest/gtest.h>

namespace percuss::thousands_separators_test {

std::string found_in(const std::string& text, char delimiter) {
  const auto probes = probe_lines(text, '\n');
  return cell_with_thousands_separators(text, probes, {.delimiter = delimiter, .quoted = true});
}

std::string table_of(const std::vector<std::string>& cells, const std::string& before) {
  std::string text = "Time,Force\n";
  for (const std::string& cell : cells) text += before + cell + "\n";
  return text;
}

TEST(ThousandsSeparators, AreFoundBesideSmallWholeNumbers) {
  EXPECT_EQ(found_in(table_of({"\"999\"", "\"1,040\"", "\"87\"", "\"2,310\"", "\"-5,040\"", "\"0\""}, "0.1,"), ','),
            "-5,040");
  EXPECT_NE(found_in(table_of({"0", "-14.024", "3", "-1.200", "12", "5.001"}, "1;"), ';'), "");
}

TEST(ThousandsSeparators, AreFoundInQuotesBetweenCommas) {
  EXPECT_EQ(found_in(table_of({"\"5,031\"", "\"4,850\"", "\"5,027\""}, "\"499,907\","), ','), "499,907");
  EXPECT_EQ(found_in(table_of({"\"0,031\"", "\"4,850\"", "\"5,027\""}, "1,"), ','), "") << "below one";
}

TEST(ThousandsSeparators, AreFoundBesideADecimalMark) {
  EXPECT_EQ(found_in(table_of({"\"19,013.53\"", "\"1,013.5\"", "\"2,000.25\"", "\"3.25\""}, "1,"), ','), "2,000.25");
  EXPECT_NE(found_in(table_of({"19.013,53", "1.013,5", "2.000,25"}, "1;"), ';'), "");
  EXPECT_NE(found_in(table_of({"19'013.53", "1'013", "2'000", "1"}, "1;"), ';'), "");
  EXPECT_NE(found_in(table_of({"1,000,000", "2,000,001", "3,000,002"}, "1;"), ';'), "");
}

TEST(ThousandsSeparators, AreNoDecimalMarks) {
  EXPECT_EQ(found_in(table_of({"0,125", "1,250", "12", "-2,125", "3", "4,500", "7"}, "1;"), ';'), "") << "below one";
  EXPECT_EQ(found_in(table_of({"1,250", "2,125", "4,500", "3,000"}, "1;"), ';'), "") << "no whole numbers";
  EXPECT_EQ(found_in(table_of({"1.250", "2", "4.5", "3", "5.125", "1", "2.333"}, "1;"), ';'), "") << "other decimals";
  EXPECT_EQ(found_in(table_of({"1.250e3", "1.000e1", "2.000e2", "1", "2", "3"}, "1;"), ';'), "") << "exponents";
  EXPECT_EQ(found_in(table_of({"1.250", "2", "3"}, "1;"), ';'), "") << "too few";
}

}  // namespace percuss::thousands_separators_test
