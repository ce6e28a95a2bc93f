#include "acquire/format_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "core/io/input_file.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::format_registry_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kRounding = 1e-12;  // of one product and one quotient per number

Record small_record() { return record_in_memory(1000, {{0, 1, 2, 3}}, {{{4, 5, 6, 7}}}); }

FrfRecord small_frfs() {
  FrfRecord out;
  out.lines = lines_from_frequencies({1, 2, 3}, "here");
  out.accel.push_back({.name = "accel 1"});
  out.frfs.push_back({.point = 0, .channel = 0, .frf = {.value = {{1, 2}, {3, 4}, {5, 6}}}});
  return out;
}

const FileFormat& format_of_file(const std::string& path) {
  const std::string head = first_bytes(path, 65536);
  return detected_format({path, head});
}

class FormatRegistry : public testing::Test {
 protected:
  test::ScratchFolder folder_;
};

TEST_F(FormatRegistry, NamesEachFormatAndEachExtensionOnce) {
  std::set<std::string_view> names, extensions;
  for (const FileFormat* format : file_formats()) {
    EXPECT_TRUE(names.insert(format->name).second) << format->name;
    for (const std::string_view extension : format->extensions) {
      EXPECT_TRUE(extension.starts_with('.')) << extension;
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
    }
  }
}

TEST_F(FormatRegistry, WritesOnlyUnderAFormatsOwnExtensions) {
  for (const FileFormat* format : file_formats()) {
    const bool writes = format->write_record != nullptr || format->write_frfs != nullptr;
    EXPECT_EQ(writes, !format->written.empty()) << format->name;
    for (const std::string_view extension : format->written)
      EXPECT_THAT(format->extensions, testing::Contains(extension)) << format->name;
  }
}

TEST_F(FormatRegistry, ReadsBackEveryRecordThatItWrites) {
  for (const std::string& extension : record_extensions()) {
    const std::string path = folder_.file("r" + extension);
    write_record(path, small_record(), false);
    EXPECT_EQ(&format_of_file(path), written_format(path)) << extension;
    const ReadOptions channels{.force_channel = "1", .accel_channels = {"2"}};  // W64 stores no names of channels
    const Record read = extension == ".w64" ? open_record(path, channels) : open_record(path);
    EXPECT_EQ(read.fs_Hz, 1000) << extension;
    EXPECT_THAT(test::force_N(read), ElementsAre(0, 1, 2, 3)) << extension;
  }
}

TEST_F(FormatRegistry, ReadsBackARecordWithoutAForce) {
  const std::vector<std::vector<double>> channels{{4, 5, 6, 7}, {8, 9, 10, 12}};
  Record record = record_in_memory(1000, {{0, 0, 0, 0}}, {channels});
  record.has_force = false;
  for (const std::string& extension : record_extensions()) {
    const std::string path = folder_.file("r" + extension);
    write_record(path, record, false);
    ReadOptions options{.accel_channels = {}, .force_optional = true};
    if (extension == ".w64") options.accel_channels = {"1", "2"};
    const Record read = open_record(path, options);
    EXPECT_FALSE(read.has_force) << extension;
    EXPECT_EQ(read.fs_Hz, 1000) << extension;
    ASSERT_EQ(read.rows.size(), 1U) << extension;
    for (std::size_t channel = 0; channel < 2; ++channel)
      EXPECT_EQ(test::accel_mps2(read, channel), channels[channel]) << extension;
  }
}

TEST_F(FormatRegistry, ReadsBackEveryFrfThatItWrites) {
  for (const std::string& extension : frf_extensions()) {
    const std::string path = folder_.file("f" + extension);
    write_frfs(path, small_frfs(), FrfKind::mobility, false);
    EXPECT_EQ(&format_of_file(path), written_format(path)) << extension;
    const Measurement opened = open_measurement(path);
    ASSERT_TRUE(std::holds_alternative<FrfRecord>(opened)) << extension;
    const auto& read = std::get<FrfRecord>(opened);
    EXPECT_EQ(read.kind, FrfKind::mobility) << extension;
    const auto expected = small_frfs().frfs[0].frf.value;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_LE(std::abs(read.frfs.at(0).frf.value.at(k) - expected[k]), kRounding * std::abs(expected[k]))
          << extension;
    }
  }
}

TEST_F(FormatRegistry, DetectsTheContentWhateverTheExtension) {
  const std::string path = folder_.file("r.uff"), renamed = folder_.file("r.wav");
  write_record(path, small_record(), false);
  std::filesystem::rename(path, renamed);
  EXPECT_EQ(format_of_file(renamed).name, "UFF");
}

TEST_F(FormatRegistry, TakesUndetectedInputAsText) {
  EXPECT_EQ(file_formats().back()->name, "text");
  EXPECT_EQ(detected_format({"-", "anything"}).name, "text");
  EXPECT_EQ(detected_format({"-", ""}).name, "text");
}

