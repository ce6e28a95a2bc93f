#include "acquire/record/stated_date.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::stated_date_test {

using testing::Contains;
using testing::Not;

TEST(StatedDate, IsTheThirdLineOfADataSet58) {
  EXPECT_EQ(stated_date("    -1\n    58\nhit 1\nNONE\n20-NOV-26 14:03:22\nNONE\nNONE\n    1  0\n"),
            "20-NOV-26 14:03:22");
  EXPECT_EQ(stated_date("    -1\r\n    58b     1     2\r\na\r\nb\r\n20-NOV-26\r\n"), "20-NOV-26");
  EXPECT_EQ(stated_date("    -1\n    58\nhit 1\nNONE\nNONE\nNONE\n"), "");
}

TEST(StatedDate, IsInTheHeadOfAText) {
  EXPECT_EQ(stated_date("# Date: 2026-11-20\n# operator: x\ntime,force\n0,1\n"), "2026-11-20");
  EXPECT_EQ(stated_date("\"Test date\",\"20.11.2026\"\n"), "20.11.2026");
  EXPECT_EQ(stated_date("LabVIEW Measurement\nDate\t2026/11/20\nTime\t14:03:22,123\n"), "2026/11/20 14:03:22");
  EXPECT_EQ(stated_date("\"Test Date\",\"2026/04/09\",\"15:54:47\"\n"), "2026/04/09 15:54:47");
  EXPECT_EQ(stated_date("Test Date,4/9/2026,15:46:59\n"), "4/9/2026 15:46:59");
  EXPECT_EQ(stated_date("time_s,force_N\n0,1\n"), "");
  EXPECT_EQ(stated_date("update: 2026\n"), "") << "another word";
}

TEST(StatedDate, IsInGermanTextsToo) {
  for (const char* const line :
       {"Datum;14.03.2026", "Messdatum;14.03.2026", "Aufnahmedatum: 14.03.2026",
        "\"Aufzeichnungsdatum\",\"14.03.2026\"",
        "# Pr\xC3\xBC"
        "fdatum = 14.03.2026",
        "Pr\xFC"
        "fdatum\t14.03.2026",
        "Datum der Messung: 14.03.2026", "DATUM;;14.03.2026;;", "Gemessen am: Samstag, 14.03.2026"})
    EXPECT_EQ(stated_date("Messung;Rahmen\n" + std::string(line) + "\nZeit [s];Hammer [N]\n0,1;2\n"), "14.03.2026")
        << line;
  EXPECT_EQ(stated_date("\xEF\xBB\xBF"
                        "Datum;14.03.2026\n"),
            "14.03.2026")
      << "a byte-order mark";
  EXPECT_EQ(stated_date("Datum;14.03.2026 09:12:05\nZeit [s];Hammer [N]\n"), "14.03.2026 09:12:05");
  EXPECT_EQ(stated_date("Datum;14.03.2026\nUhrzeit;09:12:05,250\n"), "14.03.2026 09:12:05");
  EXPECT_EQ(stated_date("Datum/Uhrzeit;14.03.2026;09:12:05;Temperatur;21,5\n"), "14.03.2026 09:12:05");
  EXPECT_EQ(stated_date("Startzeit: 3. M\xC3\xA4rz 2026, 09:12 Uhr\n"), "3. Maerz 2026 09:12");
}

TEST(StatedDate, IsTheTimeOfTheStart) {
  EXPECT_EQ(stated_date("Start time,2026-03-14T09:12:05.125Z\n"), "2026-03-14 09:12:05Z");
  EXPECT_EQ(stated_date("start_time: 2026-03-14 09:12:05+01:00\n"), "2026-03-14 09:12:05+01:00");
  EXPECT_EQ(stated_date("Timestamp;3/14/2026 9:12:05 PM\n"), "3/14/2026 9:12:05 PM");
  EXPECT_EQ(stated_date("Recorded on: 14 Mar 2026\n"), "14 Mar 2026");
}

// Words such as Datum or Start time may also precede names of columns, durations or numbers; only a calendar date
// counts.
TEST(StatedDate, IsACalendarDateAfterOtherWords) {
  for (const char* const other :
       {"Datum;Uhrzeit;Kanal 1;Kanal 2;Kanal 3\n", "Startzeit;09:12:05\n", "Start time,09:12:05.250\n",
        "Measurement time: 1.0000 s\n", "Timestamp,1773479525\n", "Kalibrierdatum;14.03.2026\n",
        "Datum der Kalibrierung;14.03.2026\n", "Exportdatum;14.03.2026\n", "Datum;siehe 12.3\n"})
    EXPECT_EQ(stated_date(other), "") << other;
  EXPECT_EQ(stated_date("Timestamp,2026-03-20\nTest date,2026-03-14\n"), "2026-03-14");
  EXPECT_EQ(stated_date("Kalibrierdatum;01.02.2025\nMessdatum;14.03.2026\n"), "14.03.2026");
}

