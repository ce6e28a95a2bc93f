#include "core/io/atomic_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>

#include "core/io/temporary_files.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::atomic_file_test {

namespace fs = std::filesystem;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Temporary = AtomicFile::Temporary;

/// Every test runs twice: with an unnamed and with a named temporary file.
class AtomicFileTest : public testing::TestWithParam<Temporary> {
 protected:
  void write(const std::string& bytes, bool force) const {
    AtomicFile file(path_, force, GetParam());
    file.write(bytes);
    file.commit();
  }
  /// The status of a child that ran `work`, as from waitpid.
  static int status_of_child(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(0);
    }
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("x.csv");
};

INSTANTIATE_TEST_SUITE_P(, AtomicFileTest, testing::Values(Temporary::unnamed_if_possible, Temporary::named),
                         [](const auto& one) { return one.param == Temporary::named ? "Named" : "Unnamed"; });

TEST_P(AtomicFileTest, AppearsWholeAtTheEnd) {
  {
    AtomicFile file(path_, false, GetParam());
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(fs::exists(path_));
    file.commit();
  }
  EXPECT_EQ(test::bytes_of(path_), "one two");
  EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
}

TEST_P(AtomicFileTest, HasTheModeOfOrdinaryFiles) {
  const mode_t before = ::umask(027);
  write("x", false);
  ::umask(before);
  struct stat info {};
  ASSERT_EQ(::stat(path_.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0640u);
}

TEST_P(AtomicFileTest, ReplacesOnlyWhenForced) {
  test::write_bytes(path_, "old");
  EXPECT_EQ(input_error_of([&] { write("new", false); }),
            "file exists (" + path_ + "); give another name, or overwrite it");
  EXPECT_EQ(test::bytes_of(path_), "old");
  write("new", true);
  EXPECT_EQ(test::bytes_of(path_), "new");
  EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
}

TEST_P(AtomicFileTest, DoesNotReplaceAFileThatAppearedMeanwhile) {
  AtomicFile file(path_, false, GetParam());
  file.write("new");
  test::write_bytes(path_, "somebody else's");
  EXPECT_THAT(input_error_of([&] { file.commit(); }), HasSubstr("file exists"));
  EXPECT_EQ(test::bytes_of(path_), "somebody else's");
}

TEST_P(AtomicFileTest, VanishesWithoutCommit) {
  test::write_bytes(path_, "old");
  { AtomicFile(path_, true, GetParam()).write("half"); }
  EXPECT_EQ(test::bytes_of(path_), "old");
  EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
}

TEST_P(AtomicFileTest, LeavesTheOldFileWhenTheWriterIsKilled) {
  test::write_bytes(path_, "old");
  EXPECT_TRUE(WIFSIGNALED(status_of_child([&] {
    AtomicFile file(path_, true, GetParam());
    file.write("half");
    ::raise(SIGKILL);
  })));
  EXPECT_EQ(test::bytes_of(path_), "old");
  if (GetParam() == Temporary::unnamed_if_possible) {
    EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
  }
  write("new", true);  // also removes the temporary file of the killed writer
  EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
}

TEST_P(AtomicFileTest, CanBeRemovedByASignalHandler) {
  EXPECT_EQ(status_of_child([&] {
              AtomicFile file(path_, false, GetParam());
              file.write("half");
              remove_temporary_files();
              ::_exit(7);
            }),
            W_EXITCODE(7, 0));
  EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_P(AtomicFileTest, KeepsTheFilesOfOtherWriters) {
  AtomicFile first(path_, true, GetParam()), second(path_, true, GetParam());
  first.write("first");
  second.write("second");
  first.commit();
  EXPECT_EQ(test::bytes_of(path_), "first");
  second.commit();
  EXPECT_EQ(test::bytes_of(path_), "second");
  EXPECT_THAT(folder_.names(), ElementsAre("x.csv"));
}

TEST_P(AtomicFileTest, RemovesWhatKilledWritersLeft) {
  test::write_bytes(folder_.file(".x.csv.percuss-99999999"), "");
  test::write_bytes(folder_.file(".x.csv.percuss-99999999-7"), "");
  const std::vector<std::string> others{".x.csv.percuss-notes", ".y.csv.percuss-99999999", "x.csv.percuss-1"};
  for (const std::string& name : others) test::write_bytes(folder_.file(name), "mine");
  ASSERT_EQ(::mkfifo(folder_.file(".x.csv.percuss-5").c_str(), 0600), 0);
  write("new", false);
  EXPECT_FALSE(fs::exists(folder_.file(".x.csv.percuss-99999999")));
  EXPECT_FALSE(fs::exists(folder_.file(".x.csv.percuss-99999999-7")));
  EXPECT_EQ(folder_.names().size(), others.size() + 2);
}

TEST_P(AtomicFileTest, RefusesSymbolicLinksWhereAskedTo) {
  test::write_bytes(folder_.file("victim"), "kept");
  fs::create_symlink("victim", path_);
  EXPECT_THROW(AtomicFile(path_, true, GetParam(), AtomicFile::Links::refused), InputError);
  fs::remove(folder_.file("victim"));
  EXPECT_THROW(AtomicFile(path_, true, GetParam(), AtomicFile::Links::refused), InputError);
  EXPECT_TRUE(fs::is_symlink(path_));
}

TEST_P(AtomicFileTest, FollowsSymbolicLinks) {
  const std::string target = folder_.file("target");
  test::write_bytes(target, "old");
  fs::create_symlink("target", path_);
  write("new", true);
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(test::bytes_of(target), "new");
}

TEST_P(AtomicFileTest, AcceptsLongNames) {
  path_ = folder_.file(std::string(255, 'n'));
  write("x", false);
  EXPECT_EQ(test::bytes_of(path_), "x");
}

TEST_P(AtomicFileTest, ReportsWhyItCannotBeWritten) {
  const auto refusal = [&](const std::string& path) {
    return input_error_of([&] { AtomicFile(path, true, GetParam()); });
  };
  EXPECT_THAT(refusal(folder_.file("no/x.csv")), HasSubstr("create the folder"));
  EXPECT_THAT(refusal(folder_.path()), HasSubstr("is a folder"));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal(""), HasSubstr("empty file name"));
  EXPECT_THAT(refusal(folder_.file(std::string(300, 'n'))), HasSubstr("nnn"));
}

TEST_P(AtomicFileTest, ReportsAFullDisk) {
  EXPECT_EQ(status_of_child([&] {
              const rlimit limit{.rlim_cur = 100, .rlim_max = 100};  // fails like a full disk
              ::setrlimit(RLIMIT_FSIZE, &limit);
              ::signal(SIGXFSZ, SIG_IGN);
              const std::string message = input_error_of([&] { write(std::string(200, 'x'), false); });
              ::_exit(message.find(path_) == std::string::npos ? 1 : 7);
            }),
            W_EXITCODE(7, 0));
  EXPECT_THAT(folder_.names(), IsEmpty());
}

/// The files of a group, with the same two kinds of temporary file.
class OutputGroupTest : public AtomicFileTest {
 protected:
  void write_as(const std::string& name, const std::string& bytes, bool force) const {
    AtomicFile file(folder_.file(name), force, GetParam());
    file.write(bytes);
    file.commit();
  }
};

INSTANTIATE_TEST_SUITE_P(, OutputGroupTest, testing::Values(Temporary::unnamed_if_possible, Temporary::named),
                         [](const auto& one) { return one.param == Temporary::named ? "Named" : "Unnamed"; });

TEST_P(OutputGroupTest, AppearsAsAWhole) {
  test::write_bytes(folder_.file("b"), "old");
  {
    OutputGroup outputs;
    write_as("a", "new a", true);
    write_as("b", "new b", true);
    EXPECT_FALSE(fs::exists(folder_.file("a")));
    EXPECT_EQ(test::bytes_of(folder_.file("b")), "old");
    outputs.commit();
  }
  EXPECT_THAT(folder_.names(), testing::UnorderedElementsAre("a", "b"));
  EXPECT_EQ(test::bytes_of(folder_.file("a")), "new a");
  EXPECT_EQ(test::bytes_of(folder_.file("b")), "new b");
  write_as("c", "alone again", false);
  EXPECT_EQ(test::bytes_of(folder_.file("c")), "alone again");
}

TEST_P(OutputGroupTest, VanishesWhenOneFails) {
  EXPECT_THAT(input_error_of([&] {
                OutputGroup outputs;
                write_as("a", "new", false);
                write_as("missing/b", "new", false);
                outputs.commit();
              }),
              HasSubstr("missing/b"));
  EXPECT_THAT(folder_.names(), IsEmpty());
  // Both would be new, but a file appears at the last moment.
  EXPECT_THAT(input_error_of([&] {
                OutputGroup outputs;
                write_as("a", "new", false);
                write_as("b", "new", false);
                test::write_bytes(folder_.file("b"), "other");
                outputs.commit();
              }),
              HasSubstr("file exists"));
  EXPECT_THAT(folder_.names(), ElementsAre("b"));
  EXPECT_EQ(test::bytes_of(folder_.file("b")), "other");
}

TEST_P(OutputGroupTest, IsWithdrawnWhenARenameFails) {
  EXPECT_NE(input_error_of([&] {
              OutputGroup outputs;
              write_as("a", "new", true);
              write_as("b", "new", true);
              fs::create_directory(folder_.file("b"));  // cannot be replaced by a file
              outputs.commit();
            }),
            "");
  EXPECT_THAT(folder_.names(), ElementsAre("b"));
}

TEST_P(OutputGroupTest, LeavesItsFilesToTheOuterGroup) {
  OutputGroup outer;
  {
    OutputGroup inner;
    write_as("a", "new", false);
    inner.commit();
  }
  EXPECT_FALSE(fs::exists(folder_.file("a")));
  outer.commit();
  EXPECT_THAT(folder_.names(), ElementsAre("a"));
}

TEST(WriteFile, WritesAllAtOnce) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("x"), bytes("a\0b\n", 4);
  write_file(path, bytes, false);
  EXPECT_EQ(test::bytes_of(path), bytes);
  EXPECT_THROW(write_file(path, "other", false), InputError);
}

}  // namespace percuss::atomic_file_test
