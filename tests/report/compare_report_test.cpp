#include "report/compare_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::report::compare_report_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

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

TEST(CompareReport, DrawsTheWholeBandsOfTheStandardDeviations) {
  const metrics::ComparedDocument a{
      .name = "a", .schema = "", .modes = {{.freq_Hz = 100, .freq_std_Hz = 3}, {.freq_Hz = 200}}, .deflections = {}};
  const metrics::ComparedDocument b{
      .name = "b", .schema = "", .modes = {{.freq_Hz = 100, .freq_std_Hz = 4}, {.freq_Hz = 202}}, .deflections = {}};
  const LineChart chart = compare_report({a, b}).charts.at(0);
  ASSERT_EQ(chart.bands.size(), 1U);
  EXPECT_THAT(chart.bands[0].low, ElementsAre(testing::DoubleNear(-5, 1e-9), testing::DoubleNear(1, 1e-9)));
  EXPECT_THAT(chart.bands[0].high, ElementsAre(testing::DoubleNear(5, 1e-9), testing::DoubleNear(1, 1e-9)));
  ASSERT_TRUE(chart.y.range);
  EXPECT_LT(chart.y.range->first, -5);
  EXPECT_GT(chart.y.range->second, 5);
}

// Equal parts at another temperature differ by many standard deviations, but by little.
TEST(CompareReport, ShowsSmallDifferencesInPpmAndSaysWhatTheirStdLeavesOut) {
  const auto document = [](std::vector<metrics::ComparedMode> modes) {
    return metrics::ComparedDocument{.name = "a", .schema = "", .modes = std::move(modes), .deflections = {}};
  };
  const auto first = document({{.freq_Hz = 1000, .freq_std_Hz = 1e-4}, {.freq_Hz = 2000, .freq_std_Hz = 2e-4}});
  const auto small = document({{.freq_Hz = 999.902, .freq_std_Hz = 1e-4}, {.freq_Hz = 2000.001, .freq_std_Hz = 2e-4}});
  const CommandReport report = compare_report({first, small});
  const std::string text = report.text.text(400);
  EXPECT_THAT(text, HasSubstr("(-98 ppm, 693 σ"));
  EXPECT_THAT(text, HasSubstr("(+0.50 ppm, 3.5 σ"));
  for (const std::string& shown : {text, report.text.html()})
    EXPECT_THAT(shown, HasSubstr("neither temperature nor support nor mounting of a sensor: to learn how far equal "
                                 "parts differ, test one part twice, remounted"));
  const LineChart& chart = report.charts.at(0);
  EXPECT_THAT(chart.y.label, HasSubstr("difference, ppm"));
  EXPECT_THAT(chart.curves.at(0).y, ElementsAre(testing::DoubleNear(-98, 1e-6), testing::DoubleNear(0.5, 1e-6)));
  EXPECT_LT(chart.y.range->first, -98);

  const CommandReport large = compare_report({first, document({{.freq_Hz = 1010}, {.freq_Hz = 2000}})});
  EXPECT_THAT(large.text.text(400), HasSubstr("(+1.00 %"));
  EXPECT_THAT(large.text.text(400), HasSubstr("(0.00 ppm"));
  EXPECT_THAT(large.text.text(400), Not(HasSubstr("remounted"))) << "no standard deviations";
  EXPECT_THAT(large.charts.at(0).y.label, HasSubstr("difference, %"));
}

