#include "commands/survey_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/files_of_hits.hpp"
#include "cli/option_error.hpp"
#include "cli/shell_argument.hpp"
#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "pipeline/warnings/point_names.hpp"

namespace percuss::tools {
namespace {

using acquire::FilesOfHits;
using Records = std::vector<acquire::Record>;

std::vector<std::string> paths_of(const Records& records) {
  std::vector<std::string> paths;
  for (const acquire::Record& record : records) paths.push_back(record.source());
  return paths;
}

// "P1_1.csv, P1_2.csv, P1_3.csv"
std::string names_of_group(const Records& records, const FilesOfHits& group) {
  constexpr std::size_t kMaxNamed = 4;
  return limited_list(group.files.size(), kMaxNamed,
                      [&](std::size_t i) { return pipeline::short_file_name(records[group.files[i]].source()); });
}

// Whether most hits agree with the other hits of their point. Hits at different places do not: they leave much of each
// other's responses unexplained.
bool hits_agree(const pipeline::Analysis& analysis) {
  std::size_t compared = 0, odd = 0;
  for (const pipeline::AnalysedHit& hit : analysis.hits()) {
    const bool differs = std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(), [](const auto& finding) {
      return finding.code == acquire::FindingCode::low_coherence || finding.code == acquire::FindingCode::outlier;
    });
    compared += hit.accepted || differs ? 1 : 0;
    odd += differs ? 1 : 0;
  }
  return 2 * odd < compared;
}

// The warning files_as_points: each file was taken as a point. The remedy names the command that joins the hits of each
// point.
pipeline::Warning taken_as_points(const Records& records, const FilesOfHits& group) {
  std::string files;
  for (const std::size_t file : group.files) files += shell_quoted_argument(records[file].source()) + " ";
  const std::string joined = shell_quoted_argument(group.stem + ".h5");
  return pipeline::with_remedy(
      {"files_as_points",
       fmt::format("each of the {} files is taken as a point: by their names, {} could be hits of one point, but their "
                   "responses differ",
                   records.size(), names_of_group(records, group))},
      one_line(fmt::format("if they are, join the hits of each point first, percuss convert {}--files hits -o {} and "
                           "so on, and give the joined files",
                           files, joined),
               std::string::npos));
}

// Whether each record is a file that states no points of its own.
bool state_no_points(const Records& records) {
  return std::all_of(records.begin(), records.end(), [](const acquire::Record& record) {
    return record.files.size() == 1 && record.geometry.empty() && record.driving.empty() && record.motions.empty() &&
           std::all_of(record.rows.begin(), record.rows.end(), [](const auto& row) { return row.point == 0; });
  });
}

std::vector<std::string> first_paths(const Records& records) {
  std::vector<std::string> paths;
  for (const acquire::Record& record : records) paths.push_back(record.files.front().path);
  return paths;
}

void require_one_run(const acquire::Record& record) {
  for (const acquire::RowInfo& row : record.rows) {
    if (row.run == record.rows.front().run) continue;
    throw InputError("several runs", record.files.empty() ? record.source() : record.files[row.file].path,
                     "a survey is one test; put each run into a file of its own");
  }
}

std::unique_ptr<pipeline::Analysis> analysis_of_record(acquire::Record record, pipeline::AnalysisOptions options) {
  require_one_run(record);
  return std::make_unique<pipeline::Analysis>(std::move(record), std::move(options));
}

// The analysis of files whose names hold two numbers, if they are hits of several points. Nothing if the geometry does
// not allow it, or if it allows that each file is a point and the responses of the hits of a point differ.
std::unique_ptr<pipeline::Analysis> analysis_by_two_numbers(const Records& records,
                                                            const pipeline::AnalysisOptions& options) {
  const pipeline::TwoNumbers read =
      pipeline::judge_two_numbers(paths_of(records), groupings_of_files(records), options.geometry_points);
  for (const std::vector<FilesOfHits>& groups : read.groupings) {
    auto grouped = analysis_of_record(record_of_groups(records, groups), options);
    if (read.certain || (grouped->possible() && hits_agree(*grouped))) return grouped;
  }
  return nullptr;
}

}  // namespace

std::vector<FilesOfHits> groups_of_files(const Records& records) {
  return state_no_points(records) ? acquire::files_of_hits(first_paths(records)) : std::vector<FilesOfHits>{};
}

std::vector<std::vector<FilesOfHits>> groupings_of_files(const Records& records) {
  if (!state_no_points(records)) return {};
  return acquire::groupings_by_two_numbers(first_paths(records));
}

acquire::Record record_of_groups(Records records, const std::vector<FilesOfHits>& groups) {
  Message note =
      information(fmt::format("the {} files are hits of {} points, by their names: {} are hits of one point. "
                              "If each file is a point, say so",
                              records.size(), groups.size(), names_of_group(records, groups.front())));
  note.options = {"files"};
  for (std::size_t p = 0; p < groups.size(); ++p) {
    for (const std::size_t file : groups[p].files) {
      for (acquire::RowInfo& row : records[file].rows) row.point = static_cast<int>(p);
    }
  }
  acquire::Record joined = acquire::join_records(std::move(records), acquire::FileGrouping::hits);
  joined.notes.push_back(std::move(note));
  return joined;
}

std::unique_ptr<pipeline::Analysis> survey_analysis(const ReadFlags& read, const pipeline::AnalysisOptions& options) {
  if (read.files == acquire::FileGrouping::tests)
    throw OptionError::wrong_value("files", "tests", "give points or hits", "a survey is one test");
  Measurements opened = open_measurements(read);
  if (!opened.frfs.empty())
    return std::make_unique<pipeline::Analysis>(join_frfs_of(read, std::move(opened.frfs)), options);
  Records& records = opened.records;
  if (read.files != acquire::FileGrouping::automatic)
    return analysis_of_record(acquire::join_records(std::move(records), read.files), options);
  const std::vector<FilesOfHits> groups = groups_of_files(records);
  const pipeline::NamedFiles named = pipeline::judge_named_files(paths_of(records), groups, options.geometry_points);
  if (groups.empty()) {
    if (auto grouped = analysis_by_two_numbers(records, options)) return grouped;
  }
  pipeline::AnalysisOptions of_points = options;
  if (named != pipeline::NamedFiles::points) {
    auto grouped = analysis_of_record(record_of_groups(records, groups), options);
    if (named == pipeline::NamedFiles::hits || !grouped->possible() || hits_agree(*grouped)) return grouped;
    if (options.geometry_points.size() != records.size())
      of_points.known.push_back(taken_as_points(records, groups.front()));
  }
  return analysis_of_record(acquire::join_records(std::move(records), acquire::FileGrouping::points),
                            std::move(of_points));
}

}  // namespace percuss::tools
