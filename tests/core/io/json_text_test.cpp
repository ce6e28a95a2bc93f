#include "core/io/json_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "support/input_error.hpp"

namespace percuss::json_text_test {

using test::input_error_of;
using testing::HasSubstr;

void check(const std::string& text, bool comments = false) {
  parse_json<nlohmann::json>(
      {.text = text, .where = "x.json", .remedy = "write it again", .max_depth = 3, .comments = comments});
}
std::string refusal(const std::string& text) {
  return input_error_of([&] { check(text); });
}

TEST(JsonText, MayBeAnyValue) {
  for (const char* text : {R"({"a": [1, {"b": null}], "c": {"b": "x"}})", "3", "[true, -1, 1e3, []]", "[[[1]]]"})
    EXPECT_NO_THROW(check(text)) << text;
  EXPECT_NO_THROW(check("{\"a\": 1} // one", true));
}

TEST(JsonText, IsRejectedWithThePlaceAndTheRemedy) {
  EXPECT_THAT(refusal("{\"a\": 1} // one"), HasSubstr("not JSON (x.json, byte 10); write it again"));
  for (const char* text : {"", "{", "[1,]", "{\"a\":}", "nul", "\"\xFF\"", "1 2"})
    EXPECT_THAT(refusal(text), HasSubstr("not JSON")) << text;
  EXPECT_THAT(refusal("[1e999]"), HasSubstr("too large"));
  EXPECT_THAT(refusal(R"({"a": 1, "a": 2})"), HasSubstr("key \"a\" is given twice"));
  EXPECT_THAT(refusal("[[[[1]]]]"), HasSubstr("nested deeper than 3"));
  EXPECT_THAT(refusal(std::string(1000000, '[')), HasSubstr("nested deeper"));
}

// The callbacks of json::parse take time proportional to the square of the length: minutes here.
TEST(JsonText, TakesTimeProportionalToItsLength) {
  const auto seconds = [](std::size_t objects) {
    std::string text = "[{}";
    for (std::size_t i = 1; i < objects; ++i) text += ",{}";
    const auto began = std::chrono::steady_clock::now();
    check(text + "]");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  seconds(20000);  // without the time of a first call
  // Ten times the length takes about ten times as long; the square would take a hundred times.
  EXPECT_LT(seconds(400000), 40 * (seconds(40000) + 1e-3));
}

TEST(JsonText, KeepsOnlyTheWantedKeys) {
  constexpr std::array<std::string_view, 2> kWanted{"a", "b"};
  const auto kept = parse_json<nlohmann::json>(
      {.text = R"({"x": {"a": 1}, "a": [1, {"b": "text", "c": [2]}, [3]], "b": null})", .where = "", .remedy = ""},
      kWanted);
  EXPECT_EQ(kept.dump(), R"({"a":[1,{"b":"text"},[3]],"b":null})");
  EXPECT_TRUE(json_if_valid<nlohmann::json>("[1,]", kWanted).is_null());
}

// The reader counts 32 to 43 bytes of values for each byte of these texts, and refuses them. Under a key that is not
// wanted, it skips them.
TEST(JsonText, TakesMemoryInProportionToItsLength) {
  constexpr std::size_t kItems = 4'000'000;
  for (const std::string& item : {std::string("{}"), std::string("0"), std::string("[]")}) {
    std::string text = "[" + item;
    text.reserve((item.size() + 1) * kItems);
    for (std::size_t i = 1; i < kItems; ++i) text.append(",").append(item);
    EXPECT_THAT(refusal(text + "]"), HasSubstr("more memory than")) << item;
    constexpr std::array<std::string_view, 1> kWanted{"a"};
    EXPECT_EQ(
        parse_json<nlohmann::json>({.text = std::string(R"({"b":)") + text + "]}", .where = "", .remedy = ""}, kWanted)
            .dump(),
        "{}");
  }
  std::string keys = "{\"0\":0";
  for (std::size_t i = 1; i <= 10'000; ++i) keys += ",\"" + std::to_string(i) + "\":0";
  EXPECT_THAT(refusal(keys + "}"), HasSubstr("more than 10000 keys"));
}

}  // namespace percuss::json_text_test
