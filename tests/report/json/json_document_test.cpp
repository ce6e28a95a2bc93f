#include "report/json/json_document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/parallel/parallel.hpp"

namespace percuss::report::json_document_test {

using Json = nlohmann::ordered_json;

JsonDocument::Value text_of(const Json& json) {
  return [json] { return indented_text(json); };
}

// The reference is the text that the JSON library writes.
TEST(JsonDocument, EqualsTheLibrarysTextOnAnyNumberOfThreads) {
  const Json nested{{"list", {1, 2.5, "a\nb \"quoted\""}}, {"empty", Json::object()}, {"none", Json::array()}};
  Json expected{{"name", "x"}, {"nested", nested}, {"elements", Json::array()}, {"nothing", Json::array()}};
  for (int i = 0; i < 500; ++i) expected["elements"].push_back({{"i", i}, {"nested", nested}});
  expected["last"] = nullptr;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const ThreadLimit limit(threads);
    JsonDocument document;
    document.add("name", text_of("x"));
    document.add("nested", text_of(nested));
    document.add("elements", 500, [&](std::size_t i) { return indented_text(expected["elements"][i]); });
    document.add("nothing", 0, [](std::size_t) { return std::string(); });
    document.add("last", text_of(nullptr));
    EXPECT_EQ(document.text(), indented_text(expected));
  }
}

TEST(JsonDocument, MayBeEmpty) { EXPECT_EQ(JsonDocument().text(), "{}"); }

TEST(JsonDocument, MayBeAnElementOfAnother) {
  JsonDocument inner;
  inner.add("values", 3, [](std::size_t i) { return std::to_string(i); });
  JsonDocument outer;
  outer.add("runs", 2, [&](std::size_t) { return inner.text(); });
  const Json run{{"values", {0, 1, 2}}};
  EXPECT_EQ(outer.text(), indented_text(Json{{"runs", {run, run}}}));
}

TEST(JsonDocument, AddsAMemberToAnObject) {
  const Json value{{"re", 1}, {"list", {1, 2}}};
  for (Json object : {Json::object(), Json{{"a", 1}}, Json{{"a", Json::array()}, {"b", value}}}) {
    const std::string text = with_member(indented_text(object), "shape", indented_text(value));
    object["shape"] = value;
    EXPECT_EQ(text, indented_text(object));
  }
}

}  // namespace percuss::report::json_document_test
