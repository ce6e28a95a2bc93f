#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <fstream>
#include <functional>
#include <future>
#include <limits>
#include <random>
#include <thread>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/formats/mat/write_mat.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "acquire/sandbox/sandbox_measurement.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "core/error.hpp"
#include "support/files/mat_builder.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/input_error.hpp"
#include "support/percuss_process.hpp"
#include "support/record_samples.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::sandbox_test {

using test::accel_mps2;
using test::force_N;
using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

Record small_record() { return record_in_memory(1000, {{1, 2, 3}, {4, 5, 6}}, {{{7, 8, 9}}, {{10, 11, 12}}}); }

class Sandbox : public testing::Test {
 protected:
  /// The message when the sandboxed reader of a file calls `happens`.
  std::string message_when(const std::function<void()>& happens) const {
    return input_error_of([&] {
      open_in_sandbox(path_, [&] {
        happens();
        return small_record();
      });
    });
  }
  Record sandboxed(const std::function<Record()>& open) const { return std::get<Record>(open_in_sandbox(path_, open)); }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat");
};

TEST_F(Sandbox, OpensTheSameRecord) {
  for (const char* name : {"r.mat", "r.h5"}) {
    const std::string path = folder_.file(name);
    if (path.ends_with("mat")) {
      write_mat(path, small_record(), false);
    } else {
      write_hdf5(path, small_record(), false);
    }
    const Record here = open_record(path), there = open_record(path, {.sandboxed = true});
    EXPECT_EQ(there.fs_Hz, here.fs_Hz);
    EXPECT_EQ(there.format, here.format);
    EXPECT_EQ(there.accel[0].name, here.accel[0].name);
    EXPECT_EQ(there.rows.size(), here.rows.size());
    EXPECT_EQ(force_N(there, 1), force_N(here, 1));
    EXPECT_EQ(accel_mps2(there, 0, 1), accel_mps2(here, 0, 1));
  }
}

TEST_F(Sandbox, TellsWhichUnitsAreAssumed) {
  const Record there = sandboxed([] {
    Record record = small_record();
    record.force.unit_assumed = true;
    return record;
  });
  EXPECT_TRUE(there.force.unit_assumed);
  EXPECT_FALSE(there.accel.front().unit_assumed);
}

FrfRecord small_frfs() {
  FrfRecord out;
  out.files = {{.path = "r.mat"}};
  out.lines = lines_from_frequencies({1, 2, 3}, "r.mat");
  out.accel = {{.name = "accel 1"}};
  out.frfs = {{.point = 0, .channel = 0, .frf = {.value = {1, 2, 3}}}};
  return out;
}

// A record or FRFs with a geometry of three points.
template <class AnyRecord>
AnyRecord drawn(AnyRecord record) {
  record.geometry = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  record.trace_lines = {{0, 2}};
  record.trace_faces = {{0, 1, 2}};
  record.driving = {{.point = 2, .channel = 0}};
  return record;
}

TEST_F(Sandbox, PassesTheDrawingAndTheDrivingPlacesOn) {
  const auto expect_all = [](const auto& there) {
    EXPECT_EQ(there.geometry.size(), 3U);
    EXPECT_EQ(there.trace_lines, (std::vector<TraceLine>{{0, 2}}));
    EXPECT_EQ(there.trace_faces, (std::vector<TraceFace>{{0, 1, 2}}));
    EXPECT_EQ(there.driving, (std::vector<DrivingPlace>{{.point = 2, .channel = 0}}));
  };
  expect_all(sandboxed([] { return drawn(small_record()); }));
  expect_all(std::get<FrfRecord>(open_in_sandbox(path_, [] { return drawn(small_frfs()); })));
}

// Only a compromised process describes such records.
template <class AnyRecord>
std::vector<AnyRecord> contradictory_drawings(const AnyRecord& good) {
  const auto changed = [&](const std::function<void(AnyRecord&)>& change) {
    AnyRecord bad = drawn(good);
    change(bad);
    return bad;
  };
  return {changed([](AnyRecord& bad) {
            bad.trace_lines = {{0, 3}};
          }),
          changed([](AnyRecord& bad) {
            bad.trace_lines = {{-1, 0}};
          }),
          changed([](AnyRecord& bad) {
            bad.trace_faces = {{0, 1}};
          }),
          changed([](AnyRecord& bad) {
            bad.trace_faces = {{0, 1, 3}};
          }),
          changed([](AnyRecord& bad) { bad.geometry[1] = {}; }),
          changed([](AnyRecord& bad) {
            bad.geometry[1] = {1, 2};
          }),
          changed([](AnyRecord& bad) { bad.driving[0].channel = 1; }),
          changed([](AnyRecord& bad) { bad.driving[0].point = -1; })};
}

