#include "batch/status.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "batch/journal.hpp"
#include "batch/part.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::batch {
namespace {

using Json = nlohmann::ordered_json;

void add_unfinished(BatchStatus& status, const Manifest& manifest, const std::string& path) {
  const JournalState state = journal_state(path);
  status.finished += state.finished;
  for (const std::size_t index : state.stuck) {
    if (index < manifest.size()) status.stuck.push_back(manifest.record(index).id);
  }
  for (const auto& [index, reason] : state.open) {
    if (index < manifest.size()) status.open.emplace(manifest.record(index).id, reason);
  }
}

}  // namespace

BatchStatus batch_status(const Manifest& manifest, const std::string& folder) {
  BatchStatus status{.records = manifest.size(), .bytes = manifest.bytes()};
  status.shards = shard_count_in(folder).value_or(manifest.head().shards);
  for (std::size_t i = 0; i < status.shards; ++i) {
    if (manifest.shard(i, status.shards).size() == 0) {
      ++status.empty;
    } else if (const auto part = finished_part(folder, i)) {
      ShardLabel wanted = label_of(manifest, i, status.shards);
      wanted.version = part->label.version;  // merging checks that all versions agree
      require_same_shard(part->label, wanted, part_path(folder, i, "ok"));
      status.finished += part->records;
      status.failed += part->failed;
    } else {
      status.missing.push_back(i);
      add_unfinished(status, manifest, part_path(folder, i, "partial"));
    }
  }
  return status;
}

std::string array_list(const std::vector<std::size_t>& shards) { return fmt::format("{}", fmt::join(shards, ",")); }

std::string status_json(const BatchStatus& status) {
  auto open = Json::array();
  for (const auto& [id, reason] : status.open) open.push_back({{"id", id}, {"reason", reason}});
  const Json json{{"schema", "percuss/batch-status/1"},
                  {"version", report::version()},
                  {"shards", status.shards},
                  {"missing", status.missing},
                  {"records", status.records},
                  {"bytes", status.bytes},
                  {"finished", status.finished},
                  {"failed", status.failed},
                  {"stuck", status.stuck},
                  {"open", open}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string status_text(const BatchStatus& status) {
  const std::size_t shards = status.shards - status.empty, done = shards - status.missing.size();
  std::string text = fmt::format("{} of {} records finished, in {} of {} {}", status.finished, status.records, done,
                                 shards, shards == 1 ? "shard" : "shards");
  text += status.failed > 0 ? fmt::format("; {} failed\n", status.failed) : "\n";
  if (!status.missing.empty()) text += "missing shards: " + array_list(status.missing) + "\n";
  if (!status.open.empty()) text += fmt::format("left open by a fault of the machine: {}\n", status.open.size());
  std::size_t named = 0;
  for (const auto& [id, reason] : status.open) {
    if (named++ < kMaxNamed) text += fmt::format("  {}: {}\n", one_line(id), one_line(reason, kMaxReason_bytes));
  }
  for (std::size_t i = 0; i < std::min(status.stuck.size(), kMaxNamed); ++i)
    text += fmt::format("begun more than once, never finished: {}\n", one_line(status.stuck[i]));
  if (status.stuck.size() > kMaxNamed) text += fmt::format("... and {} more\n", status.stuck.size() - kMaxNamed);
  return text;
}

}  // namespace percuss::batch
