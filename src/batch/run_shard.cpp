#include "batch/run_shard.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "batch/journal.hpp"
#include "batch/line_reader.hpp"
#include "batch/part_file.hpp"
#include "batch/retries.hpp"
#include "batch/row_writer.hpp"
#include "batch/sha256_file.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::batch {
namespace {

// Throws InputError if a file exists that no batch wrote.
void require_replaceable(const std::string& path) {
  const PartFile file = PartFile::existing(path);
  if (file.present()) file.require_own();
}

FinishedShard write_finished_shard(const ShardJob& job, const ShardLabel& label, ShardRange range,
                                   const Journal& journal) {
  FinishedShard part{.label = label, .records = journal.finished(), .failed = journal.failed()};
  const auto refused = AtomicFile::Links::refused;
  Sha256File file(part_path(job.folder, job.shard, "jsonl"), true, refused);
  file.add(label_line(label) + "\n");
  for (std::size_t i = range.first; i < range.end; ++i) file.add(journal.rows(i));
  file.commit();
  part.bytes = file.bytes();
  part.sha256 = file.sha256();
  AtomicFile mark(part_path(job.folder, job.shard, "ok"), true, AtomicFile::Temporary::unnamed_if_possible, refused);
  mark.write(finished_line(part) + "\n");
  mark.commit();
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

constexpr std::size_t kLongestRowOfPart_bytes = std::size_t{1} << 30U;

// Calls use(index, rows) for each record of a finished part, in order. Precondition: `part` holds as many records as
// the range.
void for_each_record(const std::string& path, ShardRange range,
                     const std::function<void(std::size_t, const std::vector<std::string>&)>& use) {
  const PartFile file = PartFile::existing(path);
  LineReader lines(file.descriptor(), path, kLongestRowOfPart_bytes);
  std::size_t index = range.first;
  std::vector<std::string> rows;
  const auto end_record = [&] {
    if (!rows.empty()) use(index++, rows);
    rows.clear();
  };
  while (lines.next()) {
    if (lines.number() == 1) continue;  // the label
    if (lines.line().starts_with(kRecordRow)) end_record();
    rows.emplace_back(lines.line());
  }
  end_record();
}

bool is_failed_row(std::string_view record_row) {
  const auto row = nlohmann::json::parse(record_row, nullptr, false);
  return row.is_object() && row.value("code", 0) != 0;
}

// The records of a finished shard that failed because their file was lost or changed, and whose file is back.
std::set<std::size_t> records_that_came_back(const ShardJob& job, const FinishedShard& part, ShardRange range) {
  std::set<std::size_t> back;
  if (part.failed == 0 || part.records != range.size()) return back;
  for_each_record(part_path(job.folder, job.shard, "jsonl"), range, [&](std::size_t i, const auto& rows) {
    if (i < range.end && file_came_back(job.manifest->record(i), rows.front())) back.insert(i);
  });
  return back;
}

// Moves the other records of a finished shard to the journal. From then on the shard counts as unfinished.
void reopen_shard(const ShardJob& job, ShardRange range, const std::set<std::size_t>& back, Journal& journal) {
  for_each_record(part_path(job.folder, job.shard, "jsonl"), range, [&](std::size_t i, const auto& rows) {
    if (i < range.end && !back.contains(i) && !journal.has(i)) journal.finish(i, is_failed_row(rows.front()), rows);
  });
  const std::string mark = part_path(job.folder, job.shard, "ok");
  std::error_code problem;
  std::filesystem::remove(mark, problem);
  if (problem) throw_system_error("cannot remove", problem.value(), mark, "choose another folder");
}

// Opens the records of an unfinished shard again that failed because their file was lost or changed, and whose file is
// back.
void reopen_records(const ShardJob& job, ShardRange range, Journal& journal) {
  for (std::size_t i = range.first; i < range.end; ++i) {
    if (!journal.has(i) || !journal.failed(i)) continue;
    const std::string rows = journal.rows(i);
    if (file_came_back(job.manifest->record(i), std::string_view(rows).substr(0, rows.find('\n')))) journal.reopen(i);
  }
}

struct ProblemsOfRun {
  std::vector<RecordProblem> failed, open;
};

ProblemsOfRun analyse(const ShardJob& job, Journal& journal, const std::vector<std::size_t>& left) {
  Retries retries(job.waits);
  std::mutex one_at_a_time;
  ProblemsOfRun problems;
  const auto note = [&](std::vector<RecordProblem>& list, std::size_t index, const std::string& reason) {
    const std::scoped_lock lock(one_at_a_time);
    list.push_back({.index = index, .reason = reason});
  };
  const auto leave_open = [&](std::size_t index, const std::string& reason) {
    journal.leave_open(index, reason);
    note(problems.open, index, reason);
  };
  parallel_for(left.size(), job.threads, [&](std::size_t i) {
    try {
      RecordRows rows;
      retries.run([&] { journal.begin(left[i]); });
      retries.run([&] { rows = rows_of(job.manifest->record(left[i]), job.options); });
      retries.run([&] { journal.finish(left[i], rows.failed, rows.lines); });
      if (rows.failed) note(problems.failed, left[i], rows.reason);
      retries.end_of_fault();
      if (job.advance) job.advance();
    } catch (const MachineFault& fault) {
      leave_open(left[i], job.options.write_option != nullptr ? fault.written(job.options.write_option) : fault.what());
    } catch (const std::bad_alloc&) {
      leave_open(left[i], kOutOfMemoryMessage);
    }
  });
  for (auto* list : {&problems.failed, &problems.open})
    std::sort(list->begin(), list->end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  return problems;
}

}  // namespace

ShardOutcome run_shard(const ShardJob& job) {
  const ShardLabel label = label_of(*job.manifest, job.shard, job.shards);
  const ShardRange range = job.manifest->shard(job.shard, job.shards);
  if (range.size() == 0) return {.part = {.label = label}};
  const std::string journal_path = part_path(job.folder, job.shard, "partial");
  for (const char* kind : {"jsonl", "ok"}) require_replaceable(part_path(job.folder, job.shard, kind));
  const auto finished_before = finished_shard_before(job, label);
  if (finished_before && records_that_came_back(job, *finished_before, range).empty()) {
    remove_abandoned_journal(journal_path);
    return {.part = *finished_before};
  }
  Journal journal(journal_path, label, range, job.force);
  // The process that held the journal until now may have finished the shard.
  if (auto part = finished_shard_before(job, label)) {
    const std::set<std::size_t> back = records_that_came_back(job, *part, range);
    if (back.empty()) {
      journal.remove();
      return {.part = *part};
    }
    reopen_shard(job, range, back, journal);
  }
  reopen_records(job, range, journal);
  std::vector<std::size_t> left;
  for (std::size_t i = range.first; i < range.end; ++i) {
    if (!journal.has(i)) left.push_back(i);
  }
  ProblemsOfRun problems = analyse(job, journal, left);
  ShardOutcome outcome{.failed = std::move(problems.failed), .open = std::move(problems.open)};
  outcome.analysed = left.size() - outcome.open.size();
  outcome.part = {.label = label, .records = journal.finished(), .failed = journal.failed()};
  if (!outcome.open.empty()) return outcome;
  Retries(job.waits).run([&] { outcome.part = write_finished_shard(job, label, range, journal); });
  journal.remove();
  return outcome;
}

}  // namespace percuss::batch
