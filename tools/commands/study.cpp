#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"
#include "report/study_report.hpp"
#include "report/svg/study_charts.hpp"
#include "synth/population.hpp"

namespace percuss::tools {
namespace {

constexpr std::uint64_t kLargestTable_bytes = std::uint64_t{16} << 20U;

struct StudyFlags {
  std::vector<std::string> inputs;
  std::string figures, key, table, curve;
  bool example = false;
  OutputFlags output;
};

std::string text_at(const std::string& path) { return std::string(read_input(path, kLargestTable_bytes).view()); }

void refuse_existing(const StudyFlags& flags) {
  for (const std::string& path : {flags.key, flags.table}) {
    std::error_code ignored;
    if (!path.empty() && !flags.output.force && std::filesystem::exists(path, ignored))
      throw InputError("file exists", path, "give another name or --force");
  }
}

void write_figures(const StudyFlags& flags, const metrics::Study& study, const report::CommandReport& report,
                   const std::optional<metrics::StudyCurve>& curve) {
  if (flags.figures.empty()) return;
  std::error_code problem;
  std::filesystem::create_directories(flags.figures, problem);
  if (problem) throw InputError("cannot make the folder", flags.figures, "name one that can be written");
  for (const report::StudyFile& file : report::study_files(study, curve))
    write_file((std::filesystem::path(flags.figures) / file.name).string(), file.text, flags.output.force);
  write_file((std::filesystem::path(flags.figures) / "statistics.csv").string(), report.csv(), flags.output.force);
}

int run_study(const StudyFlags& flags) {
  if (flags.example) {
    print(flags.output, metrics::study_table_csv(synth::synthetic_population()));
    return kOk;
  }
  if (flags.inputs.empty()) throw UsageError("no table", "name a table of bats, or analyses with --bat-id");
  if (!flags.curve.empty() && flags.figures.empty() && !writes_charts(flags.output))
    throw UsageError("--hoop-curve goes into the figures", "add --figures FOLDER, -o FILE.svg or -o FILE.html");
  check_report_outputs(flags.output);
  refuse_existing(flags);
  metrics::StudyRows rows;
  for (const std::string& path : flags.inputs) rows.add(text_at(path), input_name(path));
  std::vector<metrics::StudyBat> bats = rows.bats();
  if (!flags.key.empty()) write_file(flags.key, metrics::anonymise_bats(bats), flags.output.force);
  if (!flags.table.empty()) write_file(flags.table, metrics::study_table_csv(bats), flags.output.force);
  const metrics::Study study = metrics::study_of(std::move(bats));
  std::optional<metrics::StudyCurve> curve;
  if (!flags.curve.empty()) curve = metrics::parse_study_curve(text_at(flags.curve), input_name(flags.curve));
  const report::CommandReport report = report::study_report(study, curve);
  write_figures(flags, study, report, curve);
  return show_report(report, flags.output, flags.inputs);
}

}  // namespace

void add_study(CommandLine& line) {
  auto flags = line.values<StudyFlags>();
  Command command = line.command("study", "A population of bats: what goes with performance, in figures and numbers",
                                 [flags] { return run_study(*flags); });
  command.about(
      "Joins tables of bats, analyses made with --bat-id and results of percuss batch merge, and judges what goes with "
      "performance: for each "
      "statement a verdict, its p and correlations with their 95 % intervals. --example prints a table with all "
      "columns that are understood.");
  command.example("percuss study --example > bats.csv; percuss study bats.csv --figures figures",
                  "A made-up population, with every figure as picture and table");
  command.example(
      "percuss study --example > bats.csv; percuss model trampoline --json > model.json; percuss study bats.csv "
      "--hoop-curve model.json -o study.html",
      "A page, a model drawn over the measured points");
  command.words("TABLE", flags->inputs,
                "Tables of bats, analyses (--bat-id), and results of percuss batch merge, joined by id");
  command.value("--figures", flags->figures, "Write every figure as picture and table into this folder").type("FOLDER");
  command.value("--hoop-curve", flags->curve, "Draw this model over the hoop figures: percuss model trampoline --json")
      .type("FILE");
  command.value("--blind", flags->key, "Give the bats neutral ids; the key to them goes into this file").type("FILE");
  command.value("--table", flags->table, "Write the joined table").type("FILE");
  command.flag("--example", flags->example, "Print a table of bats (a made-up population)");
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
