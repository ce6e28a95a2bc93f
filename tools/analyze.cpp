#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "acquire/atomic_file.hpp"
#include "analysis_flags.hpp"
#include "command.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "output.hpp"
#include "pipeline/tests_of_record.hpp"
#include "progress.hpp"
#include "provenance.hpp"
#include "read_flags.hpp"
#include "report/analysis_charts.hpp"
#include "report/analysis_json.hpp"
#include "report/analysis_page.hpp"
#include "report/analysis_tables.hpp"
#include "report/analysis_text.hpp"
#include "report/compare_report.hpp"
#include "report/deflection_report.hpp"
#include "report/frf_files.hpp"
#include "report/modes_uff.hpp"
#include "report/read_document.hpp"
#include "report/skipped_text.hpp"
#include "report_output.hpp"

namespace percuss::tools {
namespace {

struct AnalyzeFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::vector<std::string> only;
  bool trace = false;
  bool explain = false;
  bool per_hit = false;
  bool stabilisation = false;
  std::vector<std::string> pictures{"magnitude", "phase", "coherence"};
  std::vector<std::string> compared;
  std::string bat_id;
  std::vector<std::string> bat;  // key=value
};

// One test of the command line: all of the files together, or each on its own, or each run of one file.
struct Test {
  int run = 0;
  std::unique_ptr<Analysis> analysis;
  std::optional<ImpactTest> deflection{};
};

std::vector<Test> tests_of_frfs(const AnalyzeFlags& flags, std::vector<FrfRecord> frfs) {
  if (flags.read.files != FilesMean::tests) {
    FrfRecord joined = join_frfs_of(flags.read, std::move(frfs));
    frfs.clear();
    frfs.push_back(std::move(joined));
  }
  std::vector<Test> tests;
  for (FrfRecord& record : frfs) {
    assume_angles(record);
    tests.push_back({.run = static_cast<int>(tests.size()),
                     .analysis = std::make_unique<Analysis>(std::move(record), analysis_options(flags.analysis))});
  }
  return tests;
}

std::vector<Test> tests_of(const AnalyzeFlags& flags) {
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty()) return tests_of_frfs(flags, std::move(opened.frfs));
  std::vector<Record> records = std::move(opened.records);
  if (flags.read.files != FilesMean::tests) {
    Record joined = join_records(std::move(records), flags.read.files);
    records.clear();
    records.push_back(std::move(joined));
  }
  std::vector<Test> tests;
  for (Record& record : records) {
    assume_angles(record);
    for (auto& [run, part] : split_runs(record)) {
      const int number = records.size() > 1 ? static_cast<int>(tests.size()) : run;
      tests.push_back(
          {.run = number, .analysis = std::make_unique<Analysis>(std::move(part), analysis_options(flags.analysis))});
    }
  }
  return tests;
}

void print_trace(const Analysis& analysis) {
  for (const auto& stage : analysis.trace().stages())
    std::cerr << fmt::format("{:<20} {:>6} calls  {:.6f} s\n", stage.name, stage.calls, stage.seconds);
}

CommandReport comparison_of(const AnalyzeFlags& flags, const std::string& document, const std::string& name) {
  std::vector<ComparedDocument> documents = parse_documents(document, name);
  for (const std::string& path : flags.compared) {
    for (ComparedDocument& one : read_documents(path)) documents.push_back(std::move(one));
  }
  return compare_report(documents);
}

std::string page_of(const AnalyzeFlags& flags, const Test& test, const std::set<Section>& sections,
                    const CommandReport* comparison) {
  return analysis_page(
      *test.analysis,
      {.sections = sections, .deflection = test.deflection ? &*test.deflection : nullptr, .comparison = comparison},
      provenance_now(flags.output));
}

std::string drawing_of(const AnalyzeFlags& flags, const Analysis& analysis) {
  const auto verdicts = analysis.possible() ? analysis.verdicts() : std::vector<Verdict>();
  return svg_document(analysis_charts(analysis, verdicts, flags.pictures));
}

