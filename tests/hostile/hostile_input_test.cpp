#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <random>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// Files on a user's disk that are not records.
namespace percuss::hostile_input_test {

namespace fs = std::filesystem;
using test::expect_reading_commands_reject;
using test::rejection_of;
using test::run_percuss;
using testing::HasSubstr;

class HostileInput : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return folder_.file(name); }
  test::ScratchFolder folder_;
};

std::string garbage(std::size_t count) {
  std::mt19937 random(7);
  std::string bytes(count, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() & 0xFFU);
  return bytes;
}

TEST_F(HostileInput, RejectsMissingFiles) {
  expect_reading_commands_reject(file("none.h5"), "no such file (" + file("none.h5"));
  expect_reading_commands_reject(file("none/none.csv"), file("none/none.csv"));
}

TEST_F(HostileInput, RejectsEmptyFilesOfAnyName) {
  for (const char* name : {"empty.h5", "empty.csv", "empty"}) {
    test::write_bytes(file(name), "");
    expect_reading_commands_reject(file(name), file(name));
  }
}

TEST_F(HostileInput, RejectsFolders) { expect_reading_commands_reject(folder_.path(), folder_.path()); }

TEST_F(HostileInput, RejectsDevicesAndPipesWithoutWaiting) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0666), 0);
  for (const std::string& path : {file("pipe"), std::string("/dev/zero"), std::string("/dev/null")})
    expect_reading_commands_reject(path, path, {.time_limit = std::chrono::seconds(20)});
}

TEST_F(HostileInput, RejectsUnreadableFiles) {
  fs::permissions(folder_.path(), fs::perms::all);
  for (const char* name : {"secret.h5", "secret.csv"}) {
    test::write_small_test(file(name), R"("hits": 1)");
    fs::permissions(file(name), fs::perms::none);
    expect_reading_commands_reject(file(name), file(name), {.ordinary_user = true});
  }
  fs::create_directory(file("closed"));
  test::write_bytes(file("closed/a.csv"), "t_s,force_N,acc_g\n0,1,2\n1,2,3\n");
  fs::permissions(file("closed"), fs::perms::none);
  expect_reading_commands_reject(file("closed/a.csv"), file("closed/a.csv"), {.ordinary_user = true});
  fs::permissions(file("closed"), fs::perms::all);
}

TEST_F(HostileInput, RejectsGarbageOfAnyName) {
  for (const char* name : {"garbage.h5", "garbage.csv"}) {
    test::write_bytes(file(name), garbage(100000));
    expect_reading_commands_reject(file(name), file(name));
    test::write_bytes(file(name), std::string(100000, '\0'));
    expect_reading_commands_reject(file(name), file(name));
    test::write_bytes(file(name), "\x89HDF\r\n\x1a\n" + garbage(5000));
    expect_reading_commands_reject(file(name), file(name));
  }
}

TEST_F(HostileInput, RejectsForeignFilesByTheirKind) {
  test::write_bytes(file("lab.mat"), "MATLAB 5.0 MAT-file, Platform: GLNXA64" + std::string(200, ' '));
  expect_reading_commands_reject(file("lab.mat"), "MAT file");
  test::write_bytes(file("lab.wav"), "RIFF    WAVEfmt " + std::string(200, '\0'));
  expect_reading_commands_reject(file("lab.wav"), "damaged");
}

TEST_F(HostileInput, RejectsTextThatIsNotATable) {
  for (const auto& text :
       {std::string("hello"), std::string("a,b,c\n"), std::string(300000, 'x'), std::string(300000, ','),
        std::string(300000, '\n'), std::string(300000, '"'), std::string("\xFF\xFEt\0,\0", 6)}) {
    test::write_bytes(file("text.csv"), text);
    expect_reading_commands_reject(file("text.csv"), file("text.csv"));
  }
}

TEST_F(HostileInput, NamesFilesWithHostileNamesInOneCleanLine) {
  for (const char* name : {"a\nb.h5", "a\rb.csv", "\x1b[31mred.h5", "a\tb.csv", "\x7f.h5"})
    expect_reading_commands_reject(file(name), "no such file");
  expect_reading_commands_reject(file("\xff\xfe\x80.h5"), "no such file");
  expect_reading_commands_reject(file(std::string(4000, 'n')), "too long");
  expect_reading_commands_reject(file(std::string(200, '/') + "%s%n{}.csv"), "no such file");
}

TEST_F(HostileInput, ReportsGoodFilesWithHostileNames) {
  for (const char* name : {"a\nb.h5", "\x1b[31mred.h5", "\xff\xfe.h5", "-dash.h5", "a b;$(c).h5"}) {
    test::write_small_test(file(name), R"("hits": 1)");
    const auto text = run_percuss({"analyze", file(name)});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_THAT(text.out, testing::Not(HasSubstr("\x1b")));
    const auto json = run_percuss({"analyze", file(name), "--json"});
    EXPECT_EQ(json.code, 0) << json.err;
    EXPECT_EQ(test::parse_json(json.out)["modes"].size(), 2U);
    const auto info = run_percuss({"info", file(name)});
    EXPECT_EQ(info.code, 0) << info.err;
    EXPECT_THAT(info.out, testing::Not(HasSubstr("\x1b")));
  }
}

TEST_F(HostileInput, RejectsBadStandardInput) {
  test::write_bytes(file("empty"), "");
  test::write_bytes(file("garbage"), garbage(100000));
  test::write_small_test(file("bat.h5"), R"("hits": 1)");
  test::write_bytes(file("cut.h5"), test::bytes_of(file("bat.h5")).substr(0, 1000));
  for (const char* name : {"empty", "garbage", "cut.h5"})
    expect_reading_commands_reject("-", "standard input", {.input = file(name)});
  expect_reading_commands_reject("-", "standard input", {.input = "/dev/null"});
  expect_reading_commands_reject("-", "standard input", {.input = "/dev/zero", .time_limit = std::chrono::seconds(20)});
  expect_reading_commands_reject("-", "standard input", {.input = folder_.path()});
}

TEST_F(HostileInput, RejectsABadChannelSetUp) {
  test::write_small_test(file("bat.h5"), R"("hits": 1)");
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0666), 0);
  test::write_bytes(file("garbage"), garbage(1000));
  test::write_bytes(file("deep"), std::string(100000, '['));
  test::write_bytes(file("other"), R"({"name": "CH1"})");
  for (const std::string& setup : {file("none"), file("pipe"), file("garbage"), file("deep"), file("other"),
                                   folder_.path(), std::string("/dev/zero")})
    rejection_of({"analyze", file("bat.h5"), "--setup", setup}, {".json"}, setup,
                 {.time_limit = std::chrono::seconds(20)});
}

TEST_F(HostileInput, RejectsOutputsThatCannotBeWritten) {
  test::write_small_test(file("bat.h5"), R"("hits": 1)");
  for (const char* extension : {".json", ".csv", ".h5"}) {
    rejection_of({"analyze", file("bat.h5"), "-o", file("none") + "/out" + extension}, {}, file("none"));
    rejection_of({"frf", file("bat.h5"), "-o", file("none") + "/out" + extension}, {}, file("none"));
  }
  const auto look_only =
      fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec;
  fs::permissions(file("bat.h5"), fs::perms::all);
  fs::permissions(folder_.path(), look_only);
  rejection_of({"analyze", file("bat.h5"), "-o", file("out.json")}, {}, file("out.json"), {.ordinary_user = true});
  fs::permissions(folder_.path(), fs::perms::all);
}

}  // namespace percuss::hostile_input_test