TEST_F(Sandbox, RefusesPartsThatContradictEachOther) {
  for (const Record& bad : contradictory_drawings(small_record()))
    EXPECT_THAT(input_error_of([&] { sandboxed([&] { return bad; }); }), HasSubstr("contradict"));
  std::vector<FrfRecord> frfs = contradictory_drawings(small_frfs());
  const auto add = [&](const std::function<void(FrfRecord&)>& change) { change(frfs.emplace_back(small_frfs())); };
  add([](FrfRecord& bad) { bad.lines.samples = 0; });
  add([](FrfRecord& bad) { bad.lines.fs_Hz = std::numeric_limits<double>::infinity(); });
  add([](FrfRecord& bad) { bad.lines.first = std::size_t{1} << 28U; });
  add([](FrfRecord& bad) { bad.kind = static_cast<FrfKind>(7); });
  for (const FrfRecord& bad : frfs)
    EXPECT_THAT(input_error_of([&] { open_in_sandbox(path_, [&] { return bad; }); }), HasSubstr("contradict"));
}

TEST_F(Sandbox, ServesMoreThanOneTransfer) {
  std::vector<double> force(400'000), accel(400'000);
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = static_cast<double>(i);
    accel[i] = -static_cast<double>(i);
  }
  const Record record = sandboxed([&] { return record_in_memory(1000, {force}, {{accel}}); });
  EXPECT_EQ(force_N(record), force);
  EXPECT_EQ(accel_mps2(record), accel);
}

TEST_F(Sandbox, PassesErrorsOn) {
  EXPECT_EQ(message_when([] { throw InputError("wrong", "here", "mend it"); }), "wrong (here); mend it");
  test::MatBuilder(path_, test::MatLevel::v5).numbers("a", {3, 1}, {1, 2, 3}).numbers("fs", {1, 1}, {9});
  try {
    open_record(path_, {.sandboxed = true});
    ADD_FAILURE();
  } catch (const AmbiguousColumns& unclear) {
    EXPECT_EQ(unclear.columns.at(0).name, "a");
    EXPECT_EQ(unclear.format, "MAT");
    EXPECT_EQ(unclear.fs_Hz, 9);
    EXPECT_FALSE(unclear.roles_known);
  }
  test::MatBuilder(path_, test::MatLevel::v5)
      .numbers("force_N", {3, 1}, {1, 2, 3})
      .numbers("acc_mV", {3, 1}, {1, 2, 3})
      .numbers("fs", {1, 1}, {9});
  try {
    open_record(path_, {.sandboxed = true});
    ADD_FAILURE();
  } catch (const AmbiguousColumns& unscaled) {
    EXPECT_TRUE(unscaled.roles_known);
    EXPECT_EQ(unscaled.columns.at(1).unit, "mV");
  }
  const Record record = sandboxed([] {
    Record bad = small_record();
    bad.read_force_N = [](std::size_t, std::size_t, std::span<double>) { throw InputError("bad sample", "x", "y"); };
    return bad;
  });
  EXPECT_THAT(input_error_of([&] { force_N(record); }), HasSubstr("bad sample"));
  EXPECT_EQ(accel_mps2(record)[0], 7) << "the reader still runs";
}

TEST_F(Sandbox, PassesTheFieldsOfAnErrorOn) {
  const auto error_of = [&](const InputError& thrown) -> std::optional<InputError> {
    try {
      open_in_sandbox(path_, [&]() -> Record { throw thrown; });
    } catch (const InputError& error) {
      return error;
    }
    return std::nullopt;
  };
  const InputError thrown("no sampling rate", path_, "state it in Hz", {"fs", "survey.example"});
  const auto error = error_of(thrown);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->problem(), thrown.problem());
  EXPECT_EQ(error->where(), thrown.where());
  EXPECT_EQ(error->remedy(), thrown.remedy());
  EXPECT_EQ(error->options(), thrown.options());
  EXPECT_STREQ(error->what(), thrown.what());
  // Only a compromised process sends such identifiers, which would reach the terminal.
  EXPECT_THAT(error_of(InputError("a", "b", "c", {"\x1b[2J"}))->what(), HasSubstr("contradict"));
  EXPECT_THAT(error_of(InputError("a", "b", "c", std::vector<OptionId>(17, "fs")))->what(), HasSubstr("contradict"));
}

