#include "metrics/study/study_batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace percuss::metrics::study_batch_test {

using testing::ElementsAre;
using testing::Pair;

constexpr const char* kHead = "{\"schema\":\"percuss/batch/1\",\"records\":2}\n";

std::string mode(const std::string& id, const std::string& family, const std::string& order, double freq_Hz) {
  return R"({"row":"mode","id":")" + id + R"(","frequency_hz":)" + std::to_string(freq_Hz) + R"(,"family":")" + family +
         R"(","order":)" + order + "}\n";
}

TEST(StudyBatch, TakesTheFirstFrequencyOfEachKind) {
  const std::string text =
      kHead + std::string("{\"row\":\"record\",\"id\":\"a\"}\n") + mode("a", "bending", "1", 170.5) +
      mode("a", "hoop", "1", 1900.25) + mode("a", "hoop", "1", 1912) + mode("a", "unknown", "null", 2000) +
      mode("a", "hoop", "7", 3000) + "{\"row\":\"record\",\"id\":\"none\"}\n" + mode("b", "bending", "2", 600);
  ASSERT_TRUE(holds_batch(text));
  EXPECT_THAT(batch_bats(text, "t"),
              ElementsAre(ElementsAre(Pair("bending1_hz", "170.5"), Pair("hoop1_hz", "1900.25"), Pair("id", "a")),
                          ElementsAre(Pair("bending2_hz", "600"), Pair("id", "b"))));
}

TEST(StudyBatch, ReadsTheSameFromATable) {
  const std::string text =
      "row,id,path,family,order,frequency_hz,reason\nrecord,a,p,,,,\"no, \"\"x\"\"\"\nmode,a,p,hoop,1,1900.25,\n"
      "mode,a,p,unknown,,2000,\n";
  ASSERT_TRUE(holds_batch(text));
  EXPECT_THAT(batch_bats(text, "t"), ElementsAre(ElementsAre(Pair("hoop1_hz", "1900.25"), Pair("id", "a"))));
}

TEST(StudyBatch, MarksBatsWhoseModesHaveNoFamily) {
  const std::string lines = kHead + mode("a", "unknown", "null", 200) + mode("a", "unknown", "null", 530) +
                            mode("b", "unknown", "null", 200) + mode("b", "bending", "1", 210);
  EXPECT_THAT(batch_bats(lines, "t"), ElementsAre(ElementsAre(Pair("id", "a"), Pair(kWithoutFamily, "")),
                                                  ElementsAre(Pair("bending1_hz", "210"), Pair("id", "b"))));
  const std::string table = "row,id,family,order,frequency_hz\nmode,a,unknown,,200\n";
  EXPECT_THAT(batch_bats(table, "t"), ElementsAre(ElementsAre(Pair("id", "a"), Pair(kWithoutFamily, ""))));
}

// The table of the bats states the frequency of b, so that nothing is lost.
TEST(StudyBatch, LeavesTheMarkToBatsOfWhichNoTableStatesAFrequency) {
  StudyRows rows;
  rows.add("id,length_in,material,bending1_hz\na,33,wood,\nb,33,wood,201\n", "bats");
  rows.add(kHead + mode("a", "unknown", "null", 200) + mode("b", "unknown", "null", 201), "batch");
  const std::vector<StudyBat> bats = rows.bats();
  ASSERT_EQ(bats.size(), 2U);
  EXPECT_TRUE(bats[0].without_family);
  EXPECT_FALSE(bats[1].without_family);
}

TEST(StudyBatch, DoesNotRecogniseOtherTexts) {
  EXPECT_FALSE(holds_batch("id,length_in\na,33\n"));
  EXPECT_FALSE(holds_batch("{\"schema\": \"percuss/analysis/1\"}"));
  EXPECT_FALSE(holds_batch(""));
  EXPECT_FALSE(holds_batch("{"));
}

TEST(StudyBatch, NamesTheInvalidLine) {
  for (const std::string& line : {std::string("nonsense"), std::string("{}"), std::string("[[[[1]]]]"),
                                  std::string(R"({"row":"mode","id":3,"order":1})")}) {
    try {
      batch_bats(kHead + line + "\n", "t");
      ADD_FAILURE() << line;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr("t, line 2"));
    }
  }
}

}  // namespace percuss::metrics::study_batch_test
