#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::metrics {

enum class BarrelMaterial { wood, aluminum, composite };
const char* name_of(BarrelMaterial material);

/// The quantities of a study, in the units of the source's figures.
enum class StudyQuantity { moi, drop, bending1, bending2, hoop1, hoop2, besr, bbs, bbcor };
inline constexpr std::size_t kStudyQuantities = 9;

/// The column of a quantity, its axis title with the unit, and its name in sentences.
const char* column_of(StudyQuantity quantity);
const char* axis_of(StudyQuantity quantity);
const char* phrase_of(StudyQuantity quantity);

/// One state of one bat: new, or partly broken in.
struct StudyBat {
  std::string id;   // of the state; unique
  std::string bat;  // common to the rows of one bat, which are its states in their order; empty: a bat of one row
  std::string maker, model;  // never in reports or figures; anonymise_bats removes them
  std::string program;       // certification program, such as "bbcor"
  double length_in = 0;
  BarrelMaterial material = BarrelMaterial::wood;
  bool broken_in = false;
  const char* condition() const;  // as in tables: "new", "abi" for a composite barrel, "used" for another
  std::array<std::optional<double>, kStudyQuantities> values;
  // A test has modes, but none of a known family and order, and no row states a frequency.
  bool without_family = false;

  std::optional<double> value(StudyQuantity quantity) const { return values.at(static_cast<std::size_t>(quantity)); }
  int length_class() const;  // whole inches
};

/// Properties of a bat by column name, as in tables and analyses.
using BatProperties = std::map<std::string, std::string>;

/// A property that no table has: a test of the bat has modes, but none of a known family and order.
inline constexpr const char* kWithoutFamily = "without_family";

/// Rows of tables and documents, joined by id. Rows with one id must agree. Two numbers agree if the one with fewer
/// decimals is the other number rounded, and if they differ by at most 1 %. A row whose `bat` is the id of another row
/// takes the properties that it does not state from that row: maker, model, length, material, program, MOI, weight and
/// drop.
class StudyRows {
 public:
  /// Adds a table (docs/schema/study-table.schema.json, or the same as CSV; also a table of percuss metrics), a
  /// document with its bat (states_in_document), or the ids and frequencies of a batch.
  /// errors  InputError: another document, an unknown column, a text where a number belongs, a row without an id, two
  /// values for one id, more than 2000 bats.
  void add(std::string_view text, const std::string& where);
  /// All bats, with drop, BESR, BBS and BBCOR computed where possible ((P1), (P8), (P9), a ball of 145.4 g).
  /// errors  InputError: no bats, a bat without length or material, an impossible value.
  std::vector<StudyBat> bats() const;

 private:
  void merge(const BatProperties& properties, const std::string& where);
  void order_states(const std::vector<BatProperties>& states);
  BatProperties with_inherited(const BatProperties& state) const;

  std::vector<std::string> order_;
  std::map<std::string, BatProperties> by_id_;
};

/// The permitted columns of a table.
const std::vector<std::string>& study_columns();

}  // namespace percuss::metrics