void write_outputs(const AnalyzeFlags& flags, const std::vector<Test>& tests, const std::set<Section>& sections,
                   const std::string& document, const CommandReport* comparison) {
  for (const std::string& path : flags.output.paths) {
    if (extension_of(path) == ".json") {
      write_file(path, document, flags.output.force);
    } else if (is_html(path)) {
      write_file(path, page_of(flags, tests.front(), sections, comparison), flags.output.force);
    } else if (extension_of(path) == ".svg") {
      write_file(path, drawing_of(flags, *tests.front().analysis), flags.output.force);
    } else if (!tests.front().analysis->possible()) {
      remark(flags.output,
             "no hit can be used, so there are no FRFs to write (" + one_line(path) + "); see the hits' findings");
    } else if (is_uff(path)) {
      write_modes_uff(path, *tests.front().analysis, flags.output.force);
    } else {
      write_frfs(path, frf_record_of(*tests.front().analysis), FrfKind::accelerance, flags.output.force);
    }
  }
}

std::optional<BatLabel> bat_label(const AnalyzeFlags& flags) {
  if (flags.bat_id.empty() && !flags.bat.empty()) throw UsageError("--bat without --bat-id", "say which bat it is");
  if (flags.bat_id.empty()) return std::nullopt;
  BatLabel label{.id = flags.bat_id};
  for (const std::string& text : flags.bat) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
      throw UsageError("--bat " + one_line(text, 60) + ": not KEY=VALUE", "as --bat length_in=33");
    if (!label.properties.emplace(text.substr(0, equals), text.substr(equals + 1)).second)
      throw UsageError("--bat " + one_line(text, 60) + ": the key stands twice", "keep one");
  }
  return label;
}

bool is_json(const std::string& path) { return extension_of(path) == ".json"; }

// Before anything is computed.
void require_one_test(const AnalyzeFlags& flags, const std::set<Section>& sections, std::size_t tests) {
  if (tests < 2) return;
  const char* const remedy = "analyse one file or run at a time";
  if (!std::all_of(flags.output.paths.begin(), flags.output.paths.end(), is_json))
    throw UsageError("several tests do not fit one file of FRFs or one page", remedy);
  if (sections.contains(Section::deflection) || !flags.compared.empty())
    throw UsageError("deflections and comparisons are of one test", remedy);
}

ImpactTest deflection_of(const Analysis& analysis) {
  if (analysis.given_frfs() != nullptr)
    throw UsageError("FRFs tell no deflection", "give the record of force and acceleration");
  return deflect(analysis);
}

// What the sections need, as much at once as can be; what fails will fail again where the report asks for it, in turn.
void compute(const std::vector<Test>& tests, const std::set<Section>& sections) {
  constexpr std::size_t kPerTask = 1'000'000;  // operations, at the least
  const bool frfs = sections.contains(Section::frf) || sections.contains(Section::coherence);
  const bool modes = sections.contains(Section::modes), classes = sections.contains(Section::classes);
  if (!frfs && !modes && !classes) return;
  share_out(tests.size(), kPerTask, [&](std::size_t t) {
    const Analysis& analysis = *tests[t].analysis;
    try {
      if (!analysis.possible()) return;
      analysis.hits();  // shared by what follows
      share_out(2, kPerTask, [&](std::size_t task) {
        if (task == 0 && modes) analysis.modes();
        if (task == 1 && frfs) analysis.frfs();
      });
      if (classes) analysis.verdicts();
    } catch (const std::exception&) {
    }
  });
}

void check_analyze_outputs(const OutputFlags& output) {
  check_outputs(output, {".json", ".html", ".svg", ".csv", ".h5", ".mat", ".uff", ".unv"});
}

