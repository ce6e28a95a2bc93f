#include "core/io/number_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::number_table_test {

using testing::ElementsAre;

std::vector<std::vector<double>> values_of(const std::string& text) {
  std::vector<std::vector<double>> out;
  for (const NumberTableRow& row : parse_number_table(text, "table", {.columns = 2, .remedy = "give two numbers"}))
    out.push_back(row.values);
  return out;
}

TEST(NumberTable, SkipsLeadingNames) {
  EXPECT_THAT(values_of("end,diameter\n0.02,0.05\n0.4,0.026\n"),
              ElementsAre(ElementsAre(0.02, 0.05), ElementsAre(0.4, 0.026)));
}

TEST(NumberTable, TakesNoRowWithDecimalCommasForNames) {
  EXPECT_THAT(values_of("end;diameter\n0,02;0,05\n0,4;0,026\n"),
              ElementsAre(ElementsAre(0.02, 0.05), ElementsAre(0.4, 0.026)));
  EXPECT_THAT(values_of("0,02;0,05\n0,4;0,026\n1;0,066\n"),
              ElementsAre(ElementsAre(0.02, 0.05), ElementsAre(0.4, 0.026), ElementsAre(1, 0.066)));
}

}  // namespace percuss::number_table_test
