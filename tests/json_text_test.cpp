#include "acquire/json_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "support/input_error.hpp"

namespace percuss::json_text_test {

using test::input_error_of;
using testing::HasSubstr;

nlohmann::json parse(const std::string& text, bool comments = false) {
  return parse_json(
      {.text = text, .where = "x.json", .remedy = "write it again", .max_depth = 3, .comments = comments});
}
std::string refusal(const std::string& text) {
  return input_error_of([&] { parse(text); });
}

TEST(JsonText, BecomesItsValue) {
  EXPECT_EQ(parse(R"({"a": [1, {"b": null}], "c": {"b": "x", "d": 2.5}})")["c"]["d"], 2.5);
  EXPECT_EQ(parse("3"), 3);
  EXPECT_EQ(parse("{\"a\": 1} // one", true)["a"], 1);
}

TEST(JsonText, IsRefusedWithThePlaceAndTheRemedy) {
  EXPECT_THAT(refusal("{\"a\": 1} // one"), HasSubstr("not JSON (x.json, byte 10); write it again"));
  for (const char* text : {"", "{", "[1,]", "{\"a\":}", "nul", "\"\xFF\"", "1 2"})
    EXPECT_THAT(refusal(text), HasSubstr("not JSON")) << text;
  EXPECT_THAT(refusal("[1e999]"), HasSubstr("too large"));
  EXPECT_THAT(refusal(R"({"a": 1, "a": 2})"), HasSubstr("key \"a\" is given twice"));
  EXPECT_THAT(refusal("[[[[1]]]]"), HasSubstr("nested deeper than 3"));
  EXPECT_EQ(parse("[[[1]]]").size(), 1U);
  EXPECT_THAT(refusal(std::string(1000000, '[')), HasSubstr("nested deeper"));
}

// With the library's callbacks this took minutes: the square of the length.
TEST(JsonText, TakesTimeAsItsLength) {
  const auto seconds = [](std::size_t objects) {
    std::string text = "[{}";
    for (std::size_t i = 1; i < objects; ++i) text += ",{}";
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(parse(text + "]").size(), objects);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  seconds(20000);  // what the first call alone takes
  // A tenfold length takes some tenfold time; its square would be a hundredfold.
  EXPECT_LT(seconds(400000), 40 * (seconds(40000) + 1e-3));
}

}  // namespace percuss::json_text_test
