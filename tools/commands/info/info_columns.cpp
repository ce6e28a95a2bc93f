#include "commands/info/info_columns.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/option_names.hpp"
#include "cli/suggested_command.hpp"
#include "commands/info/info_frfs.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json columns_json(const std::string& path, const acquire::AmbiguousColumns& seen) {
  Json columns = Json::array();
  for (const auto& column : seen.columns) {
    columns.push_back({{"number", column.index + 1},
                       {"name", column.name},
                       {"unit", column.unit.empty() ? Json(nullptr) : Json(column.unit)},
                       {"numbers", column.has_numbers}});
  }
  return {{"path", path},
          {"kind", seen.format},
          {"fs_hz", optional_json(seen.fs_Hz, 1)},
          {"columns", columns},
          {"needs", seen.what()}};
}

std::string columns_text(const std::string& path, const acquire::AmbiguousColumns& seen, std::size_t width) {
  std::string text = one_line(input_name(path), 400) + ": " + seen.format + ", " +
                     report::counted(seen.columns.size(), seen.format == "CSV" ? "column" : "signal");
  if (seen.fs_Hz) text += fmt::format(", {:.10g} Hz", *seen.fs_Hz);
  report::TextTable table({{"  number", report::TextTable::Align::right}, {"name"}, {"unit"}, {""}});
  for (const auto& column : seen.columns) {
    table.add({fmt::format("{}", column.index + 1), one_line(column.name, 40),
               column.unit.empty() ? "-" : one_line(column.unit, 20), column.has_numbers ? "" : "no numbers"});
  }
  text += '\n' + table.text(width) + "  " + report::wrapped("needed: " + seen.written(flag_of), width, 2) + '\n';
  const std::string suggested = suggested_options(seen.guess);
  return suggested.empty() ? text : text + "  the samples suggest: " + suggested + '\n';
}

}  // namespace percuss::tools
