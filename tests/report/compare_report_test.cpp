#include "report/compare_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::report::compare_report_test {

using testing::ElementsAre;

// The chart of deflections at two places. An unset position or point is unknown.
LineChart chart_of_places(std::vector<metrics::ComparedDeflection> places) {
  metrics::ComparedDocument document{.name = "a", .schema = "", .modes = {}, .deflections = std::move(places)};
  return compare_report({document, document}).charts.at(0);
}

TEST(CompareReport, DrawsDeflectionsOverAScaleThatAllPlacesHave) {
  const LineChart positions =
      chart_of_places({{.point = 5, .position_m = 0.1, .peak_m = 1}, {.position_m = 0.2, .peak_m = 2}});
  EXPECT_EQ(positions.x.label, "position, m");
  EXPECT_THAT(positions.curves.at(0).x, ElementsAre(0.1, 0.2));

  const LineChart points = chart_of_places({{.point = 5, .position_m = 0.1, .peak_m = 1}, {.point = 7, .peak_m = 2}});
  EXPECT_EQ(points.x.label, "point");
  EXPECT_THAT(points.curves.at(1).x, ElementsAre(5, 7));

  const LineChart order = chart_of_places({{.position_m = 0.1, .peak_m = 1}, {.point = 7, .peak_m = 2}});
  EXPECT_EQ(order.x.label, "place in the table");
  EXPECT_THAT(order.curves.at(0).x, ElementsAre(1, 2));
  EXPECT_THAT(order.curves.at(1).y, ElementsAre(1000, 2000));
}

}  // namespace percuss::report::compare_report_test
