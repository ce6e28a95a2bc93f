#include "batch/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::batch::plan_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class BatchPlan : public testing::Test {
 protected:
  std::string make(const std::string& name) {
    std::string path = folder_.file(name);
    fs::create_directories(fs::path(path).parent_path());
    test::write_bytes(path, name);
    return path;
  }
  /// Ids of the records planned from these files.
  std::vector<std::string> ids(const std::vector<std::string>& paths) {
    std::vector<std::string> out;
    for (const BatchRecord& record : records_of_files(paths, folder_.path(), false)) out.push_back(record.id);
    return out;
  }
  test::ScratchFolder folder_;
};

TEST_F(BatchPlan, ReadsFoldersInOrder) {
  const std::string b = make("b/z.csv"), a = make("a.h5"), c = make("c/d/x.MAT");
  make("notes.md");
  make(".hidden.csv");
  make(".git/x.csv");
  const RecordFiles files = record_files({folder_.path()});
  EXPECT_THAT(files.paths, ElementsAre(a, b, c));
  EXPECT_EQ(files.left_out.size(), 1U);
}

TEST_F(BatchPlan, AcceptsPatternsAndTakesEachFileOnce) {
  const std::string a = make("a1.csv"), b = make("a2.csv"), c = make("b.csv"), odd = make("[1].csv");
  EXPECT_THAT(record_files({folder_.file("a*.csv"), b, c}).paths, ElementsAre(a, b, c));
  EXPECT_THAT(record_files({odd}).paths, ElementsAre(odd));  // the name of a file takes precedence over a pattern
  EXPECT_THAT(record_files({make("any.name")}).paths, ElementsAre(folder_.file("any.name")));
  EXPECT_THROW(record_files({folder_.file("z*.csv")}), InputError);
  EXPECT_THROW(record_files({folder_.file("none.csv")}), InputError);
}

TEST_F(BatchPlan, TellsFoldersThatCannotBeReadFromPatternsWithoutAMatch) {
  fs::create_symlink("loop", folder_.file("loop"));  // opening it fails with ELOOP, also for root
  const auto message = [&](const char* pattern) {
    return test::input_error_of([&] { record_files({folder_.file(pattern)}); });
  };
  EXPECT_THAT(message("loop/*.csv"), HasSubstr("a folder of the pattern cannot be read"));
  EXPECT_THAT(message("missing/*.csv"), HasSubstr("no file matches the pattern"));
  make("file.csv");
  EXPECT_THAT(message("file.csv/*.csv"), HasSubstr("no file matches the pattern"));
}

TEST_F(BatchPlan, ListsFilesInNaturalOrder) {
  const std::string ten = make("hit10.csv"), two = make("hit2.csv");
  EXPECT_THAT(record_files({folder_.path()}).paths, ElementsAre(two, ten));
  EXPECT_THAT(record_files({folder_.file("*.csv")}).paths, ElementsAre(two, ten));
}

TEST_F(BatchPlan, NamesThePartsOfHits) {
  const auto parts =
      hits_of_one_part({"x/A/hit10.h5", "x/A/hit2.h5", "x/B_hit1.h5", "x/B_hit2.h5", "hit1.h5", "hit2.h5", "x/C.h5"});
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].part, "A");
  EXPECT_THAT(parts[0].paths, ElementsAre("x/A/hit2.h5", "x/A/hit10.h5"));
  EXPECT_EQ(parts[1].part, "B");
  EXPECT_EQ(parts[2].part, "") << "neither a name nor a folder";
}

TEST_F(BatchPlan, ReadsOnePathPerLine) {
  EXPECT_THAT(parse_path_list("a b.h5\r\n\nc.h5\nd.h5"), ElementsAre("a b.h5", "c.h5", "d.h5"));
  EXPECT_TRUE(parse_path_list("").empty());
}

TEST_F(BatchPlan, NamesRecordsByTheirFilesWhereUnique) {
  EXPECT_THAT(ids({make("b.h5"), make("a.csv"), make("x/c.csv")}), ElementsAre("a", "b", "c"));
  EXPECT_THAT(ids({make("one/t.h5"), make("two/t.h5"), make("u.h5")}),
              ElementsAre(folder_.file("one/t.h5"), folder_.file("two/t.h5"), "u"));
}

TEST_F(BatchPlan, StoresPathsRelativeToTheManifest) {
  make("recs/a.csv");
  fs::create_directory(folder_.file("plans"));
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  const auto beside = records_of_files({"recs/a.csv"}, ".", true),
             below = records_of_files({"recs/a.csv"}, "plans", false);
  fs::current_path(before);
  EXPECT_EQ(beside.at(0).path, "recs/a.csv");
  EXPECT_EQ(below.at(0).path, "../recs/a.csv");
  EXPECT_EQ(beside.at(0).bytes, 10U);
  EXPECT_EQ(beside.at(0).sha256.size(), 64U);
  EXPECT_EQ(records_of_files({folder_.file("recs/a.csv")}, ".", false).at(0).path, folder_.file("recs/a.csv"));
}

TEST_F(BatchPlan, RejectsNamesThatAreNotUtf8) {
  for (const char* const name : {"a\xff.csv", "\xc0\xae.csv", "\xed\xa0\x80.csv"}) {  // no UTF-8, overlong, surrogate
    const std::string path = make(name);
    EXPECT_THAT(test::input_error_of([&] { records_of_files({path}, folder_.path(), false); }),
                testing::HasSubstr("the file's name is not UTF-8"));
  }
  EXPECT_EQ(ids({make("\xc3\xa4.csv")}).at(0), "\xc3\xa4");
}

}  // namespace percuss::batch::plan_test
