#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace percuss::report {

/// The text of a document of the JSON library's, indented by 2 spaces, without a line end. What is not UTF-8 (file
/// names) is shown with replacement characters.
template <class Json>
std::string indented_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The same on one line and in ASCII, for a script within a page.
template <class Json>
std::string ascii_text(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// A JSON object that may be long: its values and its arrays' elements are made, written out and dropped one by one, by
/// several threads at once. Each is text as of a document of its own, indented by 2 spaces.
class JsonDocument {
 public:
  using Value = std::function<std::string()>;
  using Element = std::function<std::string(std::size_t)>;

  void add(std::string key, Value value);
  void add(std::string key, std::size_t count, Element element);  // an array
  /// What is there already, a document of the JSON library's.
  template <class Json>
  void add_written(std::string key, const Json& json) {
    add(std::move(key), [text = indented_text(json)] { return text; });
  }

  /// On the threads that the ThreadLimit here allows; without a line end.
  std::string text() const;

 private:
  struct Member {
    std::string key;
    std::size_t count;
    Element element;
    bool array;
  };
  std::vector<Member> members_;
};

/// The text of an object with one more member, as its last.
std::string with_member(std::string object, const std::string& key, const std::string& value);

}  // namespace percuss::report
