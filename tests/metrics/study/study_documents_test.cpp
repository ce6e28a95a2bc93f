#include "metrics/study/study_documents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::metrics::study_documents_test {

using test::input_error_of;
using testing::HasSubstr;

constexpr const char* kAnalysis = R"({"schema": "percuss/analysis/1", "bat": {"id": "A", "properties": {"maker": "m"}},
  "modes": [{"family": "bending", "order": 1, "frequency_hz": 170.25},
            {"family": "hoop", "order": 1, "frequency_hz": 1970.04}]})";
constexpr const char* kMetrics = R"({"schema": "percuss/metrics/1", "bat": {"id": "A", "properties": {}},
  "profile": {"length_in": 33.0, "weight_oz": 30.0}, "moi_oz_in2": 9600.2, "besr": null, "bbs_mph": null, "bbcor": null})";
constexpr const char* kCertificate = R"({"schema": "percuss/certify/1", "verdict": "pass",
  "bat": {"id": "A", "length_in": 33, "moi_oz_in2": 9600, "weight_oz": null, "material": "composite"},
  "performance": {"z_in": 6, "besr": 0.71384, "ncaa_besr": 0.7138, "bbcor": 0.5, "bbs_mph": 97.1, "v_swing_mph": 66}})";
constexpr const char* kBreakIn = R"({"schema": "percuss/abi/1", "bat": "A", "metric": "besr", "material": "composite",
  "length_in": null, "moi_oz_in2": null, "cycles": [
  {"cycle": 1, "value": 0.7138, "hoop_hz": 1970, "z_in": null, "id": "A"},
  {"cycle": 2, "value": 0.72, "hoop_hz": 1800, "z_in": 6, "id": "A-2"}]})";

std::vector<StudyBat> joined(const std::vector<const char*>& documents) {
  StudyRows rows;
  for (const char* text : documents) rows.add(text, "doc");
  return rows.bats();
}

double value(const StudyBat& bat, StudyQuantity quantity) { return bat.value(quantity).value_or(-1); }

TEST(StudyDocuments, JoinAllTestsOfABat) {
  using enum StudyQuantity;
  const std::vector<std::vector<const char*>> orders{{kAnalysis, kMetrics, kCertificate, kBreakIn},
                                                     {kBreakIn, kCertificate, kMetrics, kAnalysis}};
  for (const auto& order : orders) {
    const auto bats = joined(order);
    ASSERT_EQ(bats.size(), 2U);
    EXPECT_EQ(bats[0].id, "A");
    EXPECT_EQ(bats[0].bat, "A");
    EXPECT_FALSE(bats[0].broken_in);
    EXPECT_EQ(value(bats[0], bending1), 170.25);
    EXPECT_EQ(value(bats[0], hoop1), 1970.04);  // of 1970 and 1970.04, the finer one
    EXPECT_EQ(value(bats[0], moi), 9600.2);
    EXPECT_EQ(value(bats[0], besr), 0.71384);
    EXPECT_EQ(value(bats[0], bbs), 97.1);
    EXPECT_EQ(value(bats[0], drop), -3);
    // A later state has the length, the material, the MOI and the weight of its bat; BBS follows by
    // (P8) of docs/theory/performance.md.
    EXPECT_TRUE(bats[1].broken_in);
    EXPECT_EQ(bats[1].length_in, 33);
    EXPECT_EQ(bats[1].material, BarrelMaterial::composite);
    EXPECT_EQ(value(bats[1], besr), 0.72);
    EXPECT_EQ(value(bats[1], drop), -3);
    const double swing_mph = 60 * 27.0 / 28 * std::pow(15000 / 9600.2, 0.3);
    EXPECT_NEAR(value(bats[1], bbs), 70 * 0.22 + swing_mph * 1.22, 1e-9);
    EXPECT_EQ(value(bats[1], bending1), -1);
  }
}

TEST(StudyDocuments, ListStatesInTheirOrder) {
  const char* const later = R"({"schema": "percuss/analysis/1", "bat": {"id": "A-2", "properties": {}},
    "modes": [{"family": "hoop", "order": 1, "frequency_hz": 1800.2}]})";
  const auto bats = joined({later, kMetrics, kBreakIn});
  ASSERT_EQ(bats.size(), 2U);
  EXPECT_EQ(bats[0].id, "A");
  EXPECT_EQ(bats[1].id, "A-2");
  EXPECT_EQ(value(bats[1], StudyQuantity::hoop1), 1800.2);
}

