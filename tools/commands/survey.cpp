#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>

#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/output.hpp"
#include "cli/page_output.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "commands/survey_files.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/parse_number.hpp"
#include "report/gltf/shapes_glb.hpp"
#include "report/html/survey_page.hpp"
#include "report/json/survey_json.hpp"
#include "report/modes_uff.hpp"
#include "report/survey_files.hpp"
#include "report/svg/survey_charts.hpp"
#include "report/text/analysis_text.hpp"
#include "report/text/survey_text.hpp"

namespace percuss::tools {
namespace {

struct SurveyFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::string geometry_path;
  std::vector<std::string> pictures{"shapes"};
  std::string roving;
  std::vector<std::string> driving;
  bool hits = false;
  bool trace = false;
  bool example = false;
};

// Reads "POINT" or "POINT:CHANNEL", where POINT is a number or the name of a file.
pipeline::StatedDrivingPoint parse_driving(const std::string& text) {
  pipeline::StatedDrivingPoint at;
  const auto number = [](std::string_view digits, auto& value) {
    if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return false;
    return std::from_chars(digits.data(), digits.data() + digits.size(), value).ec == std::errc{};
  };
  const std::size_t colon = text.rfind(':');
  const std::string point = text.substr(0, colon);
  if (point.empty() || (colon != std::string::npos && !number(std::string_view(text).substr(colon + 1), at.channel))) {
    throw OptionError::wrong_value(
        "driving_point", text, "give POINT:CHANNEL, the point's number and the channel counted from 0, such as 17:0");
  }
  if (!number(point, at.point)) at.file = point;
  return at;
}

pipeline::SurveyOptions survey_options(const SurveyFlags& flags) {
  pipeline::SurveyOptions options;
  if (!flags.roving.empty())
    options.roving = flags.roving == "sensor" ? identify::Roving::sensor : identify::Roving::hammer;
  for (const std::string& text : flags.driving) options.stated_driving.push_back(parse_driving(text));
  if (!flags.geometry_path.empty()) {
    options.geometry = acquire::read_geometry(flags.geometry_path);
    options.geometry_source = flags.geometry_path;
  }
  return options;
}

// The analysis knows the geometry's numbers, by which it names points.
std::unique_ptr<pipeline::Analysis> analysis_of(const SurveyFlags& flags, const pipeline::SurveyOptions& survey) {
  pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  if (survey.geometry) {
    for (const acquire::GeometryPoint& p : survey.geometry->points) options.geometry_points.insert(p.point);
  }
  return survey_analysis(flags.read, options);
}

bool is_indicator(const std::string& path) { return path.ends_with(".cmif.csv"); }

const std::vector<std::string>& survey_extensions() {
  static const std::vector<std::string> kExtensions{".json", ".html", ".svg", ".csv", ".h5",
                                                    ".hdf5", ".uff",  ".unv", ".glb"};
  return kExtensions;
}

void check_survey_outputs(const OutputFlags& output) { check_outputs(output, survey_extensions()); }

void write_outputs(const SurveyFlags& flags, const pipeline::Survey& survey, const std::string& document) {
  OutputGroup outputs;
  for (const std::string& path : flags.output.paths) {
    const std::string kind = extension_of(path);
    if (kind == ".json") {
      write_file(path, document, flags.output.force);
    } else if (is_page(path)) {
      write_page(path, report::survey_page(survey, provenance_now(flags.output, flags.read.setup_path)), flags.output);
    } else if (kind == ".svg") {
      write_file(path, report::svg_document(report::survey_charts(survey, flags.pictures)), flags.output.force);
    } else if (!survey.analysis().possible()) {
      print_note(
          flags.output,
          {"no hit can be used, so no shapes are written (" + one_line(path) + "); see the findings of the hits", {}});
    } else if (kind == ".csv") {
      write_file(path, is_indicator(path) ? report::cmif_csv(survey) : report::shapes_csv(survey), flags.output.force);
    } else if (is_uff(path)) {
      report::write_modes_uff(path, survey, flags.output.force);
    } else if (kind == ".glb") {
      write_file(path, report::shapes_glb(survey), flags.output.force);
    } else {
      report::write_survey_hdf5(path, survey, flags.output.force);
    }
  }
  outputs.commit();
}

// A survey and the analysis that it refers to.
struct SurveyResults {
  std::shared_ptr<const pipeline::Analysis> analysis;
  pipeline::Survey survey;
};

void give_to_host(const SurveyFlags& flags, const std::shared_ptr<const SurveyResults>& results,
                  const std::string& document) {
  CommandResult& outcome = flags.output.host->outcome;
  outcome.analyses = {results->analysis};
  outcome.survey = {results, &results->survey};
  outcome.text = [results, hits = flags.hits](std::size_t width, OptionWriter write_option) {
    return report::survey_text(results->survey, hits, width, write_option);
  };
  outcome.html = [results] {
    return results->analysis->possible()
               ? report::survey_modes_table(results->survey).html()
               : report::page_paragraph(report::no_usable_hit(results->analysis->hits()).text);
  };
  SurveyFlags captured = flags;
  captured.output = captured_output(flags.output);
  outcome.save = [results, document, captured](const SaveRequest& request) {
    SurveyFlags file_flags = captured;
    file_flags.output = single_output(captured.output, request);
    check_survey_outputs(file_flags.output);
    write_outputs(file_flags, results->survey, document);
  };
}

int run_survey(const SurveyFlags& flags) {
  if (flags.example) {
    print(flags.output, acquire::geometry_example());
    return kOk;
  }
  check_survey_outputs(flags.output);
  const pipeline::SurveyOptions options = survey_options(flags);
  Progress progress("analysing", flags.output.quiet);
  const std::shared_ptr<const pipeline::Analysis> shared_analysis = analysis_of(flags, options);
  const pipeline::Analysis& analysis = *shared_analysis;
  const auto results =
      std::make_shared<const SurveyResults>(SurveyResults{.analysis = shared_analysis, .survey = {analysis, options}});
  const pipeline::Survey& survey = results->survey;
  analysis.hits();
  if (analysis.possible()) analysis.compute_modes_and_frfs();  // used by both the text and the document
  const bool wants_json =
      flags.output.json || std::any_of(flags.output.paths.begin(), flags.output.paths.end(), is_json);
  const std::string document = wants_json ? report::survey_json(survey, {.trace = flags.trace}) : "";
  const std::string text =
      flags.output.json ? "" : report::survey_text(survey, flags.hits, terminal_width(), flag_of, !flags.output.quiet);
  progress.stop();
  write_outputs(flags, survey, document);
  print(flags.output, flags.output.json ? document : text);
  if (flags.output.host != nullptr) give_to_host(flags, results, document);
  if (flags.trace && !flags.output.json) print_trace(analysis);
  return analysis.possible() ? kOk : kImpossible;
}

}  // namespace

