#include "metrics/protocol/abi_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/text_parts.hpp"

namespace percuss::metrics::abi_log_test {

using test::input_error_of;
using testing::HasSubstr;

TEST(AbiLog, ExampleReadsBackAndFollowsItsSchema) {
  const AbiLog log = parse_abi_log(abi_log_example(), "l.json");
  EXPECT_EQ(log.bat, "AS333");
  EXPECT_EQ(log.entries.size(), 8U);
  EXPECT_THAT(test::schema_violations(test::json_ignoring_comments(abi_log_example()), test::schema_named("abi-log")),
              testing::IsEmpty());
}

TEST(AbiLog, NamesTheKeyThatIsWrong) {
  const auto abi_refusal = [](const std::string& text) {
    return input_error_of([&] { parse_abi_log(text, "l.json"); });
  };
  const std::string ok = abi_log_example();
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "[612, 604, 598, 606]", "[612, 604]")),
              HasSubstr("entries[0].force_lbf"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "[612, 604, 598, 606]", "[612, 604, 5, 1e6]")),
              HasSubstr("load frame"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "\"do\": \"roll\"", "\"do\": \"bend\"")), HasSubstr("entries[3].do"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "\"value\": 0.7138", "\"value\": 7")), HasSubstr("entries[1].value"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "\"depth_in\": 0.1}", "\"depht_in\": 0.1}")),
              HasSubstr("entries[3].depth_in"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "[612, 604, 598, 606]", "[612, 604, -5, 606]")),
              HasSubstr("load frame"));
  EXPECT_TRUE(parse_abi_log(R"({"bat": {"id": "b"}, "metric": "bbcor", "entries": []})", "l.json").bbcor);
  EXPECT_THAT(abi_refusal("{}"), HasSubstr("bat"));
  EXPECT_THAT(abi_refusal(test::replaced_once(ok, "percuss/abi-log/1", "percuss/session/1")),
              HasSubstr("not a log of a break-in"));
  EXPECT_THAT(abi_refusal(R"({"bat": {"id": "b"}, "metric": "speed", "entries": []})"), HasSubstr("no such metric"));
  std::string long_log = R"({"bat": {"id": "b"}, "entries": [)";
  for (int i = 0; i < 10001; ++i) long_log += std::string(i > 0 ? "," : "") + R"({"do": "roll", "depth_in": 0.1})";
  EXPECT_THAT(abi_refusal(long_log + "]}"), HasSubstr("more than 10000 entries"));
}

}  // namespace percuss::metrics::abi_log_test
