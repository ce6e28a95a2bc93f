#include "acquire/formats/text/json_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/input_error.hpp"

namespace percuss::acquire::json_input_test {

using test::input_error_of;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  return input_error_of([&] { refuse_json(text, "x.json"); });
}

TEST(JsonInput, NamesTheCommandThatReadsTheDocument) {
  for (const auto& [schema, words] :
       std::vector<std::pair<std::string, std::string>>{{"analysis", "percuss compare and percuss study read it"},
                                                        {"model-beam", "percuss compare reads it"},
                                                        {"model-bat", "percuss compare reads it"},
                                                        {"model-impact", "percuss compare reads it"},
                                                        {"model-shell", "percuss compare reads it"},
                                                        {"model-rigid", "no command reads it"},
                                                        {"model-trampoline", "percuss study reads it"},
                                                        {"compare", "a comparison"},
                                                        {"nodes", "the nodes of a scan"},
                                                        {"info", "the description of files"},
                                                        {"calibration", "a calibration"},
                                                        {"study", "the result of a study"},
                                                        {"study-table", "a table of bats"},
                                                        {"batch-manifest", "percuss batch run reads it"},
                                                        {"batch", "a document of a batch"},
                                                        {"batch-status", "a document of a batch"},
                                                        {"batch-part", "the records that the batch's manifest lists"},
                                                        {"synth-presets", "the list of presets"}}) {
    EXPECT_THAT(refusal("{\"schema\": \"percuss/" + schema + "/1\"}"), HasSubstr(words)) << schema;
  }
}

TEST(JsonInput, IsRecognisedBehindCommentsAndAByteOrderMark) {
  EXPECT_THAT(refusal("// the shots of Monday\n{\"schema\": \"percuss/session/1\"}"), HasSubstr("percuss certify"));
  EXPECT_THAT(refusal("\xEF\xBB\xBF[{\"name\": \"CH1\"}]"), HasSubstr("but JSON"));
  EXPECT_THAT(refusal(" [ {\"name\": \"CH1\"}]"), HasSubstr("but JSON"));
}

TEST(JsonInput, IsNoOtherText) {
  for (const char* text : {"", "[Header]\n1,2\n", "1,2\n", "# {\n", "[1,2]"})
    EXPECT_NO_THROW(refuse_json(text, "x.csv"));
}

}  // namespace percuss::acquire::json_input_test