// Level 7.3 is HDF5 behind 512 bytes that begin with "MATLAB".
TEST_F(FormatRegistry, DetectsMatBeforeTheHdf5WithinIt) {
  const std::string path = folder_.file("v73.mat");
  std::string bytes = "MATLAB 7.3 MAT-file";
  bytes.resize(512, ' ');
  std::ofstream(path, std::ios::binary) << bytes << "\x89HDF\r\n\x1a\n";
  EXPECT_EQ(format_of_file(path).name, "MAT");
}

TEST_F(FormatRegistry, WritesByTheExtensionInAnyLetterCase) {
  EXPECT_EQ(written_format("a.CSV"), written_format("a.csv"));
  EXPECT_NE(written_format("a.csv"), nullptr);
  EXPECT_EQ(written_format("a.lvm"), nullptr);
  EXPECT_EQ(written_format("a"), nullptr);
  EXPECT_TRUE(has_known_extension("a.LVM"));
  EXPECT_FALSE(has_known_extension("a.json"));
}

TEST_F(FormatRegistry, ListsTheExtensionsForANameThatItCannotWrite) {
  EXPECT_THAT(test::input_error_of([] { write_record("a.txt", small_record(), false); }), HasSubstr(".h5, .hdf5"));
  EXPECT_THAT(test::input_error_of([] { write_frfs("a.wav", small_frfs(), FrfKind::mobility, false); }),
              testing::AllOf(HasSubstr(".csv"), testing::Not(HasSubstr(".rf64"))));
}

TEST_F(FormatRegistry, ReportsTheGeometryThatFilesOfFrfsLose) {
  FrfRecord frfs = small_frfs();
  frfs.geometry = {{0, 0, 0}, {1, 0, 0}};
  frfs.trace_lines = {{0, 1}};
  EXPECT_THAT(losses_of("f.unv", frfs), IsEmpty());
  EXPECT_THAT(losses_of("f.h5", frfs), ElementsAre("the geometry", "the lines between points"));
  frfs.geometry.push_back({0, 1, 0});
  frfs.trace_faces = {{0, 1, 2}};
  EXPECT_THAT(losses_of("f.unv", frfs), IsEmpty());
  EXPECT_THAT(losses_of("f.h5", frfs),
              ElementsAre("the geometry", "the lines between points", "the faces between points"));
  frfs.geometry = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 2, 0}, {0, 1, 0}};
  frfs.trace_faces = {{0, 1, 2, 3, 4}};
  EXPECT_THAT(losses_of("f.unv", frfs), ElementsAre("the faces between points"));
  frfs.geometry = {{0.1, 90}, {0.2, 90}, {0.3, 90}, {0.4, 90}, {0.5, 90}};
  EXPECT_THAT(losses_of("f.unv", frfs), ElementsAre("the geometry (positions and angles instead of coordinates)",
                                                    "the lines between points", "the faces between points"));
}

TEST_F(FormatRegistry, ReportsDrivingPlaces) {
  Record record = small_record();
  FrfRecord frfs = small_frfs();
  record.driving = frfs.driving = {{.point = 0, .channel = 0}};
  for (const char* path : {"f.uff", "f.h5"}) {
    EXPECT_THAT(losses_of(path, record), Contains("which points were struck beside a sensor")) << path;
    EXPECT_THAT(losses_of(path, frfs), Contains("which points were struck beside a sensor")) << path;
  }
}

// "| HDF5 | .h5 .hdf5 .hdf | .h5 .hdf5 | read, written | yes |"
std::string table_row(const FileFormat& format) {
  const auto listed = [](std::span<const std::string_view> extensions) {
    std::string out;
    for (const std::string_view extension : extensions) out += (out.empty() ? "" : " ") + std::string(extension);
    return out.empty() ? std::string("-") : out;
  };
  return "| " + std::string(format.name) + " | " + listed(format.extensions) + " | " + listed(format.written) + " | " +
         (format.write_frfs != nullptr ? "read, written" : "-") + " | " + (format.sandboxed ? "yes" : "-") + " |";
}

TEST_F(FormatRegistry, IsTheTableOfTheDocumentation) {
  std::ifstream page(std::string(PERCUSS_SOURCE_DIR) + "/docs/reference/formats.md");
  std::vector<std::string> rows, expected;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (inside && !line.starts_with('|')) break;
    if (inside && !line.starts_with("|---")) rows.push_back(line);
    inside = inside || line.starts_with("| format |");
  }
  for (const FileFormat* format : file_formats()) expected.push_back(table_row(*format));
  EXPECT_EQ(rows, expected);
}

}  // namespace percuss::acquire::format_registry_test
