#include "batch/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "batch/line_reader.hpp"
#include "batch/part.hpp"
#include "batch/part_file.hpp"
#include "batch/row_writer.hpp"
#include "batch/status.hpp"
#include "core/error.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {
namespace {

constexpr std::size_t kLongestRow_bytes = std::size_t{1} << 30U;

[[noreturn]] void refuse_changed(const std::string& path) {
  throw InputError("the part changed after it was finished", path, "run its shard again", {"batch.run.force"});
}

// The completion markers of all shards, checked against the manifest and against each other.
std::vector<FinishedShard> finished_parts(const Manifest& manifest, const std::string& folder) {
  const std::size_t shards = shard_count_in(folder).value_or(manifest.head().shards);
  std::vector<FinishedShard> parts;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < shards; ++i) {
    if (manifest.shard(i, shards).size() == 0) continue;
    const auto part = finished_part(folder, i);
    if (!part) {
      missing.push_back(i);
      continue;
    }
    ShardLabel wanted = label_of(manifest, i, shards);
    wanted.version = (parts.empty() ? *part : parts.front()).label.version;
    require_same_shard(part->label, wanted, part_path(folder, i, "ok"));
    parts.push_back(*part);
  }
  if (missing.empty()) return parts;
  throw InputError(
      fmt::format("{} of {} shards are not finished: {}", missing.size(), shards, one_line(array_list(missing), 80)),
      folder, "run these shards");
}

void add_if_failed(std::vector<FailedRecord>& failed, std::string_view record_row) {
  if (failed.size() == kMaxNamed) return;
  const auto row = nlohmann::json::parse(record_row, nullptr, false);
  if (row.is_discarded() || !row.contains("reason") || !row["reason"].is_string()) return;
  failed.push_back({.id = row.value("id", ""), .reason = row["reason"]});
}

// Returns the first failed records of the part.
std::vector<FailedRecord> copy_rows(const std::string& folder, const FinishedShard& part,
                                    const std::vector<std::unique_ptr<RowWriter>>& writers) {
  const std::string path = part_path(folder, part.label.shard, "jsonl");
  const PartFile file = PartFile::existing(path);
  if (!file.present()) refuse_changed(path);
  LineReader lines(file.descriptor(), path, kLongestRow_bytes);
  report::Digest digest;
  std::size_t records = 0;
  std::vector<FailedRecord> failed;
  while (lines.next()) {
    digest.add(lines.line());
    digest.add("\n");
    if (lines.number() == 1) {
      if (lines.line() != label_line(part.label)) refuse_changed(path);
      continue;
    }
    if (lines.line().starts_with(kRecordRow)) {
      ++records;
      if (part.failed > 0) add_if_failed(failed, lines.line());
    }
    for (const auto& writer : writers) writer->add(lines.line(), fmt::format("{}, line {}", path, lines.number()));
  }
  if (records != part.records || report::hexadecimal(digest.result()) != part.sha256) refuse_changed(path);
  return failed;
}

}  // namespace

MergedBatch merge_batch(const Manifest& manifest, const std::string& folder, const std::vector<std::string>& paths,
                        const MergeOptions& options) {
  const auto parts = finished_parts(manifest, folder);
  MergedBatch merged;
  for (const FinishedShard& part : parts) {
    merged.records += part.records;
    merged.failed += part.failed;
  }
  const BatchTotals totals{.version = parts.empty() ? manifest.head().version : parts.front().label.version,
                           .head = manifest.head(),
                           .records = merged.records,
                           .failed = merged.failed};
  std::vector<std::unique_ptr<RowWriter>> writers;
  writers.reserve(paths.size());
  for (const std::string& path : paths) writers.push_back(row_writer(path, totals, options.force, options.formulas));
  for (const FinishedShard& part : parts) {
    for (FailedRecord& record : copy_rows(folder, part, writers)) {
      if (merged.first_failed.size() < kMaxNamed) merged.first_failed.push_back(std::move(record));
    }
  }
  for (const auto& writer : writers) writer->commit();
  return merged;
}

}  // namespace percuss::batch
