#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/record.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::open_measurement_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kText = "t_s,force_N,acc_g\n0,1,2\n0.1,3,4\n0.2,5,6\n";

class OpenRecord : public testing::Test {
 protected:
  std::string file_with(const std::string& bytes, const std::string& name = "x.dat") const {
    test::write_bytes(folder_.file(name), bytes);
    return folder_.file(name);
  }
  std::string rejection_of(const std::string& bytes) const {
    const std::string path = file_with(bytes);
    std::string message = input_error_of([&] { open_record(path); });
    EXPECT_THAT(message, HasSubstr(path));
    return message;
  }
  test::ScratchFolder folder_;
};

/// Connects standard input to a file. The destructor restores it.
class StandardInput {
 public:
  explicit StandardInput(const std::string& path) : kept_(dup(STDIN_FILENO)) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    dup2(file, STDIN_FILENO);
    close(file);
  }
  ~StandardInput() {
    dup2(kept_, STDIN_FILENO);
    close(kept_);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  int kept_;
};

TEST_F(OpenRecord, GoesByContentNotByName) {
  const Record text = open_record(file_with(kText, "text.h5"));
  EXPECT_EQ(text.format, "CSV");
  EXPECT_EQ(text.files.at(0).path, folder_.file("text.h5"));
  EXPECT_EQ(text.files.at(0).bytes, std::string(kText).size());
  write_hdf5(folder_.file("r.csv"), record_in_memory(100, {{1, 2, 3}}, {{{4, 5, 6}}}), false);
  EXPECT_EQ(open_record(folder_.file("r.csv")).format, "HDF5");
}

TEST_F(OpenRecord, ReadsTextFromStandardInput) {
  const StandardInput input(file_with(kText));
  const Record record = open_record("-");
  EXPECT_EQ(record.files.at(0).path, "-");
  EXPECT_THAT(test::force_N(record), ElementsAre(1, 3, 5));
}

TEST_F(OpenRecord, ReadsALongTextFromStandardInput) {
  std::string text = "t_s,force_N,acc_g\n";
  for (int i = 0; i < 20000; ++i) text += std::to_string(0.001 * i) + ",1,2\n";
  const StandardInput input(file_with(text));
  EXPECT_EQ(open_record("-").rows.at(0).samples, 20000U);
}

TEST_F(OpenRecord, NamesStandardInputInErrors) {
  {
    const StandardInput input("/dev/zero");
    EXPECT_THAT(input_error_of([] { open_record("-"); }), HasSubstr("standard input"));
  }
  const StandardInput input(file_with("\x89HDF\r\n\x1a\n"));
  EXPECT_THAT(input_error_of([] { open_record("-"); }), HasSubstr("(standard input"));
}

TEST_F(OpenRecord, ReadsBinaryFormatsFromStandardInput) {
  write_hdf5(folder_.file("r.h5"), record_in_memory(100, {{1, 2, 3}}, {{{4, 5, 6}}}), false);
  const StandardInput input(folder_.file("r.h5"));
  const Record record = open_record("-");
  EXPECT_EQ(record.files.at(0).path, "-");
  EXPECT_THAT(test::force_N(record), ElementsAre(1, 2, 3));
}

TEST_F(OpenRecord, NamesFormatsThatItCannotRead) {
  EXPECT_THAT(rejection_of("TDSm\x0E"), HasSubstr("a TDMS file"));
  EXPECT_THAT(rejection_of("PK\x03\x04 rest"), HasSubstr("zip"));
}

TEST_F(OpenRecord, DetectsFilesByTheirFirstBytes) {
  EXPECT_THAT(rejection_of("MATLAB 5.0 MAT-file, Platform"), HasSubstr("the MAT file cannot be read"));
  EXPECT_THAT(rejection_of(std::string("\0\0\0\0\2\0\0\0\2\0\0\0\0\0\0\0\2\0\0\0a\0", 22)),
              HasSubstr("ends within a variable"));
  EXPECT_THAT(rejection_of("RIFF\x10\x01\x01\x01WAVEfmt "), HasSubstr("damaged: Error in WAV file"));
  EXPECT_THAT(rejection_of("    -1\n    58\n"), HasSubstr("data set 58 is not closed"));
}

TEST_F(OpenRecord, RefusesMissingAndIrregularFiles) {
  EXPECT_THAT(rejection_of(""), HasSubstr("empty"));
  EXPECT_THAT(input_error_of([&] { open_record(folder_.file("none.csv")); }), HasSubstr("no such file"));
  EXPECT_THAT(input_error_of([&] { open_record(folder_.path()); }), HasSubstr("folder"));
  EXPECT_THAT(input_error_of([] { open_record("/dev/zero"); }), HasSubstr("not a regular file"));
  EXPECT_THAT(input_error_of([] { open_record(""); }), HasSubstr("no such file"));
  // Opening a pipe without a writer would wait for ever.
  ASSERT_EQ(mkfifo(folder_.file("pipe").c_str(), 0600), 0);
  EXPECT_THAT(input_error_of([&] { open_record(folder_.file("pipe")); }), HasSubstr("not a regular file"));
}

TEST_F(OpenRecord, ReportsMissingPermission) {
  const std::string path = file_with(kText);
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  if (geteuid() == 0) {
    EXPECT_EQ(open_record(path).format, "CSV");  // root may read everything
  } else {
    EXPECT_THAT(input_error_of([&] { open_record(path); }), HasSubstr("permission"));
  }
}

TEST_F(OpenRecord, RefusesAHugeFileOfZerosByItsFirstBytes) {
  const std::string path = file_with("x");
  ASSERT_EQ(truncate(path.c_str(), off_t{1} << 36), 0);
  EXPECT_THAT(input_error_of([&] { open_record(path); }), HasSubstr("neither text"));
}

}  // namespace percuss::acquire::open_measurement_test
