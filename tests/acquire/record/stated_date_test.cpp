#include "acquire/record/stated_date.hpp"

#include <gtest/gtest.h>

namespace percuss::acquire::stated_date_test {

TEST(StatedDate, IsTheThirdLineOfADataSet58) {
  EXPECT_EQ(stated_date("    -1\n    58\nhit 1\nNONE\n20-NOV-26 14:03:22\nNONE\nNONE\n    1  0\n"),
            "20-NOV-26 14:03:22");
  EXPECT_EQ(stated_date("    -1\r\n    58b     1     2\r\na\r\nb\r\n20-NOV-26\r\n"), "20-NOV-26");
  EXPECT_EQ(stated_date("    -1\n    58\nhit 1\nNONE\nNONE\nNONE\n"), "");
}

TEST(StatedDate, IsInTheHeadOfAText) {
  EXPECT_EQ(stated_date("# Date: 2026-11-20\n# operator: x\ntime,force\n0,1\n"), "2026-11-20");
  EXPECT_EQ(stated_date("\"Test date\",\"20.11.2026\"\n"), "20.11.2026");
  EXPECT_EQ(stated_date("LabVIEW Measurement\nDate\t2026/11/20\nTime\t14:03:22,123\n"), "2026/11/20 14:03:22");
  EXPECT_EQ(stated_date("time_s,force_N\n0,1\n"), "");
  EXPECT_EQ(stated_date("update: 2026\n"), "") << "another word";
}

TEST(StatedDate, IsInTheHeaderOfAMatFile) {
  EXPECT_EQ(stated_date("MATLAB 5.0 MAT-file, Platform: GLNXA64, Created on: Fri Nov 20 14:03:22 2026      "),
            "Fri Nov 20 14:03:22 2026");
}

TEST(StatedDate, IsInTheChunksOfASoundFile) {
  const std::string head("RIFF\0\0\0\0WAVE", 12);
  EXPECT_EQ(stated_date(head + std::string("LIST\x16\0\0\0INFOICRD\x0A\0\0\0", 20) + "2026-11-20"), "2026-11-20");
  std::string bext(602, '\0');
  bext.replace(320, 18, "2026-11-2014:03:22");
  EXPECT_EQ(stated_date(head + std::string("bext\x5A\x02\0\0", 8) + bext), "2026-11-20 14:03:22");
  EXPECT_EQ(stated_date(head + std::string("LIST\xFF\xFF\xFF\xFFINFOICRD\xFF\xFF\xFF\xFF", 20)), "");
}

TEST(StatedDate, IsNoTextThatNobodyShouldPrint) {
  EXPECT_EQ(stated_date("Date: \x1b[31m2026\n"), "");
  EXPECT_EQ(stated_date("Date: " + std::string(100, '1') + "\n"), "");
  EXPECT_EQ(stated_date_of_file("-"), "");
  EXPECT_EQ(stated_date_of_file("/nowhere/at/all"), "");
}

}  // namespace percuss::acquire::stated_date_test
