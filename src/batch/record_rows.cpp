#include "batch/record_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "acquire/open_measurement.hpp"
#include "batch/serialized_frf.hpp"
#include "batch/sha256_file.hpp"
#include "core/budget.hpp"
#include "core/error.hpp"
#include "pipeline/response/missing_results.hpp"
#include "pipeline/response/response_test.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/frf_files.hpp"
#include "report/text/analysis_text.hpp"

namespace percuss::batch {
namespace {

using Json = nlohmann::ordered_json;

// The exit codes of percuss analyze.
constexpr int kInternalError = 1, kUsageError = 2, kBadInput = 3, kImpossible = 4;

std::string line_of(const Json& row) { return row.dump(-1, ' ', false, Json::error_handler_t::replace); }

// In the messages of require_unchanged(), by which file_came_back() recognises them, and in no other.
constexpr std::string_view kPlanned = "the batch was planned";

void require_unchanged(const BatchRecord& record) {
  constexpr const char* kRestore = "restore it and run the batch again, or plan the batch again";
  std::error_code absent;
  const std::uint64_t bytes = std::filesystem::file_size(record.path, absent);
  if (absent == std::errc::no_such_file_or_directory)
    throw InputError(fmt::format("the file is missing; it existed when {}", kPlanned), record.path, kRestore);
  if (absent) return;  // opening the file reports it
  if (bytes != record.bytes) {
    throw InputError(fmt::format("the file has {} bytes; it had {} when {}", bytes, record.bytes, kPlanned),
                     record.path, kRestore);
  }
  if (!record.sha256.empty() && sha256_of_record(record.path) != record.sha256) {
    throw InputError(fmt::format("the file changed after {}: its SHA-256 differs", kPlanned), record.path, kRestore);
  }
}

/// The contents of the rows of a record, collected over its runs.
struct RowContents {
  int code = 0;
  std::string reason;
  Json fs_Hz, band_Hz{Json(), Json()};
  std::size_t accepted = 0, rejected = 0;
  std::set<acquire::FindingCode> findings;
  bool short_hit = false;             // finding of a record without a force: a hit has no usable decay
  std::vector<std::string> warnings;  // in order of appearance
  std::vector<Json> modes;
  std::vector<Json> frfs;
};

void add_hits(RowContents& rows, const pipeline::Analysis& analysis) {
  for (const pipeline::AnalysedHit& hit : analysis.hits()) {
    ++(hit.accepted ? rows.accepted : rows.rejected);
    for (const acquire::Finding& finding : hit.hit.findings) rows.findings.insert(finding.code);
  }
}

void add_classification(Json& row, const identify::ModeClassification& classification) {
  row["family"] = name_of(classification.type);
  row["order"] = classification.order > 0 ? Json(classification.order) : Json();
  row["confidence"] = classification.confidence;
  row["alternative"] = classification.alternative ? Json(name_of(*classification.alternative)) : Json();
  row["overlay_difference_db"] = classification.overlay_dB ? Json(*classification.overlay_dB) : Json();
  row["overlaid"] = classification.overlay_dB ? Json(classification.overlaid) : Json();
  row["ratio_re"] = classification.ratio ? Json(classification.ratio->real()) : Json();
  row["ratio_im"] = classification.ratio ? Json(classification.ratio->imag()) : Json();
  row["ratio_std"] = classification.ratio ? Json(classification.ratio_std) : Json();
  const auto& peak = classification.split_mode;
  row["double_peak_partner"] = peak ? Json(peak->partner) : Json();
  row["double_peak_separation_hz"] = peak ? Json(peak->separation_Hz) : Json();
  row["double_peak_first"] = peak ? Json(peak->first) : Json();
}

Json row_start(const char* kind, const BatchRecord& record) {
  return {{"row", kind}, {"id", record.id}, {"path", record.path}};
}

/// The run of a mode, and its index among the modes of the run.
struct ModeOfRun {
  int run = 0;
  std::size_t index = 0;
};

void add_mode(RowContents& rows, const BatchRecord& record, const ModeOfRun& at, const identify::Mode& mode,
              const identify::ModeClassification& classification) {
  Json row = row_start("mode", record);
  row["run"] = at.run;
  row["index"] = at.index;
  row["frequency_hz"] = mode.pole.freq_Hz;
  row["frequency_std_hz"] = mode.freq_std_Hz;
  row["damping_ratio"] = mode.pole.damping_ratio;
  row["damping_ratio_std"] = mode.damping_std;
  add_classification(row, classification);
  rows.modes.push_back(std::move(row));
}

void add_warnings(RowContents& rows, const std::vector<pipeline::Warning>& warnings) {
  for (const pipeline::Warning& warning : warnings) {
    auto& known = rows.warnings;
    if (std::find(known.begin(), known.end(), warning.code) == known.end()) known.push_back(warning.code);
  }
}

std::string written(const Message& message, OptionWriter write_option) {
  return write_option != nullptr ? message.written(write_option) : message.text;
}

void add_run(RowContents& rows, const BatchRecord& record, const pipeline::RunAnalysis& test,
             const RowOptions& options) {
  const pipeline::Analysis& analysis = *test.analysis;
  const bool given = analysis.given_frfs() != nullptr;  // FRFs have no sampling rate
  rows.fs_Hz = given ? Json() : Json(analysis.record().fs_Hz);
  add_hits(rows, analysis);
  if (analysis.possible()) {
    rows.band_Hz = {analysis.band_Hz().first, analysis.band_Hz().second};
    for (std::size_t m = 0; m < analysis.modes().size(); ++m)
      add_mode(rows, record, {.run = test.run, .index = m}, analysis.modes()[m], analysis.classifications()[m]);
  } else {
    rows.code = kImpossible;
    rows.reason = written(report::no_usable_hit(analysis.hits()), options.write_option);
  }
  add_warnings(rows, analysis.warnings());
  if (!options.frf || !analysis.possible()) return;
  Json row = row_start("frf", record);
  row["run"] = test.run;
  row["packed"] = serialize_frfs(report::frf_record_of(analysis));
  rows.frfs.push_back(std::move(row));
}

// Refuses, as the command `analyze` does, options that need a force.
void require_no_force_options(const RowOptions& options) {
  const std::vector<OptionId> stated = pipeline::stated_force_options(options.analysis);
  if (stated.empty()) return;
  const auto write = [&](const OptionId& id) {
    return options.write_option != nullptr ? options.write_option(id) : id;
  };
  throw UsageError(write(stated.front()) + " needs a force, and none was recorded",
                   fmt::format("leave it out, or name the force's channel ({})", write("force_channel")));
}

// A run of a record without a force. There are no FRFs.
void add_response_run(RowContents& rows, const BatchRecord& record, int run, const pipeline::ResponseTest& test,
                      const RowOptions& options) {
  rows.fs_Hz = test.record.fs_Hz;
  for (const pipeline::ResponseHit& hit : test.hits) {
    ++(hit.accepted ? rows.accepted : rows.rejected);
    rows.short_hit = rows.short_hit || !hit.reason.empty();
  }
  if (test.possible()) {
    rows.band_Hz = {test.band_Hz.first, test.band_Hz.second};
    for (std::size_t m = 0; m < test.found.modes.size(); ++m)
      add_mode(rows, record, {.run = run, .index = m}, test.found.modes[m].mode, test.classifications[m]);
  } else {
    rows.code = kImpossible;
    rows.reason = written(pipeline::why_impossible(test), options.write_option);
  }
  add_warnings(rows, test.warnings);
}

void add_runs(RowContents& rows, const BatchRecord& record, acquire::Measurement opened, const RowOptions& options) {
  const auto* const one = std::get_if<acquire::Record>(&opened);
  if (one == nullptr || one->has_force) {
    for (const pipeline::RunAnalysis& test : pipeline::analyses_of_runs(std::move(opened), options.analysis))
      add_run(rows, record, test, options);
    return;
  }
  require_no_force_options(options);
  for (auto& [run, part] : pipeline::split_runs(*one))
    add_response_run(rows, record, run, pipeline::analyse_responses(std::move(part), options.analysis), options);
}

// Turns errors into the exit codes and messages of the command `analyze`.
RowContents row_contents_of(const BatchRecord& record, const RowOptions& options) {
  RowContents rows;
  const auto failed_record = [](int code, const std::string& reason) {
    return RowContents{.code = code, .reason = reason};
  };
  try {
    require_unchanged(record);
    auto opened = options.fork_server != nullptr
                      ? acquire::open_measurement_forked(options.fork_server, record.path, options.read)
                      : acquire::open_measurement(record.path, options.read);
    add_runs(rows, record, std::move(opened), options);
    return rows;
  } catch (const UsageError& e) {
    return failed_record(kUsageError, e.what());
  } catch (const MachineFault&) {
    throw;
  } catch (const BudgetSpent& e) {
    // Concurrent analyses share the memory, so this record need not be the cause.
    if (e.resource() == Resource::memory) throw MachineFault("not enough memory", record.path, e.remedy());
    return failed_record(kImpossible, options.write_option != nullptr ? e.written(options.write_option) : e.what());
  } catch (const InputError& e) {
    return failed_record(kBadInput, options.write_option != nullptr ? e.written(options.write_option) : e.what());
  } catch (const std::bad_alloc&) {
    throw MachineFault("not enough memory", record.path, "analyse fewer records at a time");
  } catch (const std::system_error& e) {
    if (is_machine_fault(e.code().value())) throw MachineFault(e.what(), record.path, "close other programs");
    return failed_record(kInternalError, e.what());
  } catch (const std::exception& e) {
    return failed_record(kInternalError, e.what());
  }
}

Json record_row(const BatchRecord& record, const RowContents& rows) {
  Json row = row_start("record", record);
  row["bytes"] = record.bytes;
  row["code"] = rows.code;
  row["reason"] = rows.code == 0 ? Json() : Json(rows.reason);
  row["fs_hz"] = rows.fs_Hz;
  row["band_low_hz"] = rows.band_Hz[0];
  row["band_high_hz"] = rows.band_Hz[1];
  row["hits_accepted"] = rows.accepted;
  row["hits_rejected"] = rows.rejected;
  row["modes"] = rows.modes.size();
  row["findings"] = Json::array();
  for (const acquire::FindingCode code : rows.findings) row["findings"].push_back(name_of(code));
  if (rows.short_hit) row["findings"].push_back("short_hit");
  row["warnings"] = rows.warnings;
  return row;
}

}  // namespace

RecordRows rows_of(const BatchRecord& record, const RowOptions& options) {
  const RowContents contents = row_contents_of(record, options);
  RecordRows out{
      .lines = {line_of(record_row(record, contents))}, .failed = contents.code != 0, .reason = contents.reason};
  for (const auto* kind : {&contents.modes, &contents.frfs}) {
    for (const Json& row : *kind) out.lines.push_back(line_of(row));
  }
  return out;
}

bool file_came_back(const BatchRecord& record, std::string_view record_row) {
  const auto row = nlohmann::json::parse(record_row, nullptr, false);
  if (!row.is_object() || row.value("code", 0) != kBadInput || !row.contains("reason") || !row["reason"].is_string() ||
      row["reason"].get_ref<const std::string&>().find(kPlanned) == std::string::npos)
    return false;
  try {
    require_unchanged(record);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace percuss::batch
