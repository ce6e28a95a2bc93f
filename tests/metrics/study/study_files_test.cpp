#include "metrics/study/study_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::metrics::study_files_test {

using test::input_error_of;
using testing::HasSubstr;

TEST(Blinding, RemovesNamesAndReturnsTheKey) {
  std::vector<StudyBat> bats{{.id = "Slug 5", .bat = "Slug", .maker = "Acme, Inc.", .model = "X\"5", .length_in = 33},
                             {.id = "Slug 6", .bat = "Slug", .maker = "Acme, Inc.", .length_in = 33},
                             {.id = "Twig", .length_in = 34}};
  const std::string key = anonymise_bats(bats);
  EXPECT_EQ(bats[0].id, "AS001");
  EXPECT_EQ(bats[1].bat, "AS001");
  EXPECT_EQ(bats[2].bat, "");
  EXPECT_EQ(key,
            "neutral,id,bat,maker,model\nAS001,Slug 5,Slug,\"Acme, Inc.\",\"X\"\"5\"\nAS002,Slug 6,Slug,\"Acme, "
            "Inc.\",\nAS003,Twig,,,\n");
  EXPECT_THAT(study_table_csv(bats), testing::Not(testing::AnyOf(HasSubstr("Slug"), HasSubstr("Acme"))));
}

TEST(StudyCurve, ReadsATrampolineModel) {
  const auto curve = parse_study_curve(
      R"({"schema": "percuss/model-trampoline/1", "wall_cor": 0.48, "curve": [{"hoop_hz": 1000, "cor": 0.5}, {"hoop_hz": 2000, "cor": 0.49}]})",
      "m.json");
  EXPECT_EQ(curve.hoop_Hz.size(), 2U);
  for (const char* text :
       {"", "[]", "{}", R"({"schema": "percuss/model-trampoline/1", "curve": [3]})",
        R"({"schema": "percuss/model-trampoline/1", "curve": []})",
        R"({"schema": "percuss/model-trampoline/1", "curve": [{"hoop_hz": 2, "cor": 1}, {"hoop_hz": 1, "cor": 1}]})"})
    EXPECT_THAT(input_error_of([&] { parse_study_curve(text, "m.json"); }), HasSubstr("m.json"));
}

}  // namespace percuss::metrics::study_files_test