TEST(StudyDocuments, MarkBatsWhoseModesHaveNoFamily) {
  const char* const one_sensor = R"({"schema": "percuss/analysis/1", "bat": {"id": "A", "properties": {}},
    "modes": [{"family": "unknown", "order": null, "frequency_hz": 200.5}]})";
  const auto states = states_in_document(one_sensor, "doc");
  ASSERT_TRUE(states);
  EXPECT_TRUE(states->at(0).contains(kWithoutFamily));
  EXPECT_FALSE(states_in_document(kAnalysis, "doc")->at(0).contains(kWithoutFamily));
  EXPECT_TRUE(joined({one_sensor, kCertificate})[0].without_family);
  EXPECT_FALSE(joined({one_sensor, kAnalysis, kCertificate})[0].without_family) << "another test states frequencies";
}

TEST(StudyDocuments, TakeNoPerformanceOfAnUnfinishedSession) {
  std::string text = kCertificate;
  text.replace(text.find("\"pass\""), 6, "\"in_progress\"");
  const auto bats = joined({text.c_str()});
  EXPECT_EQ(value(bats[0], StudyQuantity::besr), -1);
  EXPECT_EQ(value(bats[0], StudyQuantity::moi), 9600);
}

TEST(StudyDocuments, ReadAListOfMetrics) {
  const auto states = states_in_document(R"({"schema": "percuss/metrics/1", "bats": [
    {"bat": {"id": "x", "properties": {"material": "wood"}}, "profile": {"length_in": 33}, "besr": 0.7},
    {"bat": {"id": "y", "properties": {}}, "profile": {"length_in": 34}, "besr": 0.71}]})",
                                         "doc");
  ASSERT_TRUE(states && states->size() == 2);
  EXPECT_EQ(states->at(0).at("material"), "wood");
  EXPECT_EQ(states->at(1).at("besr"), "0.71");
}

TEST(StudyDocuments, RejectDocumentsWithoutTheirBatAndContradictions) {
  EXPECT_THAT(input_error_of([] { joined({R"({"schema": "percuss/metrics/1", "besr": 0.7})"}); }),
              HasSubstr("do not name their bat"));
  EXPECT_THAT(input_error_of([] { joined({R"({"schema": "percuss/abi/1", "bat": 3})"}); }),
              HasSubstr("does not name its bat"));
  const char* const other = R"({"schema": "percuss/metrics/1", "bat": {"id": "A"}, "moi_oz_in2": 9601})";
  EXPECT_THAT(input_error_of([&] { joined({kMetrics, other}); }), HasSubstr("two values of moi_oz_in2 for bat A"));
  EXPECT_FALSE(states_in_document("id,length_in\n", "t"));
  EXPECT_FALSE(states_in_document(R"({"schema": "percuss/study-table/1", "bats": []})", "t"));
}

TEST(StudyDocuments, RejectDocumentsOfOtherShapes) {
  const auto error = [](const char* text) { return input_error_of([&] { joined({text}); }); };
  EXPECT_THAT(error(R"({"schema": "percuss/metrics/1", "bats": 3})"), HasSubstr("do not name their bat"));
  EXPECT_THAT(error(R"({"schema": "percuss/metrics/1", "bats": [1]})"), HasSubstr("do not name their bat"));
  EXPECT_THAT(error(R"({"schema": "percuss/certify/1", "bat": []})"), HasSubstr("does not name its bat"));
  EXPECT_THAT(error(R"({"schema": "percuss/certify/1", "bat": {"id": 3}})"), HasSubstr("does not name its bat"));
  EXPECT_THAT(error(R"({"schema": "percuss/analysis/1"})"), HasSubstr("does not name its bat"));
  EXPECT_THAT(error(R"({"schema": 3})"), HasSubstr("not text (doc, schema)"));
}

// A cycle is a state even if its id repeats or is missing.
TEST(StudyDocuments, TakeEachCycleAsAState) {
  const auto same =
      states_in_document(R"({"schema": "percuss/abi/1", "bat": "A", "cycles": [{"id": "A"}, {"id": "A"}, 3]})", "d");
  ASSERT_TRUE(same);
  EXPECT_EQ(same->size(), 3U);
}

}  // namespace percuss::metrics::study_documents_test
