#include "commands/analyze_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/option_error.hpp"
#include "cli/page_output.hpp"
#include "cli/provenance.hpp"
#include "cli/report_output.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "report/deflection_report.hpp"
#include "report/frf_files.hpp"
#include "report/html/analysis_page.hpp"
#include "report/modes_uff.hpp"
#include "report/svg/analysis_charts.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/analysis_text.hpp"

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
      html += report::page_paragraph(report::no_usable_hit().text);
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

void check_analyze_outputs(const OutputFlags& output) {
  check_outputs(output, {".json", ".html", ".svg", ".csv", ".h5", ".hdf5", ".mat", ".uff", ".unv"});
}

void require_one_test(const AnalyzeFlags& flags, const std::set<report::ReportSection>& sections, std::size_t tests) {
  if (tests < 2) return;
  const char* const remedy = "analyse one file or run at a time";
  if (!std::all_of(flags.output.paths.begin(), flags.output.paths.end(), is_json))
    throw OptionError({}, "several tests cannot be written to one file of FRFs or one page", remedy);
  if (sections.contains(report::ReportSection::deflection) || !flags.compared.empty())
    throw OptionError({}, "several tests cannot be integrated to deflection or compared", remedy);
}

std::string text_of(const AnalyzeResults& results, std::size_t width, bool sketch, OptionWriter write_option) {
  std::string text;
  for (const Test& test : results.tests) {
    if (results.tests.size() > 1) text += fmt::format("{}test {}\n", text.empty() ? "" : "\n", test.run);
    text += report::analysis_text(*test.analysis, {.sections = results.sections,
                                                   .width = width,
                                                   .per_hit = results.flags.per_hit,
                                                   .sketch = sketch,
                                                   .write_option = write_option});
    if (test.deflection)
      text += "\n" + report::deflection_tables(*test.analysis, *test.deflection).text(width, write_option);
    if (results.comparison) text += "\n" + results.comparison->text.text(width, write_option);
  }
  return text;
}

void write_outputs(const AnalyzeFlags& flags, const AnalyzeResults& results) {
  const pipeline::Analysis& analysis = *results.tests.front().analysis;
  OutputGroup outputs;
  for (const std::string& path : flags.output.paths) {
    if (is_json(path)) {
      write_file(path, results.document, flags.output.force);
    } else if (is_page(path)) {
      write_page(path, page_of(flags, results), flags.output);
    } else if (extension_of(path) == ".svg") {
      write_file(path, drawing_of(flags, analysis), flags.output.force);
    } else if (!analysis.possible()) {
      print_note(
          flags.output,
          {"no hit can be used, so no FRFs are written (" + one_line(path) + "); see the findings of the hits", {}});
    } else if (is_uff(path)) {
      report::write_modes_uff(path, analysis, flags.output.force);
    } else {
      report::write_frfs(path, report::frf_record_of(analysis), acquire::FrfKind::accelerance, flags.output.force);
    }
  }
  outputs.commit();
}

void give_to_host(const OutputFlags& output, const std::shared_ptr<const AnalyzeResults>& results) {
  CommandResult& outcome = output.host->outcome;
  for (const Test& test : results->tests) outcome.analyses.emplace_back(results, test.analysis.get());
  if (const auto& deflection = results->tests.front().deflection) outcome.deflection = {results, &*deflection};
  outcome.text = [results](std::size_t width, OptionWriter write_option) {
    return text_of(*results, width, false, write_option);
  };
  outcome.html = [results] { return html_of(*results); };
  outcome.save = [results, captured = captured_output(output)](const std::string& path, bool force) {
    AnalyzeFlags flags = results->flags;
    flags.output = single_output(captured, path, force);
    check_analyze_outputs(flags.output);
    require_one_test(flags, results->sections, results->tests.size());
    write_outputs(flags, *results);
  };
}

}  // namespace percuss::tools
