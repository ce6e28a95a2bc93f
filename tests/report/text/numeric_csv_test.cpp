#include "report/text/numeric_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percuss::report::numeric_csv_test {

TEST(NumericCsv, WritesNumbersThatReadBackEqual) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(numeric_csv({{"hoop_hz", {100, 0.1 + 0.2}}, {"cor", {none, -1e-9}}}),
            "hoop_hz,cor\n100,\n0.30000000000000004,-1e-09\n");
}

TEST(NumericCsv, PutsWordsAfterNumbers) {
  EXPECT_EQ(numeric_csv({{"cor", {0.5, 0.25}}}, {{"bat", {"", "=a,b"}}}, CsvFormulas::neutralise),
            "cor,bat\n0.5,\n0.25,\"'=a,b\"\n");
  EXPECT_EQ(numeric_csv({{"cor", {0.5}}}, {{"bat", {"=a"}}}, CsvFormulas::keep), "cor,bat\n0.5,=a\n");
}

}  // namespace percuss::report::numeric_csv_test