TEST_F(Sandbox, ReportsACrashInOneLine) {
  EXPECT_THAT(message_when([] {
                void* const page = ::mmap(nullptr, 1, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
                *static_cast<volatile char*>(page) = 1;
              }),
              AllOf(HasSubstr("crash"), HasSubstr(path_)));
  EXPECT_THAT(message_when([] { ::_exit(7); }), HasSubstr("crash"));
  const Record record = sandboxed([] {
    Record bad = small_record();
    bad.read_force_N = [](std::size_t, std::size_t, std::span<double>) { std::raise(SIGABRT); };
    return bad;
  });
  EXPECT_THAT(input_error_of([&] { force_N(record); }), HasSubstr("crash"));
  EXPECT_THAT(input_error_of([&] { force_N(record); }), HasSubstr("has ended"));
}

TEST_F(Sandbox, ForbidsWritingConnectingAndForking) {
  const std::string other = folder_.file("other");
  test::write_bytes(other, "kept");
  EXPECT_THAT(message_when([&] {
                const int written = ::open(other.c_str(), O_WRONLY | O_TRUNC);
                const int made = ::open(folder_.file("made").c_str(), O_RDWR | O_CREAT, 0600);
                const int talk = ::socket(AF_INET, SOCK_STREAM, 0);
                const int gone = ::unlink(other.c_str());
                const int child = ::fork();
                throw InputError(std::to_string(written + made + talk + gone + child), "sum", "of refusals");
              }),
              HasSubstr("-5"));
  EXPECT_EQ(test::bytes_of(other), "kept");
}

TEST_F(Sandbox, EndsAReaderThatWaitsForEver) {
  const auto wait = [] {
    std::promise<SandboxService> never;
    return never.get_future().get();
  };
  EXPECT_THAT(input_error_of([&] { SandboxProcess(path_, wait, 1); }), HasSubstr("takes longer"));
  const auto serve = [&] {
    return SandboxService{.description = "d",
                          .read = [&](std::size_t, std::size_t, std::size_t, std::span<double>) { wait(); }};
  };
  SandboxProcess served(path_, serve, 1);
  ::usleep(1'500'000);  // the timeout does not apply between requests
  std::vector<double> out(3);
  EXPECT_THAT(input_error_of([&] { served.read(0, 0, 0, out); }), HasSubstr("takes longer"));
}

double processor_time_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST_F(Sandbox, LimitsTheProcessorTimeOfEachAnswer) {
  const auto work = [](std::size_t, std::size_t, std::size_t first, std::span<double>) {
    const double wanted_s = first == 0 ? 1.2 : 1000;
    for (const double start_s = processor_time_s(); processor_time_s() - start_s < wanted_s;) {
    }
  };
  SandboxProcess served(path_, [&] { return SandboxService{.description = "d", .read = work}; });
  std::vector<double> out(3);
  for (int answer = 0; answer < 2; ++answer) served.read(0, 0, 0, out);  // 2.4 s in total
  EXPECT_THAT(input_error_of([&] { served.read(0, 0, 1, out); }), HasSubstr("s of processor time"));
}

// Another thread uses the HDF5 library while this thread forks.
TEST_F(Sandbox, ForksWithLibrariesIdle) {
  std::atomic<bool> stop = false;
  std::thread other([&] {
    while (!stop) const hdf5::Lock lock;
  });
  for (int i = 0; i < 20; ++i) {
    EXPECT_THAT(message_when([] {
                  const hdf5::Lock lock;
                  throw InputError("got it", "here", "now");
                }),
                HasSubstr("got it"));
  }
  stop = true;
  other.join();
}

#ifndef PERCUSS_SANITIZED  // the sanitizers reserve terabytes
TEST_F(Sandbox, LimitsMemory) {
  EXPECT_THAT(message_when([] {
                const std::vector<char> much(std::size_t{300} << 20U);
                throw InputError(std::to_string(much.size()), "was", "there");
              }),
              HasSubstr("more memory than 256 MiB, the limit for a file of this size"));
}
#endif

// libmatio crashes on a few of these files; percuss must not.
TEST_F(Sandbox, SurvivesDamagedMatFiles) {
  std::mt19937 random(73);
  for (const auto level : {test::MatLevel::v5, test::MatLevel::v5_compressed, test::MatLevel::v73}) {
    std::vector<double> samples(200, 1.5);
    samples[50] = 100;
    test::MatBuilder(path_, level)
        .numbers("fs", {1, 1}, {1000})
        .numbers("force", {200, 1}, samples)
        .structure("s", {"accel", "x"}, {{samples, {1, 2}}});
    const std::string good = test::bytes_of(path_);
    for (int i = 0; i < 150; ++i) {
      std::string damaged = good;
      for (int n = 0; n < 1 + i % 3; ++n) {
        damaged[random() % (i % 2 == 0 ? std::min<std::size_t>(600, good.size()) : good.size())] =
            static_cast<char>(random() & 0xFFU);
      }
      test::write_bytes(path_, damaged);
      try {
        const auto opened = acquire::open_measurement(path_, {.read = {.sandboxed = true}});
        if (const auto* record = std::get_if<Record>(&opened)) force_N(*record);
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(Sandbox, IsUsedByCommandsUnlessTheInputIsTrusted) {
  test::write_small_test(path_);
  const auto sandboxed = test::run_percuss({"analyze", path_, "--json"});
  const auto trusting = test::run_percuss({"analyze", path_, "--json", "--trust-input"});
  EXPECT_EQ(sandboxed.code, 0) << sandboxed.err;
  EXPECT_EQ(sandboxed.out, trusting.out);
  test::write_bytes(path_, "MATLAB 5.0 MAT-file" + std::string(200, ' '));
  test::expect_reading_commands_reject(path_, path_);
}

}  // namespace percuss::acquire::sandbox_test
