#include "metrics/study/study_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "metrics/study/study_files.hpp"
#include "support/input_error.hpp"
#include "synth/population.hpp"

namespace percuss::metrics::study_table_test {

using test::input_error_of;
using testing::HasSubstr;

StudyRows rows_of(const std::string& text, const std::string& more = {}) {
  StudyRows rows;
  rows.add(text, "t.csv");
  if (!more.empty()) rows.add(more, "m.json");
  return rows;
}

TEST(StudyTable, ReadsBackWhatItWrites) {
  const auto bats = synth::synthetic_population({.wood = 5, .aluminum = 5, .composite = 5});
  const std::string text = study_table_csv(bats);
  EXPECT_EQ(study_table_csv(rows_of(text).bats()), text);
}

TEST(StudyTable, JoinsAnalysesById) {
  const std::string table = "id,length_in,material,besr,moi_oz_in2\nA1,33,composite,0.72,9800\n";
  const std::string analysis =
      R"({"schema": "percuss/analysis/1", "bat": {"id": "A1", "properties": {"condition": "abi",
    "maker": "M", "shelf": "left"}}, "modes": [{"family": "bending", "order": 1, "frequency_hz": 170.5},
    {"family": "hoop", "order": 1, "frequency_hz": 1900}, {"family": "hoop", "order": 1, "frequency_hz": 1912},
    {"family": "unknown", "order": null, "frequency_hz": 800}]})";
  const auto bats = rows_of(table, analysis).bats();
  ASSERT_EQ(bats.size(), 1U);
  EXPECT_EQ(bats[0].value(StudyQuantity::hoop1), 1900);
  EXPECT_EQ(bats[0].value(StudyQuantity::bending1), 170.5);
  EXPECT_EQ(bats[0].value(StudyQuantity::besr), 0.72);
  EXPECT_TRUE(bats[0].broken_in);
  EXPECT_EQ(bats[0].maker, "M");
}

TEST(StudyTable, ComputesDerivedQuantities) {
  const auto bats =
      rows_of("id,length_in,material,weight_oz,moi_oz_in2,besr,z_in\na,34,aluminum,31,10450,0.728,6\n").bats();
  EXPECT_EQ(bats[0].value(StudyQuantity::drop), -3);
  EXPECT_NEAR(*bats[0].value(StudyQuantity::bbcor), 0.519706, 5e-7);  // half of the last printed digit
  EXPECT_TRUE(bats[0].value(StudyQuantity::bbs));
}

TEST(StudyTable, RefusesInvalidValues) {
  const auto refusal = [](const std::string& text, const std::string& more = {}) {
    return input_error_of([&] { rows_of(text, more).bats(); });
  };
  EXPECT_THAT(refusal("id,length_in,material,speed\na,33,wood,3\n"), HasSubstr("unknown key"));
  EXPECT_THAT(refusal("id,length_in,material\na,33,paper\n"), HasSubstr("no such material"));
  EXPECT_THAT(refusal("id,material\na,wood\n"), HasSubstr("no length"));
  EXPECT_THAT(refusal("id,length_in,material,besr\na,33,wood,x\n"), HasSubstr("besr"));
  EXPECT_THAT(refusal("id,length_in,material,hoop1_hz\na,33,wood,-5\n"), HasSubstr("hoop1_hz is -5"));
  EXPECT_THAT(refusal("id,length_in,material\n,33,wood\n"), HasSubstr("without an id"));
  EXPECT_THAT(refusal("id,length_in,material\na,33,wood\na,34,wood\n"), HasSubstr("two values of length_in"));
  EXPECT_THAT(refusal("id,length_in,material\na,33,wood\na,33.4,wood\n"), HasSubstr("two values of length_in"));
  EXPECT_THAT(refusal("id,length_in,material,condition\na,33,wood,old\n"), HasSubstr("condition"));
  EXPECT_THAT(refusal("{\"schema\": \"percuss/analysis/1\"}"), HasSubstr("does not name its bat"));
  EXPECT_THAT(refusal("{\"schema\": \"percuss/analysis/1\", \"runs\": []}"), HasSubstr("several tests"));
  EXPECT_THAT(refusal("{\"schema\": \"percuss/info/1\"}"), HasSubstr("not a table of bats"));
  EXPECT_THAT(refusal("{\"bats\": " + std::string(100000, '[')), HasSubstr("nested deeper"));
  EXPECT_THAT(refusal(""), HasSubstr("t.csv"));
  EXPECT_THAT(refusal("id,length_in,material\n"), HasSubstr("no bats"));
  EXPECT_THAT(refusal("//\"\n{\"schema\": \"percuss/analysis/1\", \"a\": " + std::string(100000, '[')),
              HasSubstr("nested deeper"));
}

}  // namespace percuss::metrics::study_table_test
