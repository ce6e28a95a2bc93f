#include <unistd.h>

#include <cstdlib>

#include "batch/journal.hpp"
#include "batch/manifest.hpp"
#include "batch/part.hpp"
#include "batch/plan.hpp"
#include "batch/row_writer.hpp"
#include "batch/serialized_frf.hpp"
#include "metrics/study/study_batch.hpp"
#include "targets.hpp"

namespace percuss::fuzz {
namespace {

// Checks that all shards together cover each record once, for several numbers of shards. Reads each record.
void read_manifest(const std::string& path) {
  const batch::Manifest manifest(path);
  for (const std::size_t shards : {std::size_t{1}, std::size_t{3}, manifest.head().shards}) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < shards; ++i) {
      const batch::ShardRange range = manifest.shard(i, shards);
      if (range.first != next || range.end < range.first) std::abort();
      next = range.end;
    }
    if (next != manifest.size()) std::abort();
  }
  for (std::size_t i = 0; i < manifest.size(); ++i) manifest.record(i);
}

// Adds the lines of a part to the files that `batch merge` writes; without commit() they leave no file.
void merge_rows(std::string_view bytes) {
  const batch::BatchTotals totals{.version = "0", .head = {.frf = true}};
  const std::string path = "/tmp/percuss-fuzz-" + std::to_string(::getpid());
  for (const std::string kind : {".csv", ".h5"}) {
    if (kind == ".h5" && bytes.find(batch::kFrfRow) == std::string_view::npos) continue;
    const auto writer = batch::row_writer(path + kind, totals, true);
    for (const std::string& row : batch::parse_path_list(bytes)) accepted([&] { writer->add(row, "fuzzed"); });
  }
}

}  // namespace

void run_batch(std::string_view bytes) {
  const MemfdFile file(bytes);
  accepted([&] { read_manifest(file.path()); });
  accepted([&] { batch::parse_finished(bytes, "fuzzed"); });
  accepted([&] { batch::journal_state(file.path()); });
  accepted([&] { batch::deserialize_frfs(bytes.substr(0, bytes.find('\n')), "fuzzed"); });
  if (metrics::holds_batch(bytes)) accepted([&] { metrics::batch_bats(bytes, "fuzzed"); });
  if (bytes.starts_with(R"({"row":)")) accepted([&] { merge_rows(bytes); });
}

}  // namespace percuss::fuzz
