#include "batch/run_shard.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "batch/journal.hpp"
#include "batch/merge.hpp"
#include "batch/part_file.hpp"
#include "batch/status.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch::run_shard_test {

namespace fs = std::filesystem;
using test::bytes_of;
using test::input_error_of;
using test::write_bytes;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Lowers the limit of descriptors, so that this process can open no further file.
class DescriptorLimit {
 public:
  DescriptorLimit() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const int next = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::close(next);
    const rlimit few{.rlim_cur = static_cast<rlim_t>(next), .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &few);
  }
  ~DescriptorLimit() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  DescriptorLimit(const DescriptorLimit&) = delete;
  DescriptorLimit& operator=(const DescriptorLimit&) = delete;

 private:
  rlimit before_{};
};

/// A batch of text records, which are read in this process.
class RunShard : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(out_);
    options_.analysis.threads = 1;
    options_.analysis.modes.effort = identify::Effort::quick;
  }
  void plan(std::size_t count) {
    std::vector<BatchRecord> records;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string path = folder_.file("r" + std::to_string(i) + ".csv");
      test::write_small_test(path, R"("hits": 1, "seed": )" + std::to_string(i + 1));
      records.push_back({.id = "r" + std::to_string(i), .path = path, .bytes = fs::file_size(path)});
    }
    write_manifest(folder_.file("m.jsonl"), {.version = report::version()}, records, false);
    manifest_.emplace(folder_.file("m.jsonl"));
  }
  ShardJob job(std::size_t shard = 0, std::size_t shards = 1) const {
    return {.manifest = &*manifest_,
            .shard = shard,
            .shards = shards,
            .folder = out_,
            .options = options_,
            .threads = 1,
            .waits = {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(out_), fs::directory_iterator()));
  }
  test::ScratchFolder folder_;
  std::string out_ = folder_.file("out");
  RowOptions options_;
  std::optional<Manifest> manifest_;
};

TEST_F(RunShard, WithoutDescriptorsLeavesRecordsForTheNextRun) {
  plan(3);
  std::optional<DescriptorLimit> limit;
  ShardJob three = job();
  three.advance = [&] { limit.emplace(); };  // after the first record
  const ShardOutcome outcome = run_shard(three);
  limit.reset();
  ASSERT_THAT(outcome.open, SizeIs(2));
  EXPECT_EQ(outcome.open[0].index, 1U);
  EXPECT_THAT(outcome.open[0].reason, HasSubstr("Too many open files"));
  EXPECT_EQ(outcome.analysed, 1U);
  EXPECT_FALSE(fs::exists(out_ + "/part-0.ok"));
  const BatchStatus status = batch_status(*manifest_, out_);
  EXPECT_EQ(status.finished, 1U);
  EXPECT_THAT(status.missing, testing::ElementsAre(0U));
  EXPECT_THAT(status.open, SizeIs(2));
  EXPECT_THAT(status.stuck, IsEmpty());
  const ShardOutcome later = run_shard(job());
  EXPECT_THAT(later.open, IsEmpty());
  EXPECT_EQ(later.analysed, 2U);
  EXPECT_EQ(later.part.records, 3U);
  EXPECT_EQ(later.part.failed, 0U);
  EXPECT_THAT(batch_status(*manifest_, out_).open, IsEmpty());
}

TEST_F(RunShard, TriesARecordAgainAfterAPassingFault) {
  plan(2);
  ShardJob two = job();
  two.waits = {std::chrono::milliseconds(1), std::chrono::milliseconds(500), std::chrono::seconds(20)};
  std::optional<DescriptorLimit> limit;
  std::thread relief;
  two.advance = [&] {
    if (relief.joinable()) return;
    limit.emplace();
    relief = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      limit.reset();
    });
  };
  const ShardOutcome outcome = run_shard(two);
  relief.join();
  EXPECT_THAT(outcome.open, IsEmpty());
  EXPECT_EQ(outcome.part.failed, 0U);
  EXPECT_EQ(outcome.part.records, 2U);
}