// Document a has two modes at four places. The first has the shape of the mode at 101 Hz in b, but for sign and scale;
// the second is orthogonal to it.
TEST(CompareReport, ListsTheMacOfAllModesWithCommonPlaces) {
  const auto mode = [](double freq_Hz, const std::vector<double>& shape) {
    metrics::ComparedMode out{.freq_Hz = freq_Hz};
    for (std::size_t i = 0; i < shape.size(); ++i) out.shape[{static_cast<int>(i), 0}] = {.value = shape[i]};
    return out;
  };
  const metrics::ComparedDocument a{
      .name = "a", .schema = "", .modes = {mode(100, {1, 1, 1, 1}), mode(200, {1, -1, 1, -1})}, .deflections = {}};
  const metrics::ComparedDocument b{
      .name = "b", .schema = "", .modes = {mode(101, {-2, -2, -2, -2}), mode(300, {})}, .deflections = {}};
  const CommandReport report = compare_report({a, b});
  ASSERT_EQ(report.macs.size(), 1U);
  const MacMatrix& matrix = report.macs[0];
  EXPECT_THAT(matrix.rows, ElementsAre("100 Hz", "200 Hz"));
  EXPECT_THAT(matrix.columns, ElementsAre("101 Hz", "300 Hz"));
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(matrix.values[0][0].value(), 1, kRounding);
  EXPECT_NEAR(matrix.values[1][0].value(), 0, kRounding);
  EXPECT_FALSE(matrix.values[0][1].has_value());
  EXPECT_TRUE(
      compare_report({b, {.name = "c", .schema = "", .modes = {mode(300, {})}, .deflections = {}}}).macs.empty());
}

// Points that are numbered from 0 in one test and from 1 in the other: equal numbers are other places.
TEST(CompareReport, SaysThatModesAgreeInFrequencyButNotInShape) {
  const auto with_shape = [](std::vector<double> shape) {
    metrics::ComparedMode mode{.freq_Hz = 100, .family = "", .shape = {}};
    for (std::size_t p = 0; p < shape.size(); ++p) mode.shape[{static_cast<int>(p), -1}] = {.value = shape[p]};
    return metrics::ComparedDocument{.name = "test.json", .schema = "", .modes = {mode}, .deflections = {}};
  };
  const auto text = [](const metrics::ComparedDocument& a, const metrics::ComparedDocument& b) {
    return compare_report({a, b}).text.text(200);
  };
  const auto first = with_shape({1, 0, -1});
  EXPECT_THAT(text(first, with_shape({0, 1, 0})),
              HasSubstr("1 mode without a partner agrees in frequency within 1 % with a mode of test.json, but not in "
                        "shape"));
  EXPECT_THAT(text(first, with_shape({1, 0, -1})), Not(HasSubstr("in shape")));
  auto distant = with_shape({0, 1, 0});
  distant.modes[0].freq_Hz = 110;
  EXPECT_THAT(text(first, distant), Not(HasSubstr("in shape")));
}

TEST(CompareReport, NamesModesOfEqualShapesThatAreTooFarApart) {
  const auto with_mode = [](const char* name, double freq_Hz) {
    metrics::ComparedMode mode{.freq_Hz = freq_Hz, .family = "", .shape = {}};
    for (int p = 0; p < 3; ++p) mode.shape[{p, -1}] = {.value = 1.0 + p};
    return metrics::ComparedDocument{.name = name, .schema = "", .modes = {mode}, .deflections = {}};
  };
  const CommandReport report = compare_report({with_mode("before.json", 128.4), with_mode("after.json", 171.9)});
  EXPECT_THAT(report.text.text(200), HasSubstr("modes of equal shapes are too far apart to pair: 128.4 and 171.9 Hz "
                                               "(MAC 1.00, 34 % apart, paired with 40 %); allow a larger difference"));
  EXPECT_THAT(report.text.html(), HasSubstr("modes of equal shapes are too far apart"));
  EXPECT_THAT(report.json, HasSubstr("\"furthest_percent\": 40"));
  EXPECT_THAT(compare_report({with_mode("before.json", 128.4), with_mode("after.json", 129)}).text.text(200),
              Not(HasSubstr("equal shapes")));
}

