#include "commands/analyze_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "acquire/write_record.hpp"
#include "cli/option_error.hpp"
#include "cli/page_output.hpp"
#include "cli/provenance.hpp"
#include "cli/report_output.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/csv_header.hpp"
#include "report/csv/modes_csv.hpp"
#include "report/deflection_report.hpp"
#include "report/frf_files.hpp"
#include "report/html/analysis_page.hpp"
#include "report/json/analysis_json.hpp"
#include "report/modes_uff.hpp"
#include "report/svg/analysis_charts.hpp"
#include "report/text/analysis_tables.hpp"

namespace percuss::tools {
namespace {

std::string page_of(const AnalyzeFlags& flags, const AnalyzeResults& results) {
  const Test& test = results.tests.front();
  return report::analysis_page(*test.analysis,
                               {.sections = results.sections,
                                .deflection = test.deflection ? &*test.deflection : nullptr,
                                .comparison = results.comparison ? &*results.comparison : nullptr},
                               provenance_now(flags.output, flags.read.setup_path));
}

std::string drawing_of(const AnalyzeFlags& flags, const pipeline::Analysis& analysis) {
  const auto classifications =
      analysis.possible() ? analysis.classifications() : std::vector<identify::ModeClassification>();
  return report::svg_document(report::analysis_charts(analysis, classifications, flags.pictures));
}

std::string html_of(const AnalyzeResults& results) {
  const bool classes = results.sections.contains(report::ReportSection::classes);
  std::string html;
  for (const Test& test : results.tests) {
    if (results.tests.size() > 1) html += report::page_paragraph(fmt::format("test {}", test.run));
    if (!test.analysis->possible()) {
      html += report::page_paragraph(report::no_usable_hit(test.analysis->hits()).text);
    } else if (classes || results.sections.contains(report::ReportSection::modes)) {
      html += report::modes_table(*test.analysis, classes).html();
    } else {
      html += report::hits_table(*test.analysis, test.analysis->force_hits()).shown.html();
    }
    html += report::page_warnings(test.analysis->warnings());
  }
  return html;
}

}  // namespace

std::string document_of_tests(const AnalyzeResults& results) {
  std::vector<report::NumberedAnalysis> numbered;
  numbered.reserve(results.tests.size());
  for (const Test& test : results.tests) numbered.push_back({.run = test.run, .analysis = test.analysis.get()});
  const AnalyzeFlags& flags = results.flags;
  const auto& deflection = results.tests.front().deflection;
  return report::analysis_json(numbered, {.sections = results.sections,
                                          .trace = flags.trace,
                                          .explain = flags.explain,
                                          .per_hit = flags.per_hit,
                                          .stabilisation = flags.stabilisation,
                                          .bat = results.bat,
                                          .deflection = deflection ? &*deflection : nullptr});
}

void check_analyze_outputs(const AnalyzeFlags& flags) {
  const OutputFlags& output = flags.output;
  check_outputs(output, {".json", ".html", ".svg", ".csv", ".h5", ".hdf5", ".mat", ".uff", ".unv"});
  std::vector<std::string> all = output.paths;
  const auto check = [&](const std::vector<std::string>& paths, const std::vector<std::string>& known) {
    for (const std::string& path : paths) {
      check_outputs(single_output(output, path, output.force), known);
      if (std::find(all.begin(), all.end(), path) != all.end())
        throw OptionError({}, "'" + path + "' is to be written twice", "name each file once");
      all.push_back(path);
    }
  };
  check(flags.frf_paths, acquire::frf_extensions());
  check(flags.modes_paths, {".csv", ".json", ".uff", ".unv"});
}

bool is_csv_of_modes(const std::string& path) {
  constexpr std::string_view kName = "modes";
  const std::string stem = lower_case(std::filesystem::path(path).stem().string());
  if (extension_of(path) != ".csv" || !stem.ends_with(kName)) return false;
  return stem == kName || std::string_view("._-").find(stem[stem.size() - kName.size() - 1]) != std::string_view::npos;
}

bool holds_several_tests(const AnalyzeFlags& flags) {
  const auto holds = [](const std::string& path) { return is_json(path) || is_csv_of_modes(path); };
  const auto is_table_or_document = [](const std::string& path) {
    return extension_of(path) == ".csv" || is_json(path);
  };
  return std::all_of(flags.output.paths.begin(), flags.output.paths.end(), holds) && flags.frf_paths.empty() &&
         std::all_of(flags.modes_paths.begin(), flags.modes_paths.end(), is_table_or_document);
}

void require_one_test(const AnalyzeFlags& flags, const std::set<report::ReportSection>& sections, std::size_t tests) {
  if (tests < 2) return;
  const char* const remedy = "analyse one file or run at a time";
  if (!holds_several_tests(flags))
    throw OptionError({}, "several tests cannot be written to one file of FRFs or one page", remedy);
  if (sections.contains(report::ReportSection::deflection) || !flags.compared.empty())
    throw OptionError({}, "several tests cannot be integrated to deflection or compared", remedy);
}

std::string text_of(const AnalyzeResults& results, report::TextOptions options) {
  options.sections = results.sections;
  options.per_hit = results.flags.per_hit;
  std::string text;
  for (const Test& test : results.tests) {
    if (results.tests.size() > 1) text += fmt::format("{}test {}\n", text.empty() ? "" : "\n", test.run);
    text += report::analysis_text(*test.analysis, options);
    const auto add = [&](const report::ReportText& part) {
      text += "\n" + part.text(options.width, options.write_option, options.warnings);
    };
    if (test.deflection) add(report::deflection_tables(*test.analysis, *test.deflection));
    if (results.comparison) add(results.comparison->text);
  }
  return text;
}

namespace {

std::string csv_of_modes(const AnalyzeResults& results) {
  std::vector<report::NumberedAnalysis> tests;
  for (const Test& test : results.tests) tests.push_back({.run = test.run, .analysis = test.analysis.get()});
  return report::modes_csv(tests);
}

void note_missing(const AnalyzeFlags& flags, const char* what, const std::string& path) {
  print_note(flags.output, {fmt::format("no hit can be used, so no {} are written ({}); see the findings of the hits",
                                        what, one_line(path)),
                            {}});
}

// The files that --frf and --modes-file name.
void write_named_outputs(const AnalyzeFlags& flags, const AnalyzeResults& results) {
  const pipeline::Analysis& analysis = *results.tests.front().analysis;
  for (const std::string& frf : flags.frf_paths) {
    if (analysis.possible()) {
      acquire::write_frfs(frf, report::frf_record_of(analysis), acquire::FrfKind::accelerance, flags.output.force);
    } else {
      note_missing(flags, "FRFs", frf);
    }
  }
  for (const std::string& modes : flags.modes_paths) {
    if (is_json(modes)) {
      write_file(modes, results.document, flags.output.force);
    } else if (extension_of(modes) == ".csv") {
      write_file(modes, csv_of_modes(results), flags.output.force);
    } else if (analysis.possible()) {
      report::write_modes_uff(modes, analysis, flags.output.force);
    } else {
      note_missing(flags, "modes", modes);
    }
  }
}

}  // namespace

void write_outputs(const AnalyzeFlags& flags, const AnalyzeResults& results) {
  const pipeline::Analysis& analysis = *results.tests.front().analysis;
  OutputGroup outputs;
  write_named_outputs(flags, results);
  for (const std::string& path : flags.output.paths) {
    if (is_json(path)) {
      write_file(path, results.document, flags.output.force);
    } else if (is_page(path)) {
      write_page(path, page_of(flags, results), flags.output);
    } else if (extension_of(path) == ".svg") {
      write_file(path, drawing_of(flags, analysis), flags.output.force);
    } else if (is_csv_of_modes(path)) {
      write_file(path, csv_of_modes(results), flags.output.force);
    } else if (!analysis.possible()) {
      note_missing(flags, "FRFs", path);
    } else if (is_uff(path)) {
      report::write_modes_uff(path, analysis, flags.output.force);
    } else {
      acquire::write_frfs(path, report::frf_record_of(analysis), acquire::FrfKind::accelerance, flags.output.force);
    }
  }
  outputs.commit();
}

namespace {

// `captured`: the output flags without the host (the program that runs the command as a function), because the result
// may outlive the host.
CommandResult outcome_of(const std::shared_ptr<const AnalyzeResults>& results, const OutputFlags& captured) {
  CommandResult outcome;
  for (const Test& test : results->tests) outcome.analyses.emplace_back(results, test.analysis.get());
  if (const auto& deflection = results->tests.front().deflection) outcome.deflection = {results, &*deflection};
  outcome.text = [results](std::size_t width, OptionWriter write_option) {
    return text_of(*results, {.width = width, .write_option = write_option});
  };
  outcome.html = [results] { return html_of(*results); };
  outcome.save = [results, captured](const SaveRequest& request) {
    AnalyzeFlags flags = results->flags;
    flags.output = single_output(captured, request);
    flags.frf_paths.clear();
    flags.modes_paths.clear();
    check_analyze_outputs(flags);
    require_one_test(flags, results->sections, results->tests.size());
    write_outputs(flags, *results);
  };
  outcome.possible = std::all_of(results->tests.begin(), results->tests.end(),
                                 [](const Test& test) { return test.analysis->possible(); });
  outcome.tests = results->tests.size();
  if (outcome.tests < 2) return outcome;
  outcome.of_test = [results, captured](std::size_t test) {
    const auto alone = std::make_shared<AnalyzeResults>(*results);
    alone->tests = {results->tests.at(test)};
    alone->document = document_of_tests(*alone);
    CommandResult one = outcome_of(alone, captured);
    one.document = alone->document;
    return one;
  };
  return outcome;
}

}  // namespace

void give_to_host(const OutputFlags& output, const std::shared_ptr<const AnalyzeResults>& results) {
  CommandResult& outcome = output.host->outcome;
  CommandResult made = outcome_of(results, captured_output(output));
  made.document = std::move(outcome.document);
  made.notes = std::move(outcome.notes);
  outcome = std::move(made);
}

}  // namespace percuss::tools
