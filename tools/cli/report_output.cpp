#include "cli/report_output.hpp"

#include <fmt/format.h>

#include <iostream>

#include "cli/exit_code.hpp"
#include "cli/option_names.hpp"
#include "cli/page_output.hpp"
#include "cli/provenance.hpp"
#include "core/io/atomic_file.hpp"
#include "report/html/command_page.hpp"

namespace percuss::tools {
namespace {

std::string text_for(const std::string& path, const report::CommandReport& report) {
  const std::string kind = extension_of(path);
  return kind == ".json" ? report.json : kind == ".csv" ? report.csv() : report::line_charts_svg(report.charts);
}

}  // namespace

const std::vector<std::string>& report_extensions() {
  static const std::vector<std::string> kExtensions{".json", ".csv", ".svg", ".html"};
  return kExtensions;
}

void check_report_outputs(const OutputFlags& flags) { check_outputs(flags, report_extensions()); }

void write_report(const std::string& path, const report::CommandReport& report, const std::vector<std::string>& inputs,
                  const OutputFlags& flags) {
  if (is_page(path)) {
    write_page(path, report::command_page(report, inputs, provenance_now(flags)), flags);
  } else {
    write_file(path, text_for(path, report), flags.force);
  }
}

void print_report(const report::CommandReport& report, const OutputFlags& flags) {
  if (flags.host != nullptr) {
    CommandResult& outcome = flags.host->outcome;
    outcome.columns = report.columns;
    outcome.words = report.words;
    outcome.table = report.table;
    outcome.text = [text = report.text](std::size_t width, OptionWriter write_option) {
      return text.text(width, write_option);
    };
    outcome.html = [text = report.text] { return text.html(); };
  }
  print(flags, flags.json ? report.json : report.text.text(terminal_width(), flag_of, !flags.quiet));
}

int show_report(const report::CommandReport& report, const OutputFlags& flags, const std::vector<std::string>& paths) {
  std::vector<std::string> inputs;
  inputs.reserve(paths.size());
  for (const std::string& path : paths) inputs.push_back(with_display_names(flags.host, path));
  OutputGroup outputs;
  for (const std::string& path : flags.paths) write_report(path, report, inputs, flags);
  outputs.commit();
  print_report(report, flags);
  if (flags.host != nullptr) {
    flags.host->outcome.save = [report, inputs, output = captured_output(flags)](const SaveRequest& request) {
      const OutputFlags file_flags = single_output(output, request);
      check_report_outputs(file_flags);
      write_report(request.path, report, inputs, file_flags);
    };
  }
  return kOk;
}

void print_trace(const pipeline::Analysis& analysis) {
  for (const auto& stage : analysis.trace().stages())
    std::cerr << fmt::format("{:<20} {:>6} calls  {:.6f} s\n", stage.name, stage.calls, stage.seconds);
}

std::vector<std::string> inputs_of(const pipeline::Analysis& analysis) {
  std::vector<std::string> paths;
  for (const acquire::InputFile& file : analysis.record().files) paths.push_back(file.path);
  return paths;
}

}  // namespace percuss::tools
