#include "report/text/frf_terminal_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files/synthetic_files.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::frf_terminal_plot_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Each mode's number stands at its frequency. The top row shows the peak of the hoop mode, and nothing beside it.
TEST(FrfTerminalPlot, ShowsThePeaksAboveTheirNumbers) {
  const pipeline::Analysis analysis(synth::synthesise(test::bending_and_hoop_spec()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  const auto rows = test::lines_of(frf_terminal_plot(analysis, 108));
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_THAT(rows[9], AllOf(HasSubstr("60 Hz"), HasSubstr("3.2 kHz")));
  EXPECT_THAT(rows[0], HasSubstr(" dB "));
  EXPECT_EQ(rows[8].find('1') - 8, 100 * (200 - 60) / (3200 - 60));
  const std::size_t hoop = rows[8].find('2') - 8;
  EXPECT_EQ(hoop, 100 * (1900 - 60) / (3200 - 60));
  const auto cell = [&](std::size_t row, std::size_t column) {
    return rows[row].substr(rows[row].size() - 300 + 3 * column, 3);  // three bytes a character
  };
  EXPECT_NE(cell(0, hoop), "\u2800");
  for (const std::size_t beside : {hoop - 20, hoop + 20}) EXPECT_EQ(cell(0, beside), "\u2800");
}

TEST(FrfTerminalPlot, IsEmptyWhenTooNarrow) {
  const pipeline::Analysis analysis(synth::synthesise(test::bending_and_hoop_spec()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  EXPECT_EQ(frf_terminal_plot(analysis, 40), "");
}

// This test has no terminal. .ci/shells tests the output on a terminal.
TEST(FrfTerminalPlot, AppearsOnTerminalsOnly) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  EXPECT_THAT(test::run_percuss({"analyze", folder.file("bat.h5")}).out, Not(HasSubstr("\xE2\xA0")));
}

}  // namespace percuss::report::frf_terminal_plot_test
