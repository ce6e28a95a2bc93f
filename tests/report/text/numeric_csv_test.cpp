#include "report/text/numeric_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percuss::report::columns_test {

TEST(NumericCsv, WritesNumbersThatReadBackEqual) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(numeric_csv({{"hoop_hz", {100, 0.1 + 0.2}}, {"cor", {none, -1e-9}}}),
            "hoop_hz,cor\n100,\n0.30000000000000004,-1e-09\n");
}

}  // namespace percuss::report::columns_test
