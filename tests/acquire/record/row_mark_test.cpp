#include "acquire/record/row_mark.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/hits/hits.hpp"
#include "acquire/write_record.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::row_mark_test {

Record marked_record() {
  std::vector<double> force(1000), accel(1000);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = accel[i] = i % 2 == 0 ? 0.01 : -0.01;
  for (std::size_t i = 0; i < 20; ++i)
    force[200 + i] += 100 * std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / 20);
  Record record = record_in_memory(10'000, {3, force}, {3, {accel}});
  record.rows[1].mark = RowMark::undone;
  record.faults = {{.kind = FaultKind::gap, .row = 2, .time_s = 1.25, .value = 200},
                   {.kind = FaultKind::unplugged, .row = -1, .time_s = 9.5}};
  return record;
}

TEST(RowMarks, HaveNumbersNamesAndReasons) {
  std::set<std::string> names, reasons;
  for (int number = 0; number <= 15; ++number) {
    const auto mark = row_mark(number);
    ASSERT_TRUE(mark.has_value()) << number;
    EXPECT_EQ(static_cast<int>(*mark), number);
    EXPECT_EQ(row_mark_named(name_of(*mark)), mark);
    names.insert(name_of(*mark));
    reasons.insert(reason_of(*mark));
  }
  EXPECT_EQ(names.size(), 16U);
  EXPECT_EQ(reasons.size(), 16U);
  for (const double wrong : {-1.0, 0.5, 16.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(row_mark(wrong).has_value()) << wrong;
}

TEST(RecordFaults, AreReadFromFourNumbers) {
  using Numbers = std::array<double, 4>;
  EXPECT_EQ(record_fault(Numbers{1, 2, 0.5, 200}, 3),
            (RecordFault{.kind = FaultKind::gap, .row = 2, .time_s = 0.5, .value = 200}));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Numbers& wrong :
       {Numbers{0, 0, 0, 0}, Numbers{11, 0, 0, 0}, Numbers{1.5, 0, 0, 0}, Numbers{1, 3, 0, 0}, Numbers{1, -2, 0, 0},
        Numbers{1, 0.5, 0, 0}, Numbers{1, 0, kNan, 0}, Numbers{1, 0, 0, kNan}, Numbers{kNan, 0, 0, 0}})
    EXPECT_FALSE(record_fault(wrong, 3).has_value()) << wrong[0] << " " << wrong[1];
}

TEST(RowMarks, AreStoredInHdf5AndReadAgain) {
  const test::ScratchFolder folder;
  const Record written = marked_record();
  write_hdf5(folder.file("a.h5"), written, false);
  const Record read = open_hdf5(folder.file("a.h5"), {});
  ASSERT_EQ(read.rows.size(), 3U);
  for (std::size_t row = 0; row < 3; ++row) EXPECT_EQ(read.rows[row].mark, written.rows[row].mark);
  EXPECT_EQ(read.faults, written.faults);
  EXPECT_TRUE(read.notes.empty());
}

TEST(RowMarks, AreAbsentFromFilesWithoutThem) {
  const test::ScratchFolder folder;
  Record record = marked_record();
  record.rows[1].mark = RowMark::none;
  record.faults.clear();
  write_hdf5(folder.file("a.h5"), record, false);
  const std::string bytes = test::bytes_of(folder.file("a.h5"));
  EXPECT_EQ(bytes.find("rejected"), std::string::npos);
  EXPECT_EQ(bytes.find("faults"), std::string::npos);
}

TEST(RowMarks, AreRefusedIfUnknown) {
  const test::ScratchFolder folder;
  const auto open = [&](const std::vector<double>& rejected, const std::vector<hsize_t>& shape,
                        const std::vector<double>& faults) {
    {
      test::Hdf5Builder file(folder.file("a.h5"));
      file.numbers("", "fs", {1000}).ramp("force", {2, 64}).ramp("accel", {2, 1, 64});
      file.values("rejected", {rejected.size()}, rejected).values("faults", shape, faults);
    }
    return open_hdf5(folder.file("a.h5"), {});
  };
  EXPECT_EQ(open({0, 3}, {1, 4}, {1, 0, 0, 5}).rows[1].mark, RowMark::response_overload);
  const auto error = [&](auto... values) { return test::input_error_of([&] { open(values...); }); };
  using List = std::vector<double>;
  using Shape = std::vector<hsize_t>;
  EXPECT_NE(error(List{0, 16}, Shape{1, 4}, List{1, 0, 0, 5}).find("16 is not the number of a reason"),
            std::string::npos);
  EXPECT_NE(error(List{0, 0, 0}, Shape{1, 4}, List{1, 0, 0, 5}).find("/rejected"), std::string::npos);
  EXPECT_NE(error(List{0, 0}, Shape{2, 2}, List{1, 0, 0, 5}).find("store [faults, 4]"), std::string::npos);
  EXPECT_NE(error(List{0, 0}, Shape{1, 4}, List{1, 2, 0, 5}).find("/faults"), std::string::npos);
}

TEST(RowMarks, RejectTheirHits) {
  const auto hits = find_hits(marked_record());
  ASSERT_EQ(hits.size(), 3U);
  EXPECT_FALSE(rejects(hits[0].findings));
  ASSERT_TRUE(rejects(hits[1].findings));
  EXPECT_EQ(hits[1].findings.back().code, FindingCode::rejected_live);
  EXPECT_EQ(hits[1].findings.back().message, "rejected while it was recorded: undone by the operator");
}

TEST(RowMarks, FollowTheirRows) {
  const Record record = marked_record();
  const Record last = select_rows(record, [n = 0](const RowInfo&) mutable { return n++ > 0; });
  ASSERT_EQ(last.rows.size(), 2U);
  EXPECT_EQ(last.rows[0].mark, RowMark::undone);
  EXPECT_EQ(last.faults[0].row, 1);
  EXPECT_EQ(last.faults[1].row, -1);
  const Record joined = join_records({record, record}, FileGrouping::hits);
  EXPECT_EQ(joined.rows[4].mark, RowMark::undone);
  ASSERT_EQ(joined.faults.size(), 4U);
  EXPECT_EQ(joined.faults[2].row, 5);
}

TEST(RowMarks, AreNamedWhereAFormatLosesThem) {
  const auto losses = losses_of("a.csv", marked_record());
  const auto lost = [&](const char* part) { return std::find(losses.begin(), losses.end(), part) != losses.end(); };
  EXPECT_TRUE(lost("which blows were rejected while they were recorded"));
  EXPECT_TRUE(lost("the faults of the capture"));
  for (const std::string& loss : losses_of("a.h5", marked_record()))
    EXPECT_EQ(loss.find("rejected"), std::string::npos);
}

}  // namespace percuss::acquire::row_mark_test