// What was found, for who runs the command in his own process and asks for the rest later.
struct KeptTests {
  AnalyzeFlags flags;
  std::vector<Test> tests;
  std::set<Section> sections;
  std::string document;
  std::optional<CommandReport> comparison;

  const CommandReport* compared() const { return comparison ? &*comparison : nullptr; }
};

std::string text_of(const KeptTests& kept, std::size_t width, bool sketch) {
  std::string text;
  for (const Test& test : kept.tests) {
    if (kept.tests.size() > 1) text += fmt::format("{}test {}\n", text.empty() ? "" : "\n", test.run);
    text += analysis_text(*test.analysis,
                          {.sections = kept.sections, .width = width, .per_hit = kept.flags.per_hit, .sketch = sketch});
    if (test.deflection) text += "\n" + deflection_tables(*test.analysis, *test.deflection).text(width);
    if (kept.comparison) text += "\n" + kept.comparison->text.text(width);
  }
  return text;
}

std::string html_of(const KeptTests& kept) {
  const bool classes = kept.sections.contains(Section::classes);
  std::string html;
  for (const Test& test : kept.tests) {
    if (kept.tests.size() > 1) html += page_paragraph(fmt::format("test {}", test.run));
    if (!test.analysis->possible()) {
      html += page_paragraph(kNoUsableHit);
    } else if (classes || kept.sections.contains(Section::modes)) {
      html += modes_table(*test.analysis, classes).html();
    } else {
      html += hits_table(*test.analysis, test.analysis->force_hits()).shown.html();
    }
    html += page_warnings(test.analysis->warnings());
  }
  return html;
}

void hand_over(const OutputFlags& output, const std::shared_ptr<const KeptTests>& kept) {
  Outcome& outcome = output.host->outcome;
  for (const Test& test : kept->tests) outcome.analyses.emplace_back(kept, test.analysis.get());
  if (const auto& deflection = kept->tests.front().deflection) outcome.deflection = {kept, &*deflection};
  outcome.text = [kept](std::size_t width) { return text_of(*kept, width, false); };
  outcome.html = [kept] { return html_of(*kept); };
  outcome.save = [kept, its = kept_output(output)](const std::string& path, bool force) {
    AnalyzeFlags flags = kept->flags;
    flags.output = one_output(its, path, force);
    check_analyze_outputs(flags.output);
    require_one_test(flags, kept->sections, kept->tests.size());
    write_outputs(flags, kept->tests, kept->sections, kept->document, kept->compared());
  };
}

int analyze(const AnalyzeFlags& flags) {
  const ThreadLimit limit(flags.analysis.threads);
  check_analyze_outputs(flags.output);
  const auto sections = flags.only.empty() ? all_sections() : parse_sections(flags.only);
  const bool wants_json = flags.output.json || !flags.compared.empty() ||
                          std::any_of(flags.output.paths.begin(), flags.output.paths.end(), is_json);
  if (flags.stabilisation && !wants_json)
    throw UsageError("--stabilisation goes into the JSON document", "add --json or -o FILE.json");
  const std::optional<BatLabel> bat = bat_label(flags);
  const Progress progress("analysing", flags.output.quiet);
  auto tests = tests_of(flags);
  require_one_test(flags, sections, tests.size());
  compute(tests, sections);
  if (sections.contains(Section::deflection)) tests.front().deflection = deflection_of(*tests.front().analysis);
  std::string document;
  if (wants_json) {
    std::vector<NumberedAnalysis> numbered;
    numbered.reserve(tests.size());
    for (const Test& test : tests) numbered.push_back({.run = test.run, .analysis = test.analysis.get()});
    document = analysis_json(numbered, {.sections = sections,
                                        .trace = flags.trace,
                                        .explain = flags.explain,
                                        .per_hit = flags.per_hit,
                                        .stabilisation = flags.stabilisation,
                                        .bat = bat,
                                        .deflection = tests.front().deflection ? &*tests.front().deflection : nullptr});
  }
  std::optional<CommandReport> comparison;
  if (!flags.compared.empty()) comparison = comparison_of(flags, document, inputs_of(*tests.front().analysis).front());
  const auto kept = std::make_shared<const KeptTests>(KeptTests{.flags = flags,
                                                                .tests = std::move(tests),
                                                                .sections = sections,
                                                                .document = std::move(document),
                                                                .comparison = std::move(comparison)});
  const std::string text = flags.output.json ? "" : text_of(*kept, terminal_width(), can_sketch());
  progress.stop();
  write_outputs(flags, kept->tests, sections, kept->document, kept->compared());
  print(flags.output, flags.output.json ? kept->document : text);
  if (flags.output.host != nullptr) hand_over(flags.output, kept);
  if (flags.trace && !flags.output.json) {
    for (const Test& test : kept->tests) print_trace(*test.analysis);
  }
  if (flags.explain && !flags.output.json) {
    for (const Test& test : kept->tests) std::cerr << skipped_text(*test.analysis).text(terminal_width());
  }
  const bool possible =
      std::all_of(kept->tests.begin(), kept->tests.end(), [](const Test& test) { return test.analysis->possible(); });
  return possible ? kOk : kImpossible;
}

}  // namespace

