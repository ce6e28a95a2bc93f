#pragma once
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Private to this folder: read_spec.cpp uses it, and nothing public shows it.

namespace percuss {

/// JSON text as a tree. InputError for what is not JSON, nests deeper than `max_depth` or gives a key twice.
nlohmann::json parse_strict_json(std::string_view text, const std::string& where, int max_depth);

/// One JSON object being read: every value by the key it is asked for, and nothing may be left over.
class StrictObject {
 public:
  /// InputError unless `object` is an object. `path` is its name in messages ("modes[2]"; "" for the document).
  StrictObject(const nlohmann::json& object, std::string where, std::string path);

  /// Nothing when the key is absent.
  const nlohmann::json* find(const std::string& key);
  /// InputError when the key is absent.
  const nlohmann::json& need(const std::string& key);

  // Each leaves `to` as it is when the key is absent, and throws InputError when the value is of another kind.
  void read(const std::string& key, double& to);
  void read(const std::string& key, int& to);
  void read(const std::string& key, std::size_t& to);
  void read(const std::string& key, std::string& to);
  void read(const std::string& key, std::vector<double>& to);  // nested lists count as one
  /// InputError for a key that was never asked for; lists those that were.
  void finish() const;

  [[noreturn]] void fail(const std::string& problem, const std::string& key, const std::string& remedy) const;
  std::string path_of(const std::string& key) const;
  const std::string& where() const { return where_; }

 private:
  const nlohmann::json& object_;
  std::string where_, path_;
  std::set<std::string> asked_;
};

}  // namespace percuss
