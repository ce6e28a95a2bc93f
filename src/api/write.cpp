#include "percuss/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "acquire/format_registry.hpp"
#include "acquire/record/file_format.hpp"
#include "acquire/write_record.hpp"
#include "api/handles.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "report/deflection_report.hpp"
#include "report/html/analysis_page.hpp"
#include "report/html/logo.hpp"
#include "report/html/survey_page.hpp"
#include "report/json/analysis_json.hpp"
#include "report/json/survey_json.hpp"
#include "report/modes_uff.hpp"
#include "report/survey_files.hpp"
#include "report/svg/analysis_charts.hpp"
#include "report/svg/survey_charts.hpp"
#include "report/text/creation_time.hpp"

namespace percuss {
namespace api {
namespace {

/// The extension of `path`. errors  InputError: the extension is not in `known`; the file exists.
std::string checked_extension(const std::string& path, const std::vector<std::string>& known,
                              const WriteOptions& options) {
  std::string extension = acquire::file_extension(path);
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw InputError("the file's extension is not known", path,
                     fmt::format("use a name that ends in {}", fmt::join(known, ", ")));
  }
  std::error_code ignored;
  if (!options.overwrite && std::filesystem::exists(path, ignored))
    throw InputError("the file exists", path, "give another name, or overwrite it", {"force"});
  return extension;
}

bool is_uff(const std::string& extension) { return extension == ".uff" || extension == ".unv"; }

report::TitleBlock title_block(const PageTitle& title) {
  return {.title = title.title,
          .customer = title.customer,
          .operator_name = title.operator_name,
          .specimen = title.specimen,
          .date = title.date,
          .note = title.note,
          .logo = title.logo.empty() ? "" : report::logo_of_file(title.logo),
          .facts = {}};
}

report::Provenance provenance(const WriteOptions& options) {
  return {.command = options.produced_by,
          .made_at = options.produced_at.empty() ? report::creation_time() : options.produced_at,
          .title_block = title_block(options.title)};
}

std::vector<std::string> chosen_pictures(const WriteOptions& options, const std::vector<std::string>& known,
                                         const std::vector<std::string>& defaults) {
  for (const std::string& name : options.picture) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError("there is no picture " + name, "WriteOptions::picture",
                       fmt::format("choose from {}", fmt::join(known, ", ")), {"picture"});
    }
  }
  return options.picture.empty() ? defaults : options.picture;
}

void require_possible(const pipeline::Analysis& analysis) {
  if (!analysis.possible()) {
    throw InputError(
        "no hit can be used, so there are no FRFs and modes", analysis.record().source(),
        "see the findings of the hits",
        pipeline::can_accept_more(analysis.hits()) ? std::vector<OptionId>{"accept_hit"} : std::vector<OptionId>{});
  }
}

}  // namespace
}  // namespace api

void write(const std::string& path, const Record& record, const WriteOptions& options) {
  api::checked_extension(path, acquire::record_extensions(), options);
  acquire::write_record(path, record.data().record, options.overwrite);
}

void write(const std::string& path, const FrfSet& frfs, const WriteOptions& options) {
  api::checked_extension(path, {".csv", ".h5", ".hdf5", ".mat", ".uff", ".unv"}, options);
  acquire::write_frfs(path, frfs.data().record, api::frf_kind(options.kind.value_or(frfs.kind())), options.overwrite);
}

void write(const std::string& path, const Analysis& analysis, const WriteOptions& options) {
  const std::string kind =
      api::checked_extension(path, {".json", ".html", ".svg", ".csv", ".h5", ".hdf5", ".mat", ".uff", ".unv"}, options);
  const pipeline::Analysis& internal = analysis.data().analysis;
  if (kind == ".json") {
    write_file(path, report::analysis_json(internal), options.overwrite);
  } else if (kind == ".html") {
    write_file(path, report::analysis_page(internal, {}, api::provenance(options)), options.overwrite);
  } else if (kind == ".svg") {
    const auto names =
        api::chosen_pictures(options, report::analysis_chart_names(), {"magnitude", "phase", "coherence"});
    const auto types = internal.possible() ? internal.classifications() : std::vector<identify::ModeClassification>();
    write_file(path, report::svg_document(report::analysis_charts(internal, types, names)), options.overwrite);
  } else {
    api::require_possible(internal);
    if (api::is_uff(kind)) {
      report::write_modes_uff(path, internal, options.overwrite);
    } else {
      write(path, analysis.frfs(), options);
    }
  }
}

void write(const std::string& path, const Survey& survey, const WriteOptions& options) {
  const std::string kind =
      api::checked_extension(path, {".json", ".html", ".svg", ".csv", ".h5", ".hdf5", ".uff", ".unv"}, options);
  const pipeline::Survey& internal = api::computed(survey);
  if (kind == ".json") {
    write_file(path, report::survey_json(internal), options.overwrite);
  } else if (kind == ".html") {
    write_file(path, report::survey_page(internal, api::provenance(options)), options.overwrite);
  } else if (kind == ".svg") {
    const auto names = api::chosen_pictures(options, report::survey_chart_names(), {"shapes"});
    write_file(path, report::svg_document(report::survey_charts(internal, names)), options.overwrite);
  } else {
    api::require_possible(internal.analysis());
    if (kind == ".csv") {
      write_file(path, path.ends_with(".cmif.csv") ? report::cmif_csv(internal) : report::shapes_csv(internal),
                 options.overwrite);
    } else if (api::is_uff(kind)) {
      report::write_modes_uff(path, internal, options.overwrite);
    } else {
      report::write_survey_hdf5(path, internal, options.overwrite);
    }
  }
}

void write(const std::string& path, const Deflections& deflections, const WriteOptions& options) {
  const std::string kind = api::checked_extension(path, {".json", ".csv", ".h5", ".hdf5"}, options);
  const pipeline::Analysis& analysis = deflections.data().analysis->analysis;
  const pipeline::ImpactTest& test = deflections.data().test;
  if (acquire::writes_hdf5(path)) {
    report::write_deflection_hdf5(path, analysis, test, options.overwrite);
  } else {
    write_file(path, kind == ".csv" ? report::deflection_csv(analysis, test) : deflections.json(), options.overwrite);
  }
}

}  // namespace percuss