void add_survey(CommandLine& line) {
  auto flags = line.values<SurveyFlags>();
  Command command = line.command("survey", "Identify mode shapes from a test of many points: MAC, modal mass, orders",
                                 [flags] { return run_survey(*flags); });
  command.about(
      "Analyses a test of many points: mode shapes, their MAC, modal masses if a driving point is known, and bending "
      "or hoop with the circumferential order from the shapes. A file holds all points, one point (P1, P2, ...) or "
      "hits of one point (P1_1, P1_2, ...). A geometry file gives their coordinates; --example prints one.");
  command.example("percuss survey barrel.h5 --band 60:3200",
                  "Identify the shapes of a barrel whose record holds the geometry");
  command.example(
      "percuss survey --example > points.csv; percuss survey barrel.h5 --geometry points.csv -o shapes.csv -o "
      "modes.cmif.csv",
      "Read the geometry from a file, and write shapes and mode indicator as tables");
  command.example("percuss survey barrel.h5 --band 60:3200 -o survey.html -o shapes.glb",
                  "Write a page that animates the shapes, and a file for 3-D viewers");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, survey_extensions());
  command
      .value(
          "--geometry", flags->geometry_path,
          "Read the geometry from this file, a CSV as --example prints it; further columns, dx, dy and dz or direction "
          "(+x ... -z), state where the blow or the roving sensor points (default: from the record)")
      .type("FILE");
  command
      .value("--roving", flags->roving,
             "Choose what moved from point to point (default: as the file states, else hammer)")
      .one_of({"hammer", "sensor"});
  command
      .list("--driving-point", flags->driving,
            "Name driving points: a point struck beside the sensor of a channel, by the point's number and the "
            "channel's, which counts from 0 as in JSON; 1:0 is point 1 and the first channel. Where each file is a "
            "point, POINT is the file's name (P7:0) or a number. The number is the one in the file's name, else of a "
            "geometry that counts from 1, else of the record (default: points at the position of a sensor)")
      .type("POINT:CHANNEL,...");
  command.list("--picture", flags->pictures, "Draw these pictures in a .svg file")
      .one_of(report::survey_chart_names())
      .type("PICTURE,...");
  command.flag("--hits", flags->hits, "Add the table of hits");
  command.flag("--trace", flags->trace, "Report the stages that ran: calls and seconds");
  command.flag("--example", flags->example, "Print an example of a geometry file");
}

}  // namespace percuss::tools