TEST_F(RunShard, WaitsForALastingFaultOnce) {
  plan(7);
  ShardJob seven = job();
  seven.waits = {std::chrono::milliseconds(400)};
  std::optional<DescriptorLimit> limit;
  std::chrono::steady_clock::time_point start;
  seven.advance = [&] {
    limit.emplace();
    start = std::chrono::steady_clock::now();
  };
  const ShardOutcome outcome = run_shard(seven);
  const auto took = std::chrono::steady_clock::now() - start;
  limit.reset();
  EXPECT_THAT(outcome.open, SizeIs(6));
  EXPECT_GE(took, std::chrono::milliseconds(400));
  EXPECT_LT(took, std::chrono::milliseconds(2000));
}

TEST_F(RunShard, WritesNoFilesForShardsWithoutRecords) {
  plan(3);
  constexpr std::size_t kShards = 100'000;
  std::size_t records = 0;
  for (std::size_t i = 0; i < kShards; ++i) {
    if (manifest_->shard(i, kShards).size() > 0 || i % 1000 == 0) records += run_shard(job(i, kShards)).part.records;
  }
  EXPECT_EQ(records, 3U);
  EXPECT_EQ(files(), 6U);
  const BatchStatus status = batch_status(*manifest_, out_);
  EXPECT_EQ(status.shards, kShards);
  EXPECT_THAT(status.missing, IsEmpty());
  EXPECT_THAT(status_text(status), HasSubstr("3 of 3 records finished, in 3 of 3 shards"));
  EXPECT_EQ(merge_batch(*manifest_, out_, {folder_.file("r.jsonl")}).records, 3U);
}

TEST_F(RunShard, RefusesLinksInPlaceOfParts) {
  plan(1);
  const std::string victim = folder_.file("victim");
  for (const char* kind : {"partial", "jsonl", "ok"}) {
    write_bytes(victim, "kept");
    const std::string path = part_path(out_, 0, kind);
    fs::create_symlink(victim, path);
    for (const bool force : {false, true}) {
      ShardJob one = job();
      one.force = force;
      EXPECT_THAT(input_error_of([&] { run_shard(one); }), testing::AllOf(HasSubstr("symbolic link"), HasSubstr(path)));
    }
    EXPECT_EQ(bytes_of(victim), "kept");
    EXPECT_TRUE(fs::is_symlink(path));
    fs::remove(path);
  }
}

TEST_F(RunShard, RefusesFilesOfOthersInPlaceOfParts) {
  plan(1);
  for (const char* kind : {"partial", "jsonl", "ok"}) {
    const std::string path = part_path(out_, 0, kind);
    for (const std::string text : {"a letter", "a letter\n", R"({"schema":"other"})"}) {
      write_bytes(path, text);
      for (const bool force : {false, true}) {
        ShardJob one = job();
        one.force = force;
        EXPECT_THAT(input_error_of([&] { run_shard(one); }), HasSubstr(path)) << text << force;
      }
      EXPECT_EQ(bytes_of(path), text);
    }
    fs::remove(path);
    fs::create_directory(path);
    EXPECT_THAT(input_error_of([&] { run_shard(job()); }), HasSubstr(path));
    fs::remove(path);
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_THAT(input_error_of([&] { run_shard(job()); }), HasSubstr(path));
    fs::remove(path);
  }
  EXPECT_EQ(run_shard(job()).part.records, 1U);
}

TEST_F(RunShard, LeavesNoTemporaryFilesOfKilledProcesses) {
  for (const char* name : {".part-0.jsonl.percuss-99999999", ".part-7.ok.percuss-99999999-2", ".part-notes", ".x"})
    write_bytes(out_ + "/" + name, "");
  remove_abandoned_parts(out_);
  EXPECT_EQ(files(), 2U);
}

