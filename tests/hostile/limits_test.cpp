#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

#include "support/files/synthetic_files.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Limits of the shell (ulimit) and closed standard streams: success, or one line and the documented exit code.
namespace percuss::limits_test {

namespace fs = std::filesystem;
using test::ProcessOutcome;
using test::run_percuss;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

class Limits : public testing::Test {
 protected:
  Limits() {
    test::write_small_test(inputs_.file("record.csv"));
    test::write_small_test(inputs_.file("record.h5"));
  }
  /// Expects success, or one line, an exit code for faults, and no file.
  void expect_clean(const ProcessOutcome& outcome) const {
    ASSERT_EQ(outcome.signal, 0) << outcome.err;
    if (outcome.code == 0) return;
    EXPECT_THAT(outcome.code, AnyOf(1, 3, 4)) << outcome.err;
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("percuss: "));
    EXPECT_THAT(folder_.names(), IsEmpty());
  }
  void clear() const {
    for (const std::string& name : folder_.names()) fs::remove(folder_.file(name));
  }
  std::vector<std::vector<std::string>> commands() const {
    std::vector<std::vector<std::string>> all{
        {"analyze", inputs_.file("record.csv"), "--quiet", "-o", folder_.file("a.json"), "-o", folder_.file("a.uff")},
        {"deflect", inputs_.file("record.h5"), "--quiet", "-o", folder_.file("d.h5")},
        {"survey", inputs_.file("record.h5"), "--quiet", "-o", folder_.file("s.h5")},
        {"frf", inputs_.file("record.h5"), "--quiet", "-o", folder_.file("f.h5")},
        {"synth", "wood-bat", "--quiet", "-o", folder_.file("y.h5")}};
    for (const char* extension : {".csv", ".h5", ".uff", ".mat", ".wav"})
      all.push_back({"convert", inputs_.file("record.csv"), folder_.file(std::string("c") + extension), "--quiet"});
    return all;
  }

  test::ScratchFolder inputs_, folder_;
};

#ifndef PERCUSS_SANITIZED  // the sanitizers need terabytes of addresses
// Regression: without memory, FFTW ended the program (SIGABRT), and HDF5 crashed while it wrote (SIGSEGV).
TEST_F(Limits, OfAddressesGiveOneLine) {
  // With less memory than least_MiB, the shared libraries cannot be loaded, and the program does not begin. The loop
  // finds this limit. 1 MiB is added, because the addresses of the libraries vary from run to run.
  std::size_t least_MiB = 30;
  while (least_MiB < 60 && run_percuss({"--version"}, {.max_address_bytes = least_MiB << 20U}).code != 0) ++least_MiB;
  ++least_MiB;
  int failures = 0;  // of all commands: for small ones, even least_MiB may be enough
  for (const auto& command : commands()) {
    int in_a_row = 0;
    for (std::size_t max_MiB = least_MiB; max_MiB <= 200 && in_a_row < 6; ++max_MiB) {
      SCOPED_TRACE(testing::PrintToString(command) + " " + std::to_string(max_MiB) + " MiB");
      clear();
      const ProcessOutcome outcome = run_percuss(command, {.max_address_bytes = max_MiB << 20U});
      expect_clean(outcome);
      if (HasFatalFailure()) return;
      failures += outcome.code == 0 ? 0 : 1;
      in_a_row = outcome.code == 0 ? in_a_row + 1 : 0;
    }
    EXPECT_EQ(in_a_row, 6) << testing::PrintToString(command);
  }
  EXPECT_GT(failures, 0);
}

// Regression: with a stack below 192 KiB, the program crashed.
TEST_F(Limits, OfTheStackChangeNothing) {
  const std::vector<std::string> command{"analyze", inputs_.file("record.csv"), "--json"};
  const std::string expected = run_percuss(command).out;
  for (const std::size_t kiB : {48U, 64U, 128U, 512U, 8192U}) {
    const ProcessOutcome outcome = run_percuss(command, {.limits = {{RLIMIT_STACK, kiB << 10U}}});
    EXPECT_EQ(outcome.code, 0) << kiB << " KiB: " << outcome.err;
    EXPECT_TRUE(outcome.out == expected) << kiB << " KiB";
  }
}
#endif

// Regression: SIGXFSZ ended the program.
TEST_F(Limits, OfFileSizesGiveOneLine) {
  for (const auto& command : commands()) {
    for (const std::size_t bytes : {0U, 1U, 4096U, 20000U}) {
      SCOPED_TRACE(testing::PrintToString(command) + " " + std::to_string(bytes) + " bytes");
      clear();
      const ProcessOutcome outcome = run_percuss(command, {.limits = {{RLIMIT_FSIZE, bytes}}});
      expect_clean(outcome);
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 3) << outcome.code << outcome.err;
    }
  }
}

TEST_F(Limits, OfOpenFilesGiveOneLine) {
  int failures = 0;  // of all commands: some need no file beside the standard streams
  for (const auto& command : commands()) {
    for (std::size_t most = 3; most < 16; ++most) {
      SCOPED_TRACE(testing::PrintToString(command) + " " + std::to_string(most) + " files");
      clear();
      const ProcessOutcome outcome = run_percuss(command, {.limits = {{RLIMIT_NOFILE, most}}});
      if (outcome.code == 127) continue;  // the dynamic linker could not open the libraries
      expect_clean(outcome);
      failures += outcome.code == 0 ? 0 : 1;
    }
  }
  EXPECT_GT(failures, 0);
}

