#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace percuss::acquire {

/// Appends values as bytes, for another process on this machine.
class Serializer {
 public:
  template <class Value>
  requires std::is_trivially_copyable_v<Value>
  void put(Value value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  void put(const std::string& text) { put(std::string_view(text)); }
  template <class Value>
  void put_all(const std::vector<Value>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads the values of a Serializer. The bytes are not trusted: sizes are checked against the bytes left.
/// errors  std::out_of_range from every member: the bytes end before the value.
class Deserializer {
 public:
  explicit Deserializer(std::string_view bytes) : rest_(bytes) {}

  template <class Value>
  requires std::is_trivially_copyable_v<Value> Value get() {
    Value value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(count(1))); }
  template <class Value>
  std::vector<Value> all() {
    const std::size_t size = count(sizeof(Value));
    std::vector<Value> values(size);
    const std::string_view bytes = take(size * sizeof(Value));
    if (size > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  /// The number of elements that follow, each of at least `bytes_each` bytes.
  std::size_t count(std::size_t bytes_each) {
    const auto size = get<std::uint64_t>();
    if (size > rest_.size() / bytes_each) throw std::out_of_range("size beyond the end");
    return static_cast<std::size_t>(size);
  }

 private:
  std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) throw std::out_of_range("size beyond the end");
    const std::string_view out = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return out;
  }
  std::string_view rest_;
};

}  // namespace percuss::acquire
