#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {

/// What each column of a text file is; indices as in CsvColumn::index.
struct CsvColumns {
  CsvColumn force;
  bool has_force = true;  // false: `force` is no column
  std::vector<CsvColumn> accel;
  std::optional<CsvColumn> time, hit, point, run;
};

/// The columns can be read, but which of them is the force or an acceleration must be said by an option.
class AmbiguousColumns : public InputError {
 public:
  AmbiguousColumns(std::string_view problem, std::string_view where, std::string_view remedy, const CsvHeader& header,
                   std::vector<OptionId> options = {})
      : InputError(problem, where, remedy, std::move(options)), columns(header.columns), fs_Hz(header.fs_Hz) {}
  AmbiguousColumns(const InputError& error, const CsvHeader& header)
      : InputError(error), columns(header.columns), fs_Hz(header.fs_Hz) {}
  std::vector<CsvColumn> columns;  // all there are
  std::optional<double> fs_Hz;     // if a line of the header states it
  std::string format = "CSV";
};

/// Finds the columns: as the options name them (name, name without unit, or 1-based number; letter case aside), then as
/// the set-up gives their role, else by unit and by words in the name. `file` is for messages. errors AmbiguousColumns:
/// none (unless it is optional) or several could be the force, none the acceleration; InputError: an option names a
/// column that is not there, has no numbers, or is named twice. Both name the columns seen.
CsvColumns find_csv_columns(const CsvHeader& header, const ReadOptions& options, const std::string& file);

/// The set-up's entry for a column, or nullptr.
const ChannelSetup* setup_of(const CsvColumn& column, const ReadOptions& options);

/// Whether a first column with this name may be the time although neither name nor unit says so: it is no count of
/// samples and no signal.
bool may_be_time(const CsvColumn& column, const CsvColumns& columns);

}  // namespace percuss::acquire