// Regression: a file got the descriptor of a closed stream, and messages were written into the file.
TEST_F(Limits, OfClosedStreamsSpoilNoFile) {
  const std::string output = folder_.file("c.h5");
  const std::vector<std::string> command{"convert", inputs_.file("record.csv"), output};
  ASSERT_EQ(run_percuss(command).code, 0);
  const std::string expected = test::bytes_of(output);
  for (const std::vector<int>& closed : {std::vector{0}, {1}, {2}, {0, 1}, {1, 2}, {0, 1, 2}}) {
    clear();
    EXPECT_EQ(run_percuss(command, {.closed = closed}).code, 0);
    EXPECT_TRUE(test::bytes_of(output) == expected) << testing::PrintToString(closed);
    const ProcessOutcome printed = run_percuss({"analyze", inputs_.file("record.h5"), "--json"}, {.closed = closed});
    const bool can_print = std::find(closed.begin(), closed.end(), 1) == closed.end();
    EXPECT_EQ(printed.signal, 0) << testing::PrintToString(closed);
    EXPECT_EQ(printed.code, can_print ? 0 : 3) << testing::PrintToString(closed) << printed.err;
  }
  const ProcessOutcome no_input = run_percuss({"info", "-"}, {.closed = {0}});
  EXPECT_EQ(no_input.code, 3);
  EXPECT_THAT(no_input.err, HasSubstr("standard input"));
}

class LongInput : public testing::Test {
 protected:
  static constexpr std::size_t kLength = 28'000'000;
  std::string document(const std::string& head, const std::string& item, const std::string& tail) const {
    std::string text = head + item;
    text.reserve(kLength + 1000);
    while (text.size() < kLength) text.append(",").append(item);
    const std::string path = folder_.file("long.json");
    test::write_bytes(path, text + tail);
    return path;
  }
  test::ScratchFolder folder_;
};

// Regression: lists of empty objects or numbers took 1.5 GB, and values of unused keys 1.1 GB.
TEST_F(LongInput, OfJsonTakesMemoryInProportionToItsSize) {
  const std::string head = R"({"schema":"percuss/analysis/1","modes":[)";
  const std::string residue = R"({"point":1,"channel":1,"re":1.25e-3,"im":2.5e-4,"std":1e-5})";
  const std::vector<std::vector<std::string>> parts{
      {head, "{}", "]}"},
      {head, "0", "]}"},
      {head + R"(],"x":[)", "{}", "]}"},
      {head + R"({"frequency_hz":9,"residues":[)", residue, "]}]}"},
      {head, R"("")", "]}"},
      {head, "[[[0]]]", "]}"},
      {"[", R"({"schema":"percuss/analysis/1","modes":[]})", "]"},
  };
#ifdef PERCUSS_SANITIZED
  constexpr std::size_t kPerByte = 40;
#else
  constexpr std::size_t kPerByte = 10;
#endif
  for (const auto& part : parts) {
    const std::string path = document(part[0], part[1], part[2]);
    for (const std::vector<std::string>& command : {std::vector<std::string>{"compare", path, path}, {"study", path}}) {
      const ProcessOutcome outcome = run_percuss(command, {.environment = {"ASAN_OPTIONS=quarantine_size_mb=1"}});
      EXPECT_THAT(outcome.code, AnyOf(0, 3)) << part[1] << outcome.err;
      EXPECT_LT(outcome.peak_bytes, kPerByte * kLength) << command.front() << " " << part[1];
    }
  }
}

// A gigabyte without a line end. It is a hole in the file, so the test writes only 100 kB. Regression: the whole file
// was in memory before the line was refused.
TEST_F(LongInput, OfOneLineIsRefusedInSecondsWithLittleMemory) {
#ifndef PERCUSS_SANITIZED
  // The memory that the child takes over from the test program at the fork, and 17 MB of the file.
  constexpr std::size_t kMax_bytes = 250'000'000;
#endif
  const std::string path = folder_.file("long.csv"), head = "time,force,accel\n";
  std::string lines = head;
  while (lines.size() < 100'000) lines += "0,1,2\n";
  test::write_bytes(path, lines);
  std::filesystem::resize_file(path, 1'000'000'000);
  const auto number = 2 + (lines.size() - head.size()) / 6;
  for (const bool piped : {false, true}) {
    const auto began = std::chrono::steady_clock::now();
    const ProcessOutcome outcome = run_percuss({"info", piped ? "-" : path}, {.input = piped ? path : ""});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("a line of more than 1 MiB"));
    EXPECT_THAT(outcome.err, HasSubstr("line " + std::to_string(number)));
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
#ifndef PERCUSS_SANITIZED
    EXPECT_LT(outcome.peak_bytes, kMax_bytes);
#endif
  }
}

TEST_F(LongInput, OfALineAmongShortOnesIsRefusedWithItsNumber) {
  const std::string path = folder_.file("long.csv");
  for (const std::string& line_end : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
    std::string text = "time,force,accel" + line_end + "0,1,2" + line_end + "1,2,3" + line_end;
    while (text.size() < 2'000'000) text += "1.25,2.5,\" ,";
    test::write_bytes(path, text + line_end + "2,3,4" + line_end);
    const ProcessOutcome outcome = run_percuss({"info", path});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("a line of more than 1 MiB"));
    EXPECT_THAT(outcome.err, HasSubstr("line 4"));
  }
}

}  // namespace percuss::limits_test
