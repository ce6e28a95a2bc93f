#include "model_output.hpp"

#include <iostream>

#include "acquire/atomic_file.hpp"
#include "command.hpp"

namespace percuss::tools {

void check_model_outputs(const OutputFlags& flags) { check_outputs(flags, {".json", ".csv", ".svg"}); }

int show_model(const ModelReport& report, const OutputFlags& flags) {
  for (const std::string& path : flags.paths) {
    const std::string kind = extension_of(path);
    write_file(path,
               kind == ".json"  ? report.json
               : kind == ".csv" ? columns_csv(report.columns)
                                : line_chart_svg(report.chart),
               flags.force);
  }
  if (flags.json) {
    std::cout << report.json;
  } else if (!flags.quiet) {
    std::cout << report.text;
  }
  return kOk;
}

}  // namespace percuss::tools
