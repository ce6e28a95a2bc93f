#include "pipeline/live/row_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::pipeline::row_store_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(RowStore, ReturnsTheSamplesOfItsRows) {
  const test::ScratchFolder folder;
  RowStore store(folder.path(), 1);
  store.append({{1, 2, 3}, {4, 5, 6}});
  store.append({{7, 8, 9}, {10, 11, 12}});
  std::vector<double> out(2);
  store.read(1, 1, 1, out);
  EXPECT_THAT(out, ElementsAre(11, 12));
  EXPECT_EQ(store.samples(), 3U);
}

/// Files of this process cannot grow beyond a limit, as on a full disk.
class FullDisk {
 public:
  FullDisk() : old_signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{.rlim_cur = 100, .rlim_max = old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_signal_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit old_{};
  void (*old_signal_)(int);
};

std::vector<std::vector<double>> row_of(double value) { return {std::vector(100, value), std::vector(100, -value)}; }

double value_at(const RowStore& store, std::size_t row, std::size_t signal) {
  std::vector<double> out(1);
  store.read(row, signal, 99, out);
  return out.front();
}

TEST(RowStore, KeepsRowsInMemoryWhileTheDiskIsFull) {
  const test::ScratchFolder folder;
  RowStore store(folder.path(), 1);
  store.append(row_of(1));
  {
    const FullDisk full;
    store.append(row_of(2));
    store.append(row_of(3));
    EXPECT_EQ(value_at(store, 0, 1), -1);
    EXPECT_EQ(value_at(store, 1, 0), 2);
    EXPECT_EQ(value_at(store, 2, 1), -3);
  }
  store.append(row_of(4));
  for (std::size_t row = 0; row < 4; ++row) EXPECT_EQ(value_at(store, row, 0), static_cast<double>(row + 1));
}

TEST(RowStore, SuggestsToResumeWhenTooManyRowsWait) {
  const test::ScratchFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  constexpr std::size_t kOneRow_bytes = 1600;
  RowStore store(".", 1, kOneRow_bytes);
  std::filesystem::current_path(before);
  const FullDisk full;
  store.append(row_of(1));
  const std::string message = test::input_error_of([&] { store.append(row_of(2)); });
  EXPECT_THAT(message, HasSubstr("cannot keep a row"));
  EXPECT_THAT(message, HasSubstr("free some room, and resume the session"));
  EXPECT_THAT(message, HasSubstr("(" + std::filesystem::canonical(folder.path()).string() + ")"));
}

}  // namespace percuss::pipeline::row_store_test
