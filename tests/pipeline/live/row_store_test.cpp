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
  EXPECT_EQ(store.rows(), 2U);
  EXPECT_EQ(store.samples(), 3U);
}

// Files cannot grow beyond a limit, as on a full disk.
TEST(RowStore, SuggestsToResumeWhenTheDiskIsFull) {
  const test::ScratchFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  RowStore store(".", 1);
  std::filesystem::current_path(before);
  const auto old_signal = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  const rlimit limit{.rlim_cur = 100, .rlim_max = old.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const std::vector<std::vector<double>> row(2, std::vector<double>(100));
  const std::string message = test::input_error_of([&] { store.append(row); });
  ::setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_signal);
  EXPECT_THAT(message, HasSubstr("cannot keep a row"));
  EXPECT_THAT(message, HasSubstr("free some room, and resume the session"));
  EXPECT_THAT(message, HasSubstr("(" + std::filesystem::canonical(folder.path()).string() + ")"));
}

}  // namespace percuss::pipeline::row_store_test
