#include "acquire/record/trace_faces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::trace_faces_test {

using test::input_error_of;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(TraceFaces, ReturnFromATable) {
  const std::vector<TraceFace> faces{{0, 1, 2}, {3, 2, 1, 0}, {2, 3, 4, 1, 0}};
  const FaceTable table = face_table(faces);
  EXPECT_EQ(table.width, 5U);
  EXPECT_THAT(table.numbers, ElementsAre(0, 1, 2, -1, -1, 3, 2, 1, 0, -1, 2, 3, 4, 1, 0));
  EXPECT_EQ(trace_faces_of(table, 5, "x"), faces);
  EXPECT_THAT(face_table({}).numbers, IsEmpty());
  EXPECT_THAT(trace_faces_of({}, 5, "x"), IsEmpty());
  EXPECT_EQ(trace_faces_of({.width = 4, .numbers = {0, 1, 2, kNan}}, 3, "x"), (std::vector<TraceFace>{{0, 1, 2}}));
}

TEST(TraceFaces, MustHaveThreeCornersThatExist) {
  const auto problem = [](std::vector<double> row) {
    const std::size_t width = row.size();
    return input_error_of([&] { trace_faces_of({.width = width, .numbers = std::move(row)}, 4, "x"); });
  };
  EXPECT_THAT(problem({0, 1, 4}), HasSubstr("missing point"));
  EXPECT_THAT(problem({0, 1, 0.5}), HasSubstr("missing point"));
  EXPECT_THAT(problem({0, 1, -2}), HasSubstr("missing point"));
  EXPECT_THAT(problem({0, 1, -1}), HasSubstr("fewer than three corners"));
  EXPECT_THAT(problem({0, 1, -1, 2}), HasSubstr("after a missing one"));
  EXPECT_THAT(problem({0, 1, 2, kNan, 3}), HasSubstr("after a missing one"));
}

class TraceFaceFiles : public testing::Test {
 protected:
  TraceFaceFiles() {
    record_.geometry = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    record_.trace_faces = {{0, 1, 2}, {0, 1, 2, 3}};
  }
  Record record_ = record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
  test::ScratchFolder folder_;
};

TEST_F(TraceFaceFiles, AreKeptByEveryFormatThatHoldsThem) {
  for (const char* extension : {".h5", ".mat", ".uff"}) {
    const std::string path = folder_.file(std::string("r") + extension),
                      again = folder_.file(std::string("s") + extension);
    write_record(path, record_, false);
    const Record read = open_record(path);
    EXPECT_EQ(read.trace_faces, record_.trace_faces) << extension;
    EXPECT_EQ(open_record(path, {.sandboxed = true}).trace_faces, record_.trace_faces) << extension;
    write_record(again, read, false);
    EXPECT_EQ(open_record(again).trace_faces, record_.trace_faces) << extension;
    EXPECT_THAT(losses_of(path, record_), Not(Contains(HasSubstr("faces")))) << extension;
  }
  for (const char* path : {"r.csv", "r.wav"})
    EXPECT_THAT(losses_of(path, record_), Contains("the faces between points")) << path;
}

TEST_F(TraceFaceFiles, AreNamedWhereAUniversalFileLosesThem) {
  const std::string path = folder_.file("r.uff"),
                    part = "faces without three or four corners, or with a corner without coordinates";
  record_.geometry.push_back({0.5, 2, 0});
  record_.geometry.push_back({kNan, kNan, kNan});
  for (const TraceFace& lost : {TraceFace{0, 1, 2, 4, 3}, TraceFace{0, 1, 5}}) {
    Record record = record_;
    record.trace_faces.push_back(lost);
    EXPECT_THAT(losses_of(path, record), Contains(part));
    record.trace_faces = {lost};
    EXPECT_THAT(losses_of(path, record), Contains("the faces between points"));
    write_record(path, record, true);
    EXPECT_THAT(open_record(path).trace_faces, IsEmpty());
    EXPECT_THAT(losses_of("r.h5", record), Not(Contains(HasSubstr("faces"))));
  }
}

TEST_F(TraceFaceFiles, AreRefusedUnlessTheyConnectExistingPoints) {
  const auto refusal = [&](const std::vector<hsize_t>& shape, const std::vector<double>& numbers) {
    test::Hdf5Builder(folder_.file("bad.h5"))
        .numbers("", "fs", {1000})
        .ramp("force", {1, 8})
        .ramp("accel", {1, 1, 8})
        .ramp("geometry", {4, 3})
        .values("trace_faces", shape, numbers);
    return input_error_of([&] { open_record(folder_.file("bad.h5")); });
  };
  EXPECT_THAT(refusal({1, 3}, {0, 1, 4}), HasSubstr("bad.h5: /trace_faces"));
  EXPECT_THAT(refusal({1, 2}, {0, 1}), HasSubstr("shape [1, 2]"));
}

}  // namespace percuss::acquire::trace_faces_test
