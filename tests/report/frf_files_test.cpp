#include "report/frf_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "acquire/write_record.hpp"
#include "support/input_error.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::frf_files_test {

using test::lines_of;
using testing::HasSubstr;

/// Two channels; `hits` hits on each of `points` points.
pipeline::Analysis analysis_of(std::size_t hits, std::size_t points = 1) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 0.5);
  spec.hits = hits;
  spec.points.resize(points, spec.points.front());
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return {synth::synthesise(spec).record, {.band_Hz = std::pair{100.0, 400.0}, .threads = 1}};
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line + ",");
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST(FrfCsv, NamesKindUnitAndColumns) {
  const auto lines = lines_of(frf_csv(analysis_of(2, 2), acquire::FrfKind::mobility));
  EXPECT_EQ(lines.at(0), "# mobility (m/s)/N, H1, exp(+jwt), angle_deg 0 90, averages 2");
  const auto names = cells_of(lines.at(1));
  ASSERT_EQ(names.size(), 1U + 4U * 4U);
  EXPECT_EQ(names[0], "frequency_hz");
  EXPECT_EQ(names[1], "p0_c0_re");
  EXPECT_EQ(names[8], "p0_c1_coherence");
  EXPECT_EQ(names[16], "p1_c1_coherence");
}

TEST(FrfCsv, ContainsTheBandsLinesToTheLastDigit) {
  const pipeline::Analysis analysis = analysis_of(3);
  const auto lines = lines_of(frf_csv(analysis, acquire::FrfKind::accelerance));
  const acquire::LineRange& range = analysis.lines();
  std::size_t row = 2;
  for (std::size_t k = 0; k < range.count; ++k) {
    if (range.freq_Hz(k) < 100 - 1e-6 || range.freq_Hz(k) > 400 + 1e-6) continue;
    const auto cells = cells_of(lines.at(row++));
    EXPECT_EQ(std::stod(cells[0]), range.freq_Hz(k));
    for (std::size_t c = 0; c < 2; ++c) {
      const acquire::Frf& frf = analysis.frfs()[c].frf;
      EXPECT_EQ(std::stod(cells[1 + 4 * c]), frf.value[k].real());
      EXPECT_EQ(std::stod(cells[2 + 4 * c]), frf.value[k].imag());
      EXPECT_EQ(std::stod(cells[3 + 4 * c]), frf.std[k]);
      EXPECT_EQ(std::stod(cells[4 + 4 * c]), frf.coherence[k]);
    }
  }
  EXPECT_EQ(row, lines.size());
}

TEST(FrfCsv, LeavesDeviationAndCoherenceOfASingleHitEmpty) {
  const auto cells = cells_of(lines_of(frf_csv(analysis_of(1), acquire::FrfKind::accelerance)).at(5));
  ASSERT_EQ(cells.size(), 9U);
  for (const std::size_t c : {3U, 4U, 7U, 8U}) EXPECT_EQ(cells[c], "") << c;
}

TEST(FrfCsv, DividesByTheCircularFrequencyForMobilityAndReceptance) {
  const pipeline::Analysis analysis = analysis_of(2);
  const auto at = [&](acquire::FrfKind kind) {
    const auto cells = cells_of(lines_of(frf_csv(analysis, kind)).at(20));
    return std::pair{std::stod(cells[0]), std::hypot(std::stod(cells[1]), std::stod(cells[2]))};
  };
  const auto [freq_Hz, accelerance] = at(acquire::FrfKind::accelerance);
  const double omega = 2 * std::acos(-1.0) * freq_Hz;
  EXPECT_NEAR(at(acquire::FrfKind::mobility).second * omega / accelerance, 1, 1e-12);
  EXPECT_NEAR(at(acquire::FrfKind::receptance).second * omega * omega / accelerance, 1, 1e-12);
}

TEST(WriteFrfCsv, ReplacesAFileOnlyWhenForced) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("frf.csv");
  const pipeline::Analysis analysis = analysis_of(2);
  test::write_bytes(path, "mine");
  const acquire::FrfRecord record = frf_record_of(analysis);
  EXPECT_THAT(test::input_error_of([&] { acquire::write_frfs(path, record, acquire::FrfKind::accelerance, false); }),
              HasSubstr("frf.csv"));
  EXPECT_EQ(test::bytes_of(path), "mine");
  acquire::write_frfs(path, record, acquire::FrfKind::accelerance, true);
  EXPECT_EQ(test::bytes_of(path), frf_csv(analysis, acquire::FrfKind::accelerance));
}

}  // namespace percuss::report::frf_files_test