TEST_F(RunShard, RemovesTheJournalThatAKillAtTheEndLeaves) {
  plan(1);
  write_bytes(part_path(out_, 0, "partial"), "");
  const ShardOutcome outcome = run_shard(job());
  ASSERT_EQ(outcome.part.records, 1U);
  write_bytes(part_path(out_, 0, "partial"), label_line(outcome.part.label) + "\nbegun 0\n");
  EXPECT_EQ(run_shard(job()).analysed, 0U);
  EXPECT_EQ(files(), 2U);
}

// A mount that is absent, for example. The rows are those of a run that had all files.
TEST_F(RunShard, AnalysesRecordsWhoseFilesCameBack) {
  plan(3);
  run_shard(job());
  const std::string rows = bytes_of(part_path(out_, 0, "jsonl"));
  fs::remove_all(out_);
  fs::create_directory(out_);
  const std::string path = folder_.file("r1.csv"), away = folder_.file("away.csv"), whole = bytes_of(path);
  fs::rename(path, away);
  const ShardOutcome lost = run_shard(job());
  ASSERT_THAT(lost.failed, SizeIs(1));
  EXPECT_EQ(lost.failed[0].index, 1U);
  EXPECT_THAT(lost.failed[0].reason, HasSubstr("the file is missing; it existed when the batch was planned"));
  EXPECT_EQ(lost.part.failed, 1U);
  EXPECT_EQ(run_shard(job()).analysed, 0U) << "still missing";
  write_bytes(path, whole + "\n");
  EXPECT_EQ(run_shard(job()).analysed, 0U) << "not as planned";
  write_bytes(path, whole);
  const ShardOutcome back = run_shard(job());
  EXPECT_EQ(back.analysed, 1U);
  EXPECT_THAT(back.failed, IsEmpty());
  EXPECT_EQ(back.part.records, 3U);
  EXPECT_EQ(back.part.failed, 0U);
  EXPECT_EQ(bytes_of(part_path(out_, 0, "jsonl")), rows);
  EXPECT_EQ(files(), 2U);
  EXPECT_EQ(run_shard(job()).analysed, 0U);
  EXPECT_EQ(merge_batch(*manifest_, out_, {folder_.file("r.jsonl")}).records, 3U);
}

// A run that was killed after the record had failed.
TEST_F(RunShard, AnalysesRecordsOfAnUnfinishedShardWhoseFilesCameBack) {
  plan(3);
  const std::string path = folder_.file("r1.csv"), away = folder_.file("away.csv");
  fs::rename(path, away);
  const RecordRows failed = rows_of(manifest_->record(1), options_);
  ASSERT_TRUE(failed.failed);
  Journal(part_path(out_, 0, "partial"), label_of(*manifest_, 0, 1), manifest_->shard(0, 1), false)
      .finish(1, true, failed.lines);
  EXPECT_EQ(batch_status(*manifest_, out_).finished, 1U);
  fs::rename(away, path);
  const ShardOutcome outcome = run_shard(job());
  EXPECT_EQ(outcome.analysed, 3U);
  EXPECT_EQ(outcome.part.records, 3U);
  EXPECT_EQ(outcome.part.failed, 0U);
}

// Their files are as planned: they would fail again.
TEST_F(RunShard, LeavesOtherFailedRecords) {
  plan(1);
  write_bytes(folder_.file("bad.csv"), "no,record\n");
  write_manifest(folder_.file("m.jsonl"), {.version = report::version()},
                 {{.id = "bad", .path = folder_.file("bad.csv"), .bytes = fs::file_size(folder_.file("bad.csv"))}},
                 true);
  manifest_.emplace(folder_.file("m.jsonl"));
  EXPECT_EQ(run_shard(job()).part.failed, 1U);
  const ShardOutcome again = run_shard(job());
  EXPECT_EQ(again.analysed, 0U);
  EXPECT_EQ(again.part.failed, 1U);
}

}  // namespace percuss::batch::run_shard_test
