#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/files/synthetic_files.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Allocations and writes fail: no memory, a full disk, short writes.
namespace percuss::faults_test {

namespace fs = std::filesystem;
using test::bytes_of;
using test::ProcessOutcome;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kCorpus = PERCUSS_SOURCE_DIR "/fuzz/corpus/";

// Earlier allocations load the libraries: their failure cannot be caught.
constexpr long kFirst = 100;

class Faults : public testing::Test {
 protected:
  ProcessOutcome run(const std::vector<std::string>& arguments, const std::string& fault, long number) const {
    return test::run_percuss(arguments, {.environment = {"LD_PRELOAD=" PERCUSS_FAULTS,
                                                         "PERCUSS_FAULT_" + fault + "=" + std::to_string(number)}});
  }
  void clear() const {
    for (const std::string& name : folder_.names()) fs::remove(folder_.file(name));
  }
  /// Runs the command again and again; the n-th allocation fails, with n = kFirst, kFirst + step, … Ends after ten
  /// successful runs in succession: n then exceeds the number of allocations.
  void expect_all_or_nothing(std::vector<std::string> arguments, const std::string& output, long step) const {
    const std::string path = folder_.file(output);
    if (!output.empty()) arguments.push_back(path);
    const ProcessOutcome good = run(arguments, "ALLOCATION", 0);
    ASSERT_EQ(good.code, 0) << good.err;
    const std::string whole = output.empty() ? "" : bytes_of(path);
    int failures = 0, without = 0;
    for (long n = kFirst; without < 10; n += step) {
      SCOPED_TRACE(testing::PrintToString(arguments) + " allocation " + std::to_string(n));
      clear();
      const ProcessOutcome outcome = run(arguments, "ALLOCATION", n);
      ASSERT_EQ(outcome.signal, 0) << outcome.err;
      if (outcome.code == 0) {  // this allocation is not needed
        ++without;
        ASSERT_EQ(outcome.out, good.out);
        if (!output.empty()) {
          ASSERT_EQ(bytes_of(path), whole);
        }
        continue;
      }
      ++failures;
      without = 0;
      ASSERT_THAT(outcome.code, AnyOf(1, 3)) << outcome.err;
      // libseccomp does not report each failed allocation. It may drop a comparison of a rule (then a call is not
      // permitted), or never end (then the time limit of the reader ends it).
      ASSERT_THAT(outcome.err, AnyOf(HasSubstr("memory"), HasSubstr("Operation not permitted"),
                                     HasSubstr("limit for a file of this size")));
      // info goes on after a file that cannot be read, and may then lack memory itself.
      ASSERT_LE(test::lines_of(outcome.err).size(), arguments.front() == "info" ? 2U : 1U) << outcome.err;
      ASSERT_THAT(outcome.err, Not(IsEmpty()));
      ASSERT_THAT(folder_.names(), IsEmpty());
    }
    EXPECT_GT(failures, 10);
  }

