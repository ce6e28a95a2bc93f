#include "acquire/sandbox/fork_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <variant>

#include "acquire/sandbox/sandbox_process.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/formats/sandbox_measurement.hpp"
#include "support/scratch_folder.hpp"
#include "support/synthetic_files.hpp"

namespace percuss::reader_nursery_test {

using testing::HasSubstr;

/// Serves a row of numbers that count from the path's length; dies or refuses when the path asks for it.
ConfinedService counting(const std::string& path) {
  if (path == "crash") std::raise(SIGSEGV);
  if (path == "refuse") throw InputError("refused", path, "ask for another");
  const auto start = static_cast<double>(path.size());
  return {.description = path, .read = [start](std::size_t, std::size_t, std::size_t first, std::span<double> out) {
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = start + static_cast<double>(first + i);
          }};
}

std::string refusal(const std::shared_ptr<ReaderNursery>& nursery, const std::string& path) {
  try {
    const ConfinedProcess process(path, nursery);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

TEST(ReaderNursery, ForksReadersThatServe) {
  const auto nursery = std::make_shared<ReaderNursery>(counting);
  ConfinedProcess process("four", nursery);
  EXPECT_EQ(process.description(), "four");
  std::vector<double> numbers(300'000);  // more than go over at once
  process.read(0, 0, 10, numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], 14.0 + static_cast<double>(i));
}

TEST(ReaderNursery, ServesSeveralThreads) {
  const auto nursery = std::make_shared<ReaderNursery>(counting);
  parallel_for(40, 2, [&](std::size_t i) {
    const std::string path(i + 1, 'x');
    ConfinedProcess process(path, nursery);
    std::vector<double> numbers(5);
    process.read(0, 0, 0, numbers);
    EXPECT_EQ(numbers[4], static_cast<double>(i + 1) + 4);
  });
}

TEST(ReaderNursery, TellsWhatBecomesOfAReader) {
  const auto nursery = std::make_shared<ReaderNursery>(counting);
  EXPECT_THAT(refusal(nursery, "refuse"), HasSubstr("refused (refuse)"));
  EXPECT_THAT(refusal(nursery, "crash"), HasSubstr("crash"));
  EXPECT_EQ(refusal(nursery, "fine"), "");  // and is there for the next
  EXPECT_FALSE(nursery->lost());
}

TEST(ReaderNursery, SaysOfReadersThatNeverWere) {
  ReaderNursery nursery(counting);
  int status = 0;
  EXPECT_EQ(nursery.ended(1, status), -1);
  nursery.end(1, status);
  nursery.forget(1);
  EXPECT_EQ(nursery.ended(1, status), -1);
  EXPECT_FALSE(nursery.lost());
}

TEST(ReaderNursery, OpensWhatIsOpenedWithoutIt) {
  const test::ScratchFolder folder;
  FrfReadOptions options;
  options.read.confined = true;
  const auto nursery = measurement_nursery(options);
  for (const char* kind : {".h5", ".mat", ".wav", ".csv"}) {
    const std::string path = folder.file(std::string("t") + kind);
    test::write_small_test(path);
    const auto opened = open_measurement_in(nursery, path, options), alone = open_measurement(path, options);
    const auto &one = std::get<Record>(opened), &other = std::get<Record>(alone);
    EXPECT_EQ(one.fs_Hz, other.fs_Hz);
    ASSERT_EQ(one.rows.size(), other.rows.size());
    std::vector<double> a(one.rows[0].samples), b(a.size());
    one.read_force_N(0, 0, a);
    other.read_force_N(0, 0, b);
    EXPECT_EQ(a, b) << kind;
  }
}

}  // namespace percuss::reader_nursery_test