TEST(StatedDate, IsThatOfTheTest) {
  EXPECT_EQ(stated_date("Calibration date: 2023-05-01\nDate: 2024-03-12\n"), "2024-03-12");
  EXPECT_EQ(stated_date("Date of measurement: 2024-03-12\n"), "2024-03-12");
  EXPECT_EQ(stated_date("Date/Time;03/12/2024 10:11:12 AM\n"), "03/12/2024 10:11:12 AM");
  for (const char* const other : {"Date of calibration,2023-05-01\n", "Export date,2024-06-01\n",
                                  "# Last date of service 2020-01-01\n", "Calibration_date,2023-05-01\n"})
    EXPECT_EQ(stated_date(other), "") << other;
}

// The header states when the file was written. An old test may have been exported today.
TEST(StatedDate, IsNotInTheHeaderOfAMatFile) {
  EXPECT_EQ(stated_date("MATLAB 5.0 MAT-file, Platform: GLNXA64, Created on: Fri Nov 20 14:03:22 2026      "), "");
}

TEST(StatedDate, IsInTheChunksOfASoundFile) {
  const std::string head("RIFF\0\0\0\0WAVE", 12);
  EXPECT_EQ(stated_date(head + std::string("LIST\x16\0\0\0INFOICRD\x0A\0\0\0", 20) + "2026-11-20"), "2026-11-20");
  EXPECT_EQ(stated_date(head + std::string("LIST\x17\0\0\0INFOICRD\x0B\0\0\0", 20) + std::string("2026-11-20\0", 11)),
            "2026-11-20");
  std::string bext(602, '\0');
  bext.replace(320, 18, "2026-11-2014:03:22");
  EXPECT_EQ(stated_date(head + std::string("bext\x5A\x02\0\0", 8) + bext), "2026-11-20 14:03:22");
  EXPECT_EQ(stated_date(head + std::string("LIST\xFF\xFF\xFF\xFFINFOICRD\xFF\xFF\xFF\xFF", 20)), "");
}

TEST(StatedDate, IsEmptyForControlCharactersLongTextsAndUnreadableFiles) {
  EXPECT_EQ(stated_date("Date: \x1b[31m2026\n"), "");
  EXPECT_EQ(stated_date("Date: " + std::string(100, '1') + "\n"), "");
  EXPECT_EQ(stated_date_of_file("-"), "");
  EXPECT_EQ(stated_date_of_file("/nowhere/at/all"), "");
}

TEST(StatedDate, IsKeptInHdf5) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("dated.h5");
  Record record = record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
  const auto date_read = [&](bool sandboxed) {
    write_record(path, record, true);
    return date_of(open_record(path, {.sandboxed = sandboxed}).files.front());
  };
  EXPECT_EQ(date_read(false), "");
  record.files = {{.path = "none.csv", .date = "2026-11-20 14:03"}, {.path = "other.csv", .date = "2026-11-20 14:03"}};
  EXPECT_EQ(date_read(false), "2026-11-20 14:03");
  EXPECT_EQ(date_read(true), "2026-11-20 14:03");
  record.files.back().date = "2026-11-21";
  EXPECT_EQ(date_read(false), "") << "two dates";
}

TEST(StatedDate, IsNamedAsALossWhereTheFormatHasNoPlaceForIt) {
  constexpr const char* kLoss = "the date of the test";
  Record record = record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
  const auto formats = {"a.csv", "a.mat", "a.uff", "a.wav", "a.w64"};
  for (const char* path : formats) EXPECT_THAT(losses_of(path, record), Not(Contains(kLoss))) << path;
  record.files = {{.path = "none.csv", .date = "2026-11-20 14:03"}};
  for (const char* path : formats) EXPECT_THAT(losses_of(path, record), Contains(kLoss)) << path;
  EXPECT_THAT(losses_of("a.h5", record), Not(Contains(kLoss)));
  record.files.push_back({.path = "other.csv", .date = "2026-11-21"});
  EXPECT_THAT(losses_of("a.csv", record), Not(Contains(kLoss))) << "two dates";
}

TEST(StatedDate, OfHdf5IsATextThatCanBeADate) {
  const test::ScratchFolder folder;
  const auto date_with = [&](const char* name, const std::string& text) {
    test::Hdf5Builder(folder.file("a.h5"))
        .numbers("", "fs", {1000})
        .ramp("force", {1, 8})
        .ramp("accel", {1, 1, 8})
        .text("", name, text);
    return open_record(folder.file("a.h5")).files.front().date;
  };
  EXPECT_EQ(date_with("date", "20.11.2026"), "20.11.2026");
  EXPECT_EQ(date_with("start_time", "2026-11-20T14:03:22Z"), "2026-11-20T14:03:22Z");
  EXPECT_EQ(date_with("date", "soon"), "");
  EXPECT_EQ(date_with("title", "2026-11-20"), "");
  test::Hdf5Builder(folder.file("a.h5"))
      .numbers("", "fs", {1000})
      .numbers("", "timestamp", {1.7e9})
      .ramp("force", {1, 8})
      .ramp("accel", {1, 1, 8});
  EXPECT_EQ(open_record(folder.file("a.h5")).files.front().date, "") << "a number";
}

}  // namespace percuss::acquire::stated_date_test