  test::ScratchFolder folder_;
};

TEST_F(Faults, OfMemoryGiveOneLineAndNoFile) {
  constexpr long kStep = 61;  // a prime, so that different allocations fail
  expect_all_or_nothing({"info", kCorpus + "csv/record.csv"}, "", kStep);
  // libmatio reports few failed allocations: it drops variables, or their names. percuss must notice this, so the step
  // is small.
  expect_all_or_nothing({"info", kCorpus + "foreign/record.mat"}, "", 7);
  expect_all_or_nothing({"convert", kCorpus + "uff/record.uff", "--quiet"}, "out.csv", kStep);
  expect_all_or_nothing({"convert", kCorpus + "csv/record.csv", "--quiet"}, "out.uff", kStep);
  expect_all_or_nothing({"convert", kCorpus + "uff/record.uff", "--quiet"}, "out.mat", kStep);
}

// The heap reserves half a GiB of addresses for large pages, at most a quarter of a limit. Where this is less than
// 64 MiB, it grows in small steps.
TEST_F(Faults, OfAddressSpaceDoNotChangeASmallTest) {
  const test::ScratchFolder inputs;
  test::write_small_test(inputs.file("record.h5"));
  const std::vector<std::string> arguments{"analyze", inputs.file("record.h5"), "--json", "--threads", "1"};
  const ProcessOutcome free = test::run_percuss(arguments);
  ASSERT_EQ(free.code, 0) << free.err;
  for (const std::size_t max_MiB : {150U, 300U, 600U, 700U, 1000U}) {
    const ProcessOutcome limited = test::run_percuss(arguments, {.max_address_bytes = max_MiB << 20U});
    EXPECT_EQ(limited.code, 0) << max_MiB << " MiB: " << limited.err;
    EXPECT_TRUE(limited.out == free.out) << max_MiB << " MiB";
  }
}

TEST_F(Faults, OfTheDiskLeaveNoFile) {
  const test::ScratchFolder inputs;
  test::write_small_test(inputs.file("record.h5"));
  for (const char* extension : {".csv", ".h5", ".uff", ".mat", ".wav", ".rf64", ".w64"}) {
    const std::string path = folder_.file(std::string("out") + extension);
    int failures = 0;
    for (long n = 1; n < 100; n += 1 + n / 4) {
      SCOPED_TRACE(extension + std::string(" write ") + std::to_string(n));
      const ProcessOutcome outcome = run({"convert", inputs.file("record.h5"), path}, "WRITE", n);
      ASSERT_EQ(outcome.signal, 0);
      if (outcome.code == 0) break;
      ++failures;
      ASSERT_EQ(outcome.code, 3) << outcome.err;
      ASSERT_THAT(outcome.err, HasSubstr(path));
      ASSERT_THAT(folder_.names(), IsEmpty());
    }
    EXPECT_GE(failures, 1) << extension;
    clear();
  }
}

TEST_F(Faults, OfTheDiskLeaveTheOldFile) {
  const test::ScratchFolder inputs;
  test::write_small_test(inputs.file("record.h5"));
  for (const char* extension : {".csv", ".h5", ".uff", ".mat", ".wav"}) {
    const std::string path = folder_.file(std::string("out") + extension);
    test::write_bytes(path, "old");
    EXPECT_EQ(run({"convert", inputs.file("record.h5"), path, "--force"}, "WRITE", 2).code, 3);
    EXPECT_EQ(bytes_of(path), "old");
  }
}

TEST_F(Faults, OfShortWritesAreHandled) {
  const test::ScratchFolder inputs;
  test::write_small_test(inputs.file("record.h5"));
  for (const char* extension : {".csv", ".h5", ".uff", ".mat", ".wav", ".rf64", ".w64"}) {
    const std::string whole = folder_.file(std::string("whole") + extension),
                      bits = folder_.file(std::string("bits") + extension);
    ASSERT_EQ(test::run_percuss({"convert", inputs.file("record.h5"), whole}).code, 0);
    const ProcessOutcome outcome = run({"convert", inputs.file("record.h5"), bits}, "SHORT", 97);
    ASSERT_EQ(outcome.code, 0) << extension << outcome.err;
    EXPECT_TRUE(bytes_of(whole) == bytes_of(bits)) << extension;
  }
}

class BatchFaults : public Faults {
 protected:
  void SetUp() override {
    test::write_small_test(folder_.file("a.h5"), R"("hits": 1, "seed": 1)");
    test::write_small_test(folder_.file("b.csv"), R"("hits": 1, "seed": 2)");
    test::write_bytes(folder_.file("c.csv"), "no,record\n");
    ASSERT_EQ(batch({"plan", "a.h5", "b.csv", "c.csv", "-o", "m.jsonl", "--effort", "quick", "--quiet"}).code, 0);
    ASSERT_EQ(run_batch("good").code, 6);
    rows_ = merged("good");
  }
  ProcessOutcome batch(std::vector<std::string> words, const std::string& fault = "SHORT=0") const {
    words.insert(words.begin(), "batch");
    return test::run_percuss(
        words, {.folder = folder_.path(), .environment = {"LD_PRELOAD=" PERCUSS_FAULTS, "PERCUSS_FAULT_" + fault}});
  }
  ProcessOutcome run_batch(const std::string& out, const std::string& fault = "SHORT=0") const {
    return batch({"run", "--manifest", "m.jsonl", "-o", out, "--threads", "1", "--json"}, fault);
  }
  std::string merged(const std::string& out) const {
    const ProcessOutcome outcome = batch({"merge", "--manifest", "m.jsonl", out, "-o", out + ".jsonl", "--quiet"});
    EXPECT_EQ(outcome.code, 6) << outcome.err;
    return bytes_of(folder_.file(out + ".jsonl"));
  }
  /// Without the fault, a second run finishes with the rows of an undisturbed run.
  void expect_same_rows_later(const std::string& out) const {
    const ProcessOutcome again = run_batch(out);
    ASSERT_EQ(again.code, 6) << again.err;
    EXPECT_TRUE(merged(out) == rows_);
  }
  std::string rows_;
};

TEST_F(BatchFaults, OfProcessesLeaveTheRecordOpen) {
  const ProcessOutcome none = run_batch("none", "FORK=1");  // the fork server does not start
  EXPECT_EQ(none.code, 6) << none.err;
  const ProcessOutcome outcome = run_batch("some", "FORK=2");
  EXPECT_EQ(outcome.code, 6);
  EXPECT_THAT(outcome.err, HasSubstr("a is left open: cannot start a process that reads the file (a.h5)"));
  EXPECT_THAT(outcome.out, HasSubstr("\"open\": 1"));
  EXPECT_FALSE(fs::exists(folder_.file("some/part-0.ok")));
  const std::string status = batch({"status", "--manifest", "m.jsonl", "some", "--json"}).out;
  EXPECT_THAT(status, HasSubstr("\"id\": \"a\""));
  EXPECT_THAT(status, HasSubstr("\"stuck\": []"));
  EXPECT_THAT(batch({"status", "--manifest", "m.jsonl", "some"}).out,
              HasSubstr("left open by a fault of the machine: 1"));
  expect_same_rows_later("some");
}

TEST_F(BatchFaults, OfTheDiskAreNeverRows) {
  // The failing writes: the journal's first line, a begun record, its rows, part-0.jsonl, synchronisation of
  // part-0.jsonl.
  for (const long n : {1, 2, 5, 8, 9}) {
    SCOPED_TRACE(n);
    const std::string out = "out" + std::to_string(n);
    const ProcessOutcome outcome = run_batch(out, "WRITE=" + std::to_string(n));
    ASSERT_EQ(outcome.signal, 0);
    ASSERT_EQ(outcome.code, 6) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("No space left on device"));
    expect_same_rows_later(out);
  }
}

}  // namespace percuss::faults_test
