#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace percuss::report {

/// A value of the JSON library as text, indented by 2 spaces, without a line end. Bytes that are not UTF-8 (in file
/// names) become replacement characters.
template <class Json>
std::string indented_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The value on one line and in ASCII, for a script in a page.
template <class Json>
std::string ascii_text(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// A JSON object that may be long. Several threads make the texts of its values and of its arrays' elements when it is
/// written. The objects of the JSON library behind these texts need not exist at once. Each text is indented by 2
/// spaces.
class JsonDocument {
 public:
  using Value = std::function<std::string()>;
  using Element = std::function<std::string(std::size_t)>;

  void add(std::string key, Value value);
  void add(std::string key, std::size_t count, Element element);  // an array
  /// Adds a value of the JSON library.
  template <class Json>
  void add_written(std::string key, const Json& json) {
    add(std::move(key), [text = indented_text(json)] { return text; });
  }

  /// The whole object, without a line end. Uses the threads that the current ThreadLimit allows.
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

/// The text of an object with one more member at its end.
std::string with_member(std::string object, const std::string& key, const std::string& value);

}  // namespace percuss::report
