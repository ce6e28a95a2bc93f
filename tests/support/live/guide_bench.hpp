#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/live/guide.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/json/analysis_json.hpp"
#include "support/live/live_source.hpp"
#include "support/record_samples.hpp"

namespace percuss::test {

/// Records the calls that a Guide makes to its observer.
struct GuideRecorder : pipeline::GuideObserver {
  std::vector<pipeline::BlowReport> blows;
  std::vector<acquire::CaptureFinding> faults;
  std::vector<std::string> order;  // of the calls: "blow 1", "gap"
  std::size_t left_out = 0, goals = 0, silent_hammers = 0;
  std::vector<std::size_t> undone;  // by each command
  std::vector<pipeline::LongPush> long_pushes;
  void on_blow(const pipeline::BlowReport& blow) override {
    blows.push_back(blow);
    order.push_back("blow " + std::to_string(blow.row + 1));
  }
  void on_command(const pipeline::SessionEvent& /*command*/, std::size_t count) override { undone.push_back(count); }
  void on_silent_hammer() override { ++silent_hammers; }
  void on_long_push(const pipeline::LongPush& push) override { long_pushes.push_back(push); }
  void on_fault(const acquire::CaptureFinding& fault) override {
    faults.push_back(fault);
    order.emplace_back(acquire::fault_name(fault.fault));
  }
  void on_left_out(std::uint64_t /*frame*/, bool /*too_early*/) override { ++left_out; }
  void on_goals_met() override { ++goals; }
};

/// A guide that gets a record as a stream.
struct GuideBench {
  LiveSource source;
  MemoryLog log;
  GuideRecorder witness;
  std::unique_ptr<pipeline::Guide> guide;

  explicit GuideBench(const acquire::Record& record, pipeline::GuideOptions options = {},
                      const acquire::ReadOptions& read = {})
      : source(record) {
    options.folder = testing::TempDir();
    guide = std::make_unique<pipeline::Guide>(source.format, pipeline::live_channels(source.format, read),
                                              std::move(options), log, witness);
  }
  void play(std::size_t first, std::size_t last, std::size_t block = 400) const {
    for (std::size_t at = first; at < last; at += block) guide->take(source.block(at, std::min(block, last - at)));
  }
  void play_all(std::size_t block = 400) const {
    play(0, source.frames(), block);
    guide->finish();
  }
  std::vector<acquire::RowMark> marks() const {
    std::vector<acquire::RowMark> out;
    for (const auto& blow : guide->session().blows()) out.push_back(blow.mark);
    return out;
  }
};

/// The document of an analysis of the record.
inline std::string analysis_document(acquire::Record record) {
  std::vector<acquire::Record> records;
  records.push_back(std::move(record));
  const auto runs = pipeline::analyses_of_runs(std::move(records), {});
  return report::analysis_json(*runs.front().analysis);
}

/// The force of each row in N, [rows][samples].
inline std::vector<std::vector<double>> force_rows(const acquire::Record& record) {
  std::vector<std::vector<double>> rows;
  for (std::size_t row = 0; row < record.rows.size(); ++row) rows.push_back(force_N(record, row));
  return rows;
}

}  // namespace percuss::test