TEST(CompareReport, SaysOnceWhatHoldsOfSeveralDocuments) {
  const auto document = [](const std::string& name, std::vector<double> freq_Hz) {
    metrics::ComparedDocument out{.name = name, .schema = "", .modes = {}, .deflections = {}};
    for (const double f : freq_Hz) out.modes.push_back({.freq_Hz = f, .family = "", .shape = {}});
    return out;
  };
  const auto a = document("a.json", {200, 500}), b = document("b.json", {201, 503}), c = document("c.json", {202, 504});
  auto d = document("d.json", {202, 504});
  const std::string all = compare_report({a, b, c, d}).text.text(200);
  EXPECT_THAT(all, HasSubstr("modes are paired with the modes of all others by frequency"));
  EXPECT_EQ(all.find("by frequency"), all.rfind("by frequency"));
  for (metrics::ComparedMode& mode : d.modes) {
    mode.family = "bending";
    mode.order = mode.freq_Hz < 300 ? 1 : 2;
    mode.confidence = 1;
  }
  auto ordered = a;
  for (std::size_t m = 0; m < 2; ++m) {
    ordered.modes[m].family = "bending";
    ordered.modes[m].order = static_cast<int>(m) + 1;
    ordered.modes[m].confidence = 1;
  }
  const std::string text = compare_report({ordered, b, d, c}).text.text(200);
  EXPECT_THAT(text, HasSubstr("modes are paired with the modes of b.json, c.json by frequency"));
  EXPECT_THAT(text, HasSubstr("modes are paired with the modes of d.json by family and order"));
  EXPECT_EQ(text.find("by frequency"), text.rfind("by frequency"));
}

TEST(CompareReport, SaysThatModesArePairedByFrequencyAlone) {
  const auto document = [](const std::string& name, const std::vector<double>& freq_Hz) {
    metrics::ComparedDocument out{.name = name, .schema = "", .modes = {}, .deflections = {}};
    for (const double f : freq_Hz) out.modes.push_back({.freq_Hz = f, .family = "", .shape = {}});
    return out;
  };
  const auto text = [](const std::vector<metrics::ComparedDocument>& documents) {
    return compare_report(documents).text.text(200);
  };
  const auto before = document("before.json", {412, 418.5, 574}), after = document("after.json", {421.3, 431, 560});
  const std::string crossed = text({before, after});
  EXPECT_THAT(crossed, HasSubstr("modes are paired by frequency (fewer than 3 common points): modes that crossed "
                                 "are exchanged\n"));
  EXPECT_THAT(crossed, HasSubstr("modes 1 and 2 may be exchanged: they lie no further apart than they moved\n"));
  EXPECT_THAT(compare_report({before, after}).json, HasSubstr("\"paired_by\": \"frequency\""));
  EXPECT_THAT(text({before, before}), Not(HasSubstr("may be exchanged")));
  EXPECT_THAT(text({before, before, after}), HasSubstr("modes are paired with the modes of all others by frequency"));
  EXPECT_THAT(text({before, before, after}), HasSubstr("modes 1 and 2 may be exchanged in after.json: they lie"));
  auto shapes = before;
  for (metrics::ComparedMode& mode : shapes.modes) {
    for (int p = 0; p < 3; ++p) mode.shape[{p, -1}] = {.value = 1 + p * mode.freq_Hz};
  }
  EXPECT_THAT(text({shapes, shapes}), Not(HasSubstr("by frequency")));
}

