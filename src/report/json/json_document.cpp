#include "report/json/json_document.hpp"

#include <string_view>

#include "core/parallel/parallel.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kFlopsPerValue = 20'000;  // of an object with a few numbers

void append_line_begin(std::string& out, std::size_t indent) {
  out += '\n';
  out.append(indent, ' ');
}

void append_key(std::string& out, const std::string& key) {
  append_line_begin(out, 2);
  out += '"' + key + "\": ";
}

// Line ends within strings are escaped: all line ends are the layout's.
void append_indented(std::string& out, std::string_view text, std::size_t indent) {
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    out += text.substr(0, end);
    append_line_begin(out, indent);
    text.remove_prefix(end + 1);
  }
  out += text;
}

void append_array(std::string& out, const std::string* elements, std::size_t count) {
  out += '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ',';
    append_line_begin(out, 4);
    append_indented(out, elements[i], 4);
  }
  if (count > 0) append_line_begin(out, 2);
  out += ']';
}

}  // namespace

void JsonDocument::add(std::string key, Value value) {
  members_.push_back({.key = std::move(key),
                      .count = 1,
                      .element = [value = std::move(value)](std::size_t) { return value(); },
                      .array = false});
}

void JsonDocument::add(std::string key, std::size_t count, Element element) {
  members_.push_back({.key = std::move(key), .count = count, .element = std::move(element), .array = true});
}

std::string JsonDocument::text() const {
  std::vector<std::pair<const Member*, std::size_t>> places;
  for (const Member& member : members_) {
    for (std::size_t i = 0; i < member.count; ++i) places.emplace_back(&member, i);
  }
  std::vector<std::string> texts(places.size());
  parallel_for_cost(places.size(), kFlopsPerValue,
                    [&](std::size_t p) { texts[p] = places[p].first->element(places[p].second); });

  std::string out = "{";
  const std::string* next = texts.data();
  for (const Member& member : members_) {
    if (out.size() > 1) out += ',';
    append_key(out, member.key);
    if (member.array) {
      append_array(out, next, member.count);
    } else {
      append_indented(out, *next, 2);
    }
    next += member.count;
  }
  if (!members_.empty()) out += '\n';
  return out + '}';
}

std::string with_member(std::string object, const std::string& key, const std::string& value) {
  const bool first = object == "{}";
  object.resize(object.size() - (first ? 1 : 2));  // without the closing brace
  if (!first) object += ',';
  append_key(object, key);
  append_indented(object, value, 2);
  return object + "\n}";
}

}  // namespace percuss::report
