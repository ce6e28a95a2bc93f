#include "batch/run_shard.hpp"

#include <filesystem>
#include <vector>

#include "batch/journal.hpp"
#include "batch/sha256_file.hpp"
#include "core/io/atomic_file.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::batch {
namespace {

FinishedShard write_finished_shard(const ShardJob& job, const ShardLabel& label, ShardRange range,
                                   const Journal& journal) {
  FinishedShard part{.label = label, .records = journal.finished(), .failed = journal.failed()};
  Sha256File file(part_path(job.folder, job.shard, "jsonl"), true);
  file.add(label_line(label) + "\n");
  for (std::size_t i = range.first; i < range.last; ++i) file.add(journal.rows(i));
  file.commit();
  part.bytes = file.bytes();
  part.sha256 = file.sha256();
  write_file(part_path(job.folder, job.shard, "ok"), finished_line(part) + "\n", true);
  return part;
}

std::optional<FinishedShard> finished_shard_before(const ShardJob& job, const ShardLabel& label) {
  if (job.force) return std::nullopt;
  auto part = finished_part(job.folder, job.shard);
  if (!part) return std::nullopt;
  require_same_shard(part->label, label, part_path(job.folder, job.shard, "ok"));
  std::error_code absent;
  const auto bytes = std::filesystem::file_size(part_path(job.folder, job.shard, "jsonl"), absent);
  return absent || bytes != part->bytes ? std::nullopt : part;
}

void analyse(const ShardJob& job, Journal& journal, const std::vector<std::size_t>& left) {
  parallel_for(left.size(), job.threads, [&](std::size_t i) {
    journal.begin(left[i]);
    const RecordRows rows = rows_of(job.manifest->record(left[i]), job.options);
    journal.finish(left[i], rows.failed, rows.lines);
    if (job.advance) job.advance();
  });
}

}  // namespace

ShardOutcome run_shard(const ShardJob& job) {
  const ShardLabel label = label_of(*job.manifest, job.shard, job.shards);
  const ShardRange range = job.manifest->shard(job.shard, job.shards);
  if (auto part = finished_shard_before(job, label)) return {.part = *part};
  Journal journal(part_path(job.folder, job.shard, "partial"), label, range, job.force);
  // The process that held the journal until now may have finished the shard.
  if (auto part = finished_shard_before(job, label)) {
    journal.remove();
    return {.part = *part};
  }
  std::vector<std::size_t> left;
  for (std::size_t i = range.first; i < range.last; ++i) {
    if (!journal.has(i)) left.push_back(i);
  }
  analyse(job, journal, left);
  ShardOutcome outcome{.part = write_finished_shard(job, label, range, journal), .analysed = left.size()};
  journal.remove();
  return outcome;
}

}  // namespace percuss::batch