void add_analyze(CommandLine& line) {
  auto flags = line.values<AnalyzeFlags>();
  Command command =
      line.command("analyze", "Modes of a structure from hammer tests: hits, FRFs, modes, bending or hoop",
                   [flags] { return analyze(*flags); });
  command.about(
      "Reads records of force and acceleration, cuts them into hits and grades these, averages the good ones to "
      "frequency responses (FRFs) and fits the modes: frequency in Hz, damping ratio, bending or hoop, each with its "
      "standard deviation. Give FRFs in place of records to fit those. Two accelerometers are taken to sit at 0° and "
      "90° around the barrel unless --angle says otherwise.");
  command.example("percuss analyze bat.h5 --band 60:3200", "Hits and modes between 60 and 3200 Hz as tables");
  command.example("percuss analyze bat.h5 --band 60:3200 -o report.html -o modes.json",
                  "The same as a page to look at and as a document to compute with");
  command.example("percuss analyze bat.h5 --only hits",
                  "The hits alone and what was found against them: fast, before a long session goes on");
  command.example("percuss analyze bat.h5 --reject-hit 2 --effort quick --json",
                  "Without the third hit, roughly, as a JSON document");
  command.example("percuss analyze frfs.h5", "Modes of frequency responses that were measured or computed elsewhere");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, ".json, .html, .svg, .csv, .h5, .mat, .uff, .unv");
  command.list("--only", flags->only, "Compute and report these sections only")
      .type("SECTION,...")
      .one_of({"hits", "frf", "coherence", "modes", "classes", "deflection"});
  command.list("--picture", flags->pictures, "What -o FILE.svg shows")
      .type("PICTURE,...")
      .one_of(analysis_chart_names());
  command
      .repeatable("--compare", flags->compared,
                  "Also beside this document, which analyze, survey or model wrote with --json (repeatable)")
      .type("FILE");
  command.flag("--per-hit", flags->per_hit, "Also every mode as each hit alone shows it, for how far the hits agree");
  command.flag("--stabilisation", flags->stabilisation, "Also the poles of all model orders, in the JSON document");
  command.value("--bat-id", flags->bat_id, "Which bat it is: into the document, where percuss study joins by it")
      .type("ID");
  command.repeatable("--bat", flags->bat, "What else is known of the bat, as length_in=33 (repeatable)")
      .type("KEY=VALUE");
  command.flag("--trace", flags->trace,
               "What ran: stages, calls, seconds (on standard error, or in the JSON document)");
  command.flag("--explain", flags->explain,
               "What did not have to be done, how much of it, and why (on standard error, or in the JSON document)");
}

}  // namespace percuss::tools
