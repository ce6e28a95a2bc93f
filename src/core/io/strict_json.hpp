#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/io/json_text.hpp"

namespace percuss {
inline namespace core {

/// One JSON object being read. The reader reads each key by name; a key that it does not read is an error.
///   read_strict_json({.text = text, .where = "spec.json"}, [&](StrictObject& o) {
///     o.need("fs_hz");
///     o.read("fs_hz", fs_Hz);
///   });
class StrictObject {
 public:
  using Reader = std::function<void(StrictObject&)>;
  struct Impl;
  explicit StrictObject(std::unique_ptr<Impl> impl);
  ~StrictObject();
  StrictObject(const StrictObject&) = delete;
  StrictObject& operator=(const StrictObject&) = delete;

  bool has(const std::string& key);
  /// errors  InputError: the key is absent
  void need(const std::string& key);

  // Each leaves `to` unchanged when the key is absent. errors  InputError: the value is of another kind
  void read(const std::string& key, double& to);
  void read(const std::string& key, std::optional<double>& to);
  void read(const std::string& key, bool& to);
  void read(const std::string& key, int& to);
  void read(const std::string& key, std::size_t& to);
  void read(const std::string& key, std::string& to);
  void read(const std::string& key, std::vector<double>& to);  // nested lists are joined
  void read(const std::string& key, std::vector<std::string>& to);
  /// Reads an object. read_list reads every object of a list, or a single object.
  void read_part(const std::string& key, const Reader& read);
  void read_list(const std::string& key, const Reader& read);

  /// As read. errors  InputError: the number is outside [low, high]
  void read_within(const std::string& key, double low, double high, double& to);
  void read_within(const std::string& key, double low, double high, std::optional<double>& to);

  /// Throws InputError(problem, the place of `key`, remedy, options).
  [[noreturn]] void fail(const std::string& problem, const std::string& key, const std::string& remedy,
                         std::vector<OptionId> options = {}) const;
  /// The place of this object for messages: "s.json, shots[3]".
  std::string place() const;

 private:
  friend void read_strict_json(const JsonText&, const Reader&);
  friend void read_strict_table(const JsonText&, const std::string&, const Reader&);
  void finish() const;

  std::unique_ptr<Impl> impl_;
};

/// Reads JSON text with an object at the top. Comments are allowed, whatever JsonText::comments says.
/// errors  InputError: not JSON, nested deeper than `max_depth`, a key given twice, a key that `read` does not read
void read_strict_json(const JsonText& text, const StrictObject::Reader& read);

/// Reads a table as such a document. Its rows are the objects of the list `rows`, the column names are the keys, and
/// empty cells are absent keys. Lines like "# bat.length_in = 34" above the table set the other keys. A cell is text
/// (read by text_of_csv_cell()), a number, several numbers separated by blanks, or a Boolean ("yes", "true", "no",
/// "false"). Comma, semicolon or tab separate cells; the decimal mark may be a comma where the comma does not separate
/// cells.
/// errors  InputError with the line: as above; a cell without a column, two columns of one name, more than 100000 rows
/// or 16 MiB
void read_strict_table(const JsonText& text, const std::string& rows, const StrictObject::Reader& read);

}  // namespace core
}  // namespace percuss
