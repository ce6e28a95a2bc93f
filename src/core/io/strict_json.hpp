#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::inline core {

/// A text to be read strictly.
struct StrictText {
  std::string_view text;
  std::string where;                                // its name, for messages
  std::string example = "percuss synth --example";  // what prints a valid one
  int max_depth = 6;
};

/// One JSON object being read: every value by the key it is asked for, and nothing may be left over.
///   read_strict_json({.text = text, .where = "spec.json"}, [&](StrictObject& o) { o.need("fs_hz"); o.read("fs_hz",
///   fs_Hz); });
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
  void read(const std::string& key, std::optional<double>& to);
  void read(const std::string& key, bool& to);
  void read(const std::string& key, int& to);
  void read(const std::string& key, std::size_t& to);
  void read(const std::string& key, std::string& to);
  void read(const std::string& key, std::vector<double>& to);  // nested lists count as one
  void read(const std::string& key, std::vector<std::string>& to);
  /// An object, and every object of a list; an object counts as a list of one.
  void read_part(const std::string& key, const Reader& read);
  void read_list(const std::string& key, const Reader& read);

  /// The number at `key`, if any, is within [low, high]; else InputError.
  void read_within(const std::string& key, double low, double high, double& to);
  void read_within(const std::string& key, double low, double high, std::optional<double>& to);

  /// Throws InputError(problem, the place of `key`, remedy).
  [[noreturn]] void fail(const std::string& problem, const std::string& key, const std::string& remedy) const;
  /// This object's place, for messages of later checks: "s.json, shots[3]".
  std::string place() const;

 private:
  friend void read_strict_json(const StrictText&, const Reader&);
  friend void read_strict_table(const StrictText&, const std::string&, const Reader&);
  void finish() const;

  std::unique_ptr<Impl> impl_;
};

/// Reads JSON text (comments allowed) whose top is an object. InputError for what is not JSON, nests deeper than
/// `max_depth`, gives a key twice, or a key that `read` never asks for.
void read_strict_json(const StrictText& text, const StrictObject::Reader& read);

/// Reads a table as if it were such a document: its rows are the objects of the list `rows`, with the column names as
/// keys, empty cells absent; what stands above it in lines like "# bat.length_in = 34" are the other keys. A cell is
/// what is asked for: text, a number, several numbers with blanks between, "yes" or "no". Comma, semicolon or tab
/// between cells, decimal comma where the cells are not divided by it. InputError as above, naming lines; for a cell
/// too many, two columns of one name, more than 100000 rows, or 16 MiB.
void read_strict_table(const StrictText& text, const std::string& rows, const StrictObject::Reader& read);

/// Whether a text is meant as JSON: its first character that is no blank or comment opens an object.
bool looks_like_json(std::string_view text);

/// Whether lists and objects of a JSON text stand in one another more than `depth` times: reading them would take
/// memory without bound. For texts without comments.
bool nests_deeper_than(std::string_view text, int depth);
inline constexpr int kMaxDocumentDepth = 16;  // percuss's own stay far below

}  // namespace percuss::inline core
