#include "report/json/read_document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "metrics/compare.hpp"

namespace percuss::report::read_document_test {

constexpr double kRounding = 1e-12;  // the shapes are exact

// A document with one mode whose residues are A_pc = shape_p * sensors_c.
std::string document_of(const std::vector<double>& shape, const std::vector<double>& sensors,
                        const std::string& roving = "hammer") {
  std::string residues;
  for (std::size_t p = 0; p < shape.size(); ++p) {
    for (std::size_t c = 0; c < sensors.size(); ++c)
      residues += fmt::format(R"({}{{"point": {}, "channel": {}, "re": {}, "im": 0, "std": 0.01}})",
                              residues.empty() ? "" : ", ", p, c, shape[p] * sensors[c]);
  }
  return fmt::format(
      R"({{"schema": "percuss/analysis/1", "roving": "{}", "modes": [{{"frequency_hz": 100, "residues": [{}]}}]}})",
      roving, residues);
}

double mac_of(const std::string& a, const std::string& b) {
  const auto first = parse_documents(a, "a.json"), second = parse_documents(b, "b.json");
  const auto mac = metrics::mac_between(first.at(0).modes.at(0), second.at(0).modes.at(0));
  EXPECT_TRUE(mac.has_value());
  return mac ? mac->value : -1;
}

// The MAC of (1, 2, 3) and (1, 2, 2) is 11²/(14 * 9).
TEST(ReadDocument, ComparesShapesWhateverTheSensorsPlaces) {
  const std::vector<double> shape{1, 2, 3}, other{1, 2, 2};
  EXPECT_NEAR(mac_of(document_of(shape, {1, 0.5}), document_of(shape, {0.5, 1})), 1, kRounding)
      << "the sensors are exchanged";
  EXPECT_NEAR(mac_of(document_of(shape, {1, 0.5}), document_of(other, {-0.2, 1})), 121.0 / 126, kRounding);
  EXPECT_NEAR(mac_of(document_of(shape, {1}), document_of(other, {0.3, 1, 2})), 121.0 / 126, kRounding);
}

TEST(ReadDocument, ComparesTheChannelsOfFewPoints) {
  EXPECT_NEAR(mac_of(document_of({1}, {1, 2, 3}), document_of({1}, {1, 2, 2})), 121.0 / 126, kRounding);
}

TEST(ReadDocument, ComparesTheDirectionsOfARovingSensor) {
  EXPECT_NEAR(mac_of(document_of({1, 1, 1}, {1, 2, 3}, "sensor"), document_of({1, 1, 1}, {1, 2, 2}, "sensor")),
              121.0 / 126, kRounding);
}

// A roving sensor that measures one direction gives one value per point, as a roving hammer or a model does.
TEST(ReadDocument, ComparesTheOneDirectionOfARovingSensorWithOtherTests) {
  EXPECT_NEAR(mac_of(document_of({1, 2, 3}, {1, 0.5}), document_of({1, 2, 2}, {1}, "sensor")), 121.0 / 126, kRounding);
}

TEST(ReadDocument, ReadsOrdersAndConfidences) {
  const auto test = parse_documents(R"({"schema": "percuss/analysis/1", "modes": [)"
                                    R"({"frequency_hz": 100, "family": "bending", "order": 2, "confidence": 0.97},)"
                                    R"({"frequency_hz": 200, "family": "unknown", "order": null, "confidence": 0.4}]})",
                                    "test.json");
  EXPECT_EQ(test.at(0).modes.at(0).order, 2);
  EXPECT_EQ(test.at(0).modes.at(0).confidence, 0.97);
  EXPECT_EQ(test.at(0).modes.at(1).order, 0);
  const auto orders_of = [](const std::string& support) {
    std::vector<int> orders;
    const auto bat = parse_documents(
        R"({"schema": "percuss/model-bat/1", "frequency_hz": [170, 560], "support": {"kind": ")" + support + R"("}})",
        "bat.json");
    for (const metrics::ComparedMode& mode : bat.at(0).modes) orders.push_back(mode.order);
    return orders;
  };
  EXPECT_EQ(orders_of("free"), (std::vector<int>{1, 2}));
  EXPECT_EQ(orders_of("clamped"), (std::vector<int>{0, 0})) << "a held bat has other modes";
}

TEST(ReadDocument, ReadsPlaces) {
  const auto documents =
      parse_documents(R"({"schema": "percuss/analysis/1", "modes": [], "places": [)"
                      R"({"point": 0, "number": 7, "x_m": 0.1, "y_m": 0.2, "z_m": 0.3, "direction": [0, 0, -1]},)"
                      R"({"point": 1, "position_m": 0.5, "angle_deg": 90}, {"point": 2}]})",
                      "test.json");
  const auto& places = documents.at(0).places;
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places.at(0).number, 7);
  EXPECT_EQ(places.at(0).xyz_m, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(places.at(0).direction, (std::array{0.0, 0.0, -1.0}));
  EXPECT_EQ(places.at(1).number, 1);
  ASSERT_TRUE(places.at(1).xyz_m.has_value());
  EXPECT_NEAR(places.at(1).xyz_m->at(0), 0.5, kRounding);
  EXPECT_NEAR(places.at(1).xyz_m->at(1), 0, kRounding);
  EXPECT_FALSE(places.at(2).xyz_m.has_value());
  EXPECT_THROW(
      parse_documents(R"({"schema": "percuss/analysis/1", "modes": [], "places": [{"x_m": 0.1}]})", "test.json"),
      InputError);
}

// A table of these points and channels would take 10^10 cells.
TEST(ReadDocument, TakesTheMemoryOfItsResiduesAlone) {
  std::string residues;
  for (int i = 0; i < 100000; ++i)
    residues += fmt::format(R"({}{{"point": {}, "channel": {}, "re": 1}})", i == 0 ? "" : ", ", i, i);
  const auto documents = parse_documents(
      fmt::format(R"({{"schema": "percuss/analysis/1", "modes": [{{"frequency_hz": 100, "residues": [{}]}}]}})",
                  residues),
      "diagonal.json");
  EXPECT_EQ(documents.at(0).modes.at(0).shape.size(), 100000U);
}

}  // namespace percuss::report::read_document_test
