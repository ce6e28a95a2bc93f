#pragma once
/// Writing of files. The extension of the path chooses the format. A file is written completely or not at all.
///
/// @code
/// #include <percuss/analysis.hpp>
/// #include <percuss/synth.hpp>
/// #include <percuss/write.hpp>
///
/// int main() {
///   const percuss::Record record = percuss::synthesise_preset("wood-bat").record;
///   percuss::write("bat.h5", record, {.overwrite = true});
///   const percuss::Analysis analysis(record, {.band_Hz = percuss::Band{60, 1000}});
///   percuss::write("mobility.csv", analysis.frfs(), {.overwrite = true, .kind = percuss::FrfKind::mobility});
///   percuss::write("report.html", analysis, {.overwrite = true});
/// }
/// @endcode
#include <percuss/analysis.hpp>
#include <percuss/deflection.hpp>
#include <percuss/record.hpp>
#include <percuss/survey.hpp>

#include <optional>
#include <string>
#include <vector>

namespace percuss {

/// What a page states about the test, as plain text. Empty members are left out.
struct PageTitle {
  std::string title{};  // default: the name of the record
  std::string customer{}, operator_name{}, specimen{};
  std::string date{};  // of the test; default: as the file states it
  std::string note{};  // lines, and paragraphs between empty lines
  std::string logo{};  // path of a picture: PNG, JPEG or SVG, at most 200 kB
};

struct WriteOptions {
  bool overwrite = false;         // replace a file that exists; errors name this option "force"
  std::optional<FrfKind> kind{};  // of FRFs; default: the kind of the set
  /// Of .svg: "magnitude", "phase", "coherence", "shapes", …; default: the first three, for a survey "shapes".
  std::vector<std::string> picture{};
  std::string produced_by = "percuss (C++)";  // stated in .html
  std::string produced_at{};  // stated in .html, UTC, "2026-11-22 21:45"; default: SOURCE_DATE_EPOCH or now
  PageTitle title{};          // of .html
};

/// All overloads throw InputError: the file exists, or cannot be written; the extension is not known, or its format
/// cannot hold the data; the logo cannot be used.

/// .h5 .hdf5 .csv .mat .uff .unv .wav .rf64 .w64
void write(const std::string& path, const Record& record, const WriteOptions& options = {});
/// .h5 .hdf5 .csv .mat .uff .unv
void write(const std::string& path, const FrfSet& frfs, const WriteOptions& options = {});
/// .json .html .svg; .csv .h5 .hdf5 .mat: FRFs; .uff .unv: modes
void write(const std::string& path, const Analysis& analysis, const WriteOptions& options = {});
/// .json .html .svg; .csv .h5 .hdf5 .uff .unv: mode shapes; .cmif.csv: the mode indicator
void write(const std::string& path, const Survey& survey, const WriteOptions& options = {});
/// .json; .csv .h5 .hdf5: curves over time
void write(const std::string& path, const Deflections& deflections, const WriteOptions& options = {});

}  // namespace percuss
