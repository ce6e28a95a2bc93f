#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// One JSON object being read: every value by the key it is asked for, and nothing may be left over.
///   read_strict_json(text, "spec.json", 6, [&](StrictObject& o) { o.need("fs_hz"); o.read("fs_hz", fs_Hz); });
class StrictObject {
 public:
  using Reader = std::function<void(StrictObject&)>;
  struct Impl;
  explicit StrictObject(std::unique_ptr<Impl> impl);
  ~StrictObject();
  StrictObject(const StrictObject&) = delete;
  StrictObject& operator=(const StrictObject&) = delete;

  bool has(const std::string& key);
  /// InputError when the key is absent.
  void need(const std::string& key);

  // Each leaves `to` as it is when the key is absent, and throws InputError when the value is of another kind.
  void read(const std::string& key, double& to);
  void read(const std::string& key, int& to);
  void read(const std::string& key, std::size_t& to);
  void read(const std::string& key, std::string& to);
  void read(const std::string& key, std::vector<double>& to);  // nested lists count as one
  /// An object, and every object of a list; an object counts as a list of one.
  void read_part(const std::string& key, const Reader& read);
  void read_list(const std::string& key, const Reader& read);

  /// Throws InputError(problem, the place of `key`, remedy).
  [[noreturn]] void fail(const std::string& problem, const std::string& key, const std::string& remedy) const;

 private:
  friend void read_strict_json(std::string_view, const std::string&, int, const Reader&);
  void finish() const;

  std::unique_ptr<Impl> impl_;
};

/// Reads JSON text (comments allowed) whose top is an object. InputError for what is not JSON, nests deeper than
/// `max_depth`, gives a key twice, or a key that `read` never asks for; `where` names the text.
void read_strict_json(std::string_view text, const std::string& where, int max_depth, const StrictObject::Reader& read);

}  // namespace percuss
