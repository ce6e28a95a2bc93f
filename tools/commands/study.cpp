#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"
#include "report/csv/study_csv.hpp"
#include "report/study_report.hpp"
#include "report/svg/study_charts.hpp"
#include "synth/population.hpp"

namespace percuss::tools {
namespace {

constexpr std::uint64_t kMaxTable_bytes = std::uint64_t{16} << 20U;

struct StudyFlags {
  std::vector<std::string> inputs, programs;
  std::string figures, key, table, curve;
  bool example = false, keep_formulas = false;
  OutputFlags output;
};

std::string text_at(const std::string& path) { return std::string(read_input(path, kMaxTable_bytes).view()); }

void write_figures(const StudyFlags& flags, const metrics::Study& study, const report::CommandReport& report,
                   const std::optional<metrics::StudyCurve>& curve) {
  if (flags.figures.empty()) return;
  std::error_code problem;
  std::filesystem::create_directories(flags.figures, problem);
  if (problem) throw InputError("cannot create the folder", flags.figures, "name a folder that can be written");
  for (const report::StudyFile& file : report::study_files(study, curve, csv_formulas(flags.keep_formulas)))
    write_file((std::filesystem::path(flags.figures) / file.name).string(), file.text, flags.output.force);
  write_file((std::filesystem::path(flags.figures) / "statistics.csv").string(), report.csv(), flags.output.force);
  write_file((std::filesystem::path(flags.figures) / "groups.csv").string(),
             report::study_groups_csv(study, csv_formulas(flags.keep_formulas)), flags.output.force);
}

int run_study(const StudyFlags& flags) {
  if (flags.example) {
    print(flags.output, metrics::study_table_csv(synth::synthetic_population()));
    return kOk;
  }
  if (flags.inputs.empty()) {
    throw OptionError({}, "no table is given",
                      "name a table of bats, or documents of analyze, metrics, certify or abi that name their bat",
                      {"analyze.bat_id"});
  }
  if (!flags.curve.empty() && flags.figures.empty() && !writes_charts(flags.output)) {
    throw OptionError({"hoop_curve"}, "needs a figure to be drawn in", "write figures, or a .svg or .html file",
                      {"figures", "output"});
  }
  check_report_outputs(flags.output);
  for (const std::string& path : {flags.key, flags.table}) {
    if (!path.empty()) require_output_path(path, flags.output.force);
  }
  metrics::StudyRows rows;
  const std::vector<std::string> inputs = matched_files(flags.inputs);
  for (const std::string& path : inputs) rows.add(text_at(path), input_name(path));
  std::vector<metrics::StudyBat> bats = rows.bats();
  OutputGroup outputs;
  const CsvFormulas formulas = csv_formulas(flags.keep_formulas);
  if (!flags.key.empty()) write_file(flags.key, metrics::anonymise_bats(bats, formulas), flags.output.force);
  if (!flags.table.empty()) write_file(flags.table, metrics::study_table_csv(bats, formulas), flags.output.force);
  const metrics::Study study = metrics::study_of(std::move(bats), {.programs = flags.programs});
  std::optional<metrics::StudyCurve> curve;
  if (!flags.curve.empty()) curve = metrics::parse_study_curve(text_at(flags.curve), input_name(flags.curve));
  const report::CommandReport report = report::study_report(study, curve, formulas);
  write_figures(flags, study, report, curve);
  const int code = show_report(report, flags.output, inputs);
  outputs.commit();
  return code;
}

}  // namespace

void add_study(CommandLine& line) {
  auto flags = line.values<StudyFlags>();
  Command command = line.command("study", "Correlate the properties of a population of bats with their performance",
                                 [flags] { return run_study(*flags); });
  command.about(
      "Joins tables of bats, results of percuss batch merge, and documents of percuss analyze and metrics with "
      "--bat-id, of certify and of abi, by the id of the bat. Tests which properties "
      "correlate with performance: reports each hypothesis with verdict, p-value, and correlations with 95 % "
      "intervals. --example prints a table with all known columns.");
  command.example("percuss study --example > bats.csv; percuss study bats.csv --figures figures",
                  "Study a synthetic population, and write every figure as picture and table");
  command.example(
      "percuss study --example > bats.csv; percuss model trampoline --json > model.json; percuss study bats.csv "
      "--hoop-curve model.json -o study.html",
      "Write a page, with a model drawn over the measured points");
  command.arguments("TABLE", flags->inputs,
                    "Tables of bats, results of percuss batch merge, and documents of percuss analyze and metrics with "
                    "--bat-id, of certify and of abi; joined by id");
  command.value("--figures", flags->figures, "Write every figure as picture and table into this folder").type("FOLDER");
  command
      .list("--program", flags->programs,
            "Count the bats of these certification programs in statements, trends and correlations; default: besr and "
            "bats without a program; if there are none, the program with the most bats; all: every bat")
      .type("NAME,...");
  command
      .value("--hoop-curve", flags->curve,
             "Draw this model over the hoop figures; a document of percuss model trampoline --json")
      .type("FILE");
  command.value("--blind", flags->key, "Replace the ids of the bats by neutral ones, and write the key to this file")
      .type("FILE");
  command.value("--table", flags->table, "Write the joined table").type("FILE");
  command.flag("--example", flags->example, "Print an example table: a synthetic population");
  add_output_flags(command, flags->output, report_extensions());
  add_formula_flag(command, flags->keep_formulas);
}

}  // namespace percuss::tools
