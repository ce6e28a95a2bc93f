#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "acquire/open_measurement.hpp"
#include "acquire/sandbox/sandbox_measurement.hpp"
#include "core/error.hpp"
#include "support/confinement.hpp"
#include "support/files/mat_builder.hpp"
#include "support/input_error.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Memory and processor time of a reader follow from the size of the file, whatever the file claims.
namespace percuss::reader_limits_test {

using acquire::Measurement;
using acquire::Record;
using testing::AnyOf;
using testing::HasSubstr;

const std::string kForeign = PERCUSS_SOURCE_DIR "/fuzz/corpus/foreign/";

#ifdef PERCUSS_SANITIZED
constexpr bool kLimitsMemory = false;  // sanitizers need terabytes of addresses
constexpr double kMaxTime_s = 100;
#else
constexpr bool kLimitsMemory = true;
constexpr double kMaxTime_s = 5;  // the limit is 2 s
#endif
// The limit of a small file is 256 MiB, in addition to the memory of the process before it reads.
constexpr std::size_t kMaxMemory_bytes = 450'000'000;

class ReaderLimits : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(, ReaderLimits,
                         testing::Values("long_field_names.mat", "long_name.mat", "long_unit.h5", "slow_structure.mat"),
                         [](const auto& one) {
                           const std::string name = one.param;
                           return name.substr(0, name.find('.'));
                         });

TEST_P(ReaderLimits, HoldForSmallFiles) {
  if (!kLimitsMemory && std::string_view(GetParam()) != "slow_structure.mat") return;
  const auto run = test::run_percuss({"info", kForeign + GetParam()});
  EXPECT_THAT(run.code, AnyOf(0, 3)) << run.err;
  EXPECT_LT(run.processor_s, kMaxTime_s);
  if (kLimitsMemory) {
    EXPECT_LT(run.peak_bytes, kMaxMemory_bytes);
  }
  if (kLimitsMemory && test::has_seccomp() && std::string_view(GetParam()) == "slow_structure.mat") {
    EXPECT_THAT(run.err, HasSubstr("more than 2 s of processor time, the limit for a file of this size"));
  }
}

// 50 million numbers of one byte, compressed to about 50 kB. As numbers of 8 bytes they would take 400 MB.
TEST(MatClaims, CountTheBytesOfDecodedNumbers) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("r.mat");
  test::MatBuilder(path, test::MatLevel::v5_compressed).bytes_of_zero("force", 50'000'000);
  const std::string message = test::input_error_of([&] { acquire::open_measurement(path); });
  EXPECT_THAT(message, HasSubstr("claims more numbers than it can hold"));
}

// A compromised reader may claim anything.
class ReaderClaims : public testing::Test {
 protected:
  std::string refusal_of(const std::function<void(Record&)>& spoil) const {
    return test::input_error_of([&] {
      acquire::open_in_sandbox(path_, [&]() -> Measurement {
        Record record = acquire::record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
        record.files = {{.path = path_, .bytes = 5}};
        spoil(record);
        return record;
      });
    });
  }
  void SetUp() override { test::write_bytes(path_, "bytes"); }
  const char* expected() const { return test::has_seccomp() ? "contradict each other" : "cannot confine"; }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat");
};

TEST_F(ReaderClaims, OfMoreSamplesThanTheFileCanHoldAreRefused) {
  for (const std::size_t samples : {std::size_t{10'000'000}, std::size_t{1} << 40U, std::size_t{1} << 62U}) {
    EXPECT_THAT(refusal_of([&](Record& record) { record.rows[0].samples = samples; }), HasSubstr(expected()));
  }
  EXPECT_THAT(refusal_of([](Record& record) { record.rows.assign(100'000, {.samples = 1000}); }),
              HasSubstr(expected()));
  EXPECT_THAT(refusal_of([](Record& record) {
                record.rows[0].samples = 1'000'000;
                record.accel.resize(100);
              }),
              HasSubstr(expected()));
}

TEST_F(ReaderClaims, OfSamplesBeyondTheFileAreRefused) {
  const auto stored = [&](acquire::ContiguousSignal signal) {
    return refusal_of([&](Record& record) { record.contiguous = {signal, signal}; });
  };
  EXPECT_THAT(stored({.offset_bytes = 0}), HasSubstr(expected()));
  EXPECT_THAT(stored({.offset_bytes = std::numeric_limits<std::uint64_t>::max() - 23}), HasSubstr(expected()));
  EXPECT_THAT(stored({.number_bytes = 0}), HasSubstr(expected()));
}

TEST_F(ReaderClaims, OfAnotherFileAreIgnored) {
  if (!test::has_seccomp()) return;
  const std::string other = folder_.file("other");
  const std::vector<double> secret(6, 42);
  test::write_bytes(other, std::string(reinterpret_cast<const char*>(secret.data()), 48));
  test::write_bytes(path_, std::string(48, '\0'));
  const Measurement opened = acquire::open_in_sandbox(path_, [&]() -> Measurement {
    Record record = acquire::record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
    record.files = {{.path = other, .bytes = 48}};
    record.contiguous = {{}, {}};
    return record;
  });
  const auto& record = std::get<Record>(opened);
  EXPECT_EQ(record.source(), path_);
  std::vector<double> samples(3);
  record.read_force_N(0, 0, samples);
  EXPECT_EQ(samples[0], 0);
}

}  // namespace percuss::reader_limits_test
