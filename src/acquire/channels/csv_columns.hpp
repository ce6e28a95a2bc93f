#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "acquire/channels/role_guess.hpp"
#include "acquire/record/record.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

/// The roles of a text file's columns; indices as in CsvColumn::index.
struct CsvColumns {
  CsvColumn force{};
  bool has_force = false;  // false: `force` is not a column
  std::vector<CsvColumn> accel{};
  std::optional<CsvColumn> time, hit, point, run;
};

/// The columns are readable, but an option must name the force or an acceleration, or state the scale of volts.
class AmbiguousColumns : public InputError {
 public:
  AmbiguousColumns(std::string_view problem, std::string_view where, std::string_view remedy, const CsvHeader& header,
                   std::vector<OptionId> options = {})
      : InputError(problem, where, remedy, std::move(options)), columns(header.columns), fs_Hz(header.fs_Hz) {}
  AmbiguousColumns(const InputError& error, const CsvHeader& header)
      : InputError(error), columns(header.columns), fs_Hz(header.fs_Hz) {}
  std::vector<CsvColumn> columns;  // all columns of the file
  std::optional<double> fs_Hz;     // where a line of the header states it
  std::string format = "CSV";
  CsvColumns known;  // the roles found before the error
  RoleGuess guess;
  bool roles_known = false;  // only the scale of volts is missing
};

/// Throws `error` as AmbiguousColumns with the columns of the file, if it asks for the scale of accelerations in volts.
/// Returns otherwise.
void throw_with_columns_if_unscaled(const InputError& error, const CsvHeader& header, const std::string& format);

/// Finds the columns by the options (name, name without unit, or 1-based number; letter case aside), then by the roles
/// of the set-up, else by unit and by words in the name. `file` is its name in messages.
/// errors  AmbiguousColumns: no column (unless the force is optional) or several could be the force, or none is an
/// acceleration. InputError: an option names a column that is missing, not unique, without numbers, or named twice; or
/// the set-up names a missing column and no option names the accelerations. Messages about a missing column or several
/// possible forces list the columns.
CsvColumns find_csv_columns(const CsvHeader& header, const ReadOptions& options, const std::string& file);

/// The set-up's entry for a column, or nullptr.
const ChannelSetup* setup_of(const CsvColumn& column, const ReadOptions& options);

/// Whether an option means this column by `name`: its name, its name without unit, or its 1-based number.
bool is_called(const CsvColumn& column, const std::string& name);

/// Whether the column is the time, or numbers the hits, points or runs.
bool is_helper(const CsvColumn& column, const CsvColumns& columns);

/// Whether a first column may be the time although neither its name nor its unit says so: it is neither a count of
/// samples nor a signal.
bool may_be_time(const CsvColumn& column, const CsvColumns& columns);

}  // namespace percuss::acquire
