#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::metrics {

enum class BarrelMaterial { wood, aluminum, composite };

/// What a study compares, in the units of the source's figures.
enum class StudyQuantity { moi, drop, bending1, bending2, hoop1, hoop2, besr, bbs, bbcor };
inline constexpr std::size_t kStudyQuantities = 9;

/// The name of a quantity's column, its axis with the unit, and its name in sentences.
const char* column_of(StudyQuantity quantity);
const char* axis_of(StudyQuantity quantity);
const char* phrase_of(StudyQuantity quantity);

/// One state of one bat: new, or as broken in as it was when tested.
struct StudyBat {
  std::string id;            // of the state: each occurs once
  std::string bat;           // the bat itself where several rows are states of it, in their order
  std::string maker, model;  // never shown; --blind takes them out
  std::string program;       // what the bat was submitted for, as "bbcor"
  double length_in = 0;
  BarrelMaterial material = BarrelMaterial::wood;
  bool broken_in = false;
  std::array<std::optional<double>, kStudyQuantities> values;

  std::optional<double> value(StudyQuantity quantity) const { return values.at(static_cast<std::size_t>(quantity)); }
  int length_class() const;  // whole inches
};

/// Properties of a bat by column name, as tables and analyses carry them.
using BatProperties = std::map<std::string, std::string>;

/// Rows gathered from tables and analyses, joined by id: what two of them say of one bat must agree.
class StudyRows {
 public:
  /// A table (docs/schema/study-table.schema.json, or the same as CSV), a document percuss/analysis/1 with "bat", or
  /// the rows of a batch, of which ids and frequencies count.
  /// errors  InputError: neither, an unknown column, a value that cannot be, two different values for one id.
  void add(std::string_view text, const std::string& where);
  /// All bats, with drop, BBS and BBCOR worked out where their parts are known ((P1), (P8), (P9), a ball of 145.4 g).
  /// errors  InputError: no bats, no length or material of one; in add: more than 2000.
  std::vector<StudyBat> bats() const;

 private:
  void merge(const BatProperties& properties, const std::string& where);

  std::vector<std::string> order_;
  std::map<std::string, BatProperties> by_id_;
};

/// The columns a table may have, in the order of writing.
const std::vector<std::string>& study_columns();

}  // namespace percuss::metrics