TEST(CompareReport, StatesOrdersAndTheRuleThatPaired) {
  const auto mode = [](const char* family, int order, double freq_Hz) {
    return metrics::ComparedMode{
        .freq_Hz = freq_Hz, .family = family, .order = order, .confidence = order > 0 ? 0.99 : 0, .shape = {}};
  };
  const metrics::ComparedDocument a{
      .name = "a.json",
      .schema = "",
      .modes = {mode("bending", 1, 170), mode("bending", 2, 500), mode("bending", 2, 510), mode("unknown", 0, 900)},
      .deflections = {}};
  const metrics::ComparedDocument b{
      .name = "b.json",
      .schema = "",
      .modes = {mode("bending", 1, 172), mode("bending", 2, 520), mode("bending", 3, 950), mode("bending", 4, 1500)},
      .deflections = {}};
  const CommandReport report = compare_report({a, b});
  const std::string text = report.text.text(200);
  EXPECT_THAT(text, testing::ContainsRegex("2  bending 2a +500 Hz +520 Hz, bending 2 \\("));
  EXPECT_THAT(text, testing::ContainsRegex("3  bending 2b +510 Hz +–"));
  EXPECT_THAT(text, testing::ContainsRegex("4  unknown +900 Hz +950 Hz, bending 3 \\("));
  EXPECT_THAT(text, testing::ContainsRegex("1  bending 1 +170 Hz +172 Hz \\("));
  EXPECT_THAT(text, HasSubstr("2 of 3 modes are paired by family and order (fewer than 3 common points)\n"));
  EXPECT_THAT(text, HasSubstr("1 of 3 modes is paired by frequency"));
  EXPECT_THAT(text, HasSubstr("only in b.json: 1500 Hz (bending 4)\n"));
  EXPECT_THAT(report.json, HasSubstr("\"paired_by\": \"order\""));
  EXPECT_THAT(report.json, HasSubstr("\"order_b\": 2"));
  ASSERT_EQ(report.words.size(), 3U);
  EXPECT_THAT(report.words[0].values, ElementsAre("bending 1", "bending 2a", "bending 2b", "unknown"));
  EXPECT_THAT(report.words[1].values, ElementsAre("bending 1", "bending 2", "", "bending 3"));
  EXPECT_THAT(report.words[2].values, ElementsAre("order", "order", "", "frequency"));
}

TEST(CompareReport, SaysThatFrequenciesContradictOrders) {
  const auto document = [](const std::string& name, const std::vector<double>& freq_Hz) {
    metrics::ComparedDocument out{.name = name, .schema = "", .modes = {}, .deflections = {}};
    for (const double f : freq_Hz) {
      out.modes.push_back({.freq_Hz = f,
                           .family = "bending",
                           .order = static_cast<int>(out.modes.size()) + 1,
                           .confidence = 1,
                           .shape = {}});
    }
    return out;
  };
  const CommandReport report =
      compare_report({document("a.json", {175, 660, 1322, 2217}), document("b.json", {175, 660, 2200})});
  EXPECT_THAT(report.text.text(200), HasSubstr("the frequencies contradict the orders of bending modes from 3 on, as "
                                               "where one test lacks a mode: these orders are not used\n"));
  EXPECT_THAT(report.json, HasSubstr("\"from_order\": 3"));
}

TEST(CompareReport, SaysHowPointsWereMatched) {
  const auto document = [](const std::string& name, int first, std::size_t points, double scale) {
    metrics::ComparedDocument out{.name = name, .schema = "", .modes = {}, .deflections = {}};
    metrics::ComparedMode mode{.freq_Hz = 100, .shape = {}};
    for (std::size_t i = 0; i < points; ++i) {
      const int point = first + static_cast<int>(i);
      mode.shape[{point, -1}] = {.value = 1.0 + static_cast<double>(i), .std = 0};
      if (scale > 0)
        out.places[point] = {
            .number = point, .xyz_m = std::array{0.1 + scale * static_cast<double>(i), 0.0, 0.0}, .direction = {}};
    }
    out.modes = {mode};
    return out;
  };
  const auto report_of = [&](const metrics::ComparedDocument& b) {
    return compare_report({document("a.json", 0, 5, 0.1), b});
  };
  const CommandReport by_place = report_of(document("b.json", 10, 4, 0.1));
  EXPECT_THAT(by_place.text.text(200), HasSubstr("points are matched by their coordinates: 4 in both, of 5 and 4\n"));
  EXPECT_THAT(by_place.text.text(200), HasSubstr("MAC 1.000"));
  EXPECT_THAT(by_place.json, HasSubstr("\"matched_by\": \"coordinates\""));
  const CommandReport other_unit = report_of(document("b.json", 1, 5, 100));
  EXPECT_THAT(other_unit.text.text(200), HasSubstr("the coordinates of the points do not agree"));
  EXPECT_THAT(other_unit.text.text(200), HasSubstr("matched by their sequence, since one document counts from 0"));
  EXPECT_THAT(report_of(document("b.json", 0, 5, 0)).text.text(200),
              HasSubstr("points are matched by their numbers: 5 in both\n"));
}

}  // namespace percuss::report::compare_report_test
