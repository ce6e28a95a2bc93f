#include "report/json/quantised_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "report/text/digest.hpp"

namespace percuss::report::quantised_curve_test {

TEST(QuantisedCurve, KeepsTheResolutionOfThePlot) {
  const QuantisedCurve numbers = quantised_curve(std::vector<double>{-3, 1, std::nan("")}, 0.5);
  EXPECT_EQ(numbers.from, -3);
  EXPECT_EQ(numbers.step, 0.5);
  const std::vector<std::uint8_t> bytes{0, 0, 8, 0, 255, 255};
  EXPECT_EQ(numbers.u16, base64(bytes));
}

}  // namespace percuss::report::quantised_curve_test
