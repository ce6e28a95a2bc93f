#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "acquire/formats/uff/uff_file.hpp"
#include "support/csv_text.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/synthetic_files.hpp"

namespace percuss::report::modes_uff_test {

using test::csv_bytes;
using test::run_percuss;

std::vector<std::string_view> lines_of_set(const acquire::UffSet& set) {
  std::vector<std::string_view> lines;
  for (std::string_view rest = set.text; !rest.empty();) lines.push_back(acquire::take_uff_line(rest));
  return lines;
}

std::vector<double> numbers_in(std::string_view line) {
  std::vector<double> out;
  for (acquire::UffFields fields(line); !fields.blank();) out.push_back(fields.number(13).value());
  return out;
}

// The small test has a bending mode at 200 Hz (1 % damping, residues in the ratio 0.9 to 0.3 at the two sensors) and a
// hoop mode at 700 Hz (0.5 %).
TEST(ModesUff, ContainsEachModeAs55AndAs2414) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  const auto outcome =
      run_percuss({"analyze", folder.file("bat.h5"), "--band", "60:1000", "-o", folder.file("modes.uff")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const FileBytes bytes = csv_bytes(test::bytes_of(folder.file("modes.uff")));
  const auto sets = acquire::split_uff(bytes);
  ASSERT_EQ(sets.size(), 6U);
  EXPECT_EQ(sets[0].number, 151);
  EXPECT_EQ(sets[1].number, 164);
  const auto old = lines_of_set(sets[2]), now = lines_of_set(sets[3]);
  ASSERT_EQ(sets[2].number, 55);
  ASSERT_EQ(old.size(), 10U);
  EXPECT_EQ(old[5], "         1         3         2         8         5         3");
  EXPECT_EQ(old[6], "         2         6         1         1");
  constexpr double kFitted = 3e-4;  // relative, by the noise of the record and the six digits of a number: 5e-5
  constexpr double kFitted_Hz = 0.01;
  const double omega = 2 * std::numbers::pi * 200;
  const auto eigenvalue = numbers_in(old[7]);
  EXPECT_NEAR(eigenvalue[0] / (-0.01 * omega), 1, kFitted);
  EXPECT_NEAR(eigenvalue[1] / omega, 1, kFitted);
  EXPECT_EQ(old[8], "         1") << "point 0 is node 1";
  const auto shape = numbers_in(old[9]);
  ASSERT_EQ(shape.size(), 6U);
  EXPECT_EQ(shape[0], 0) << "nothing along the axis";
  EXPECT_NEAR(shape[2], 1, kFitted) << "the sensor at 0 degrees looks along y";
  EXPECT_NEAR(shape[4], 0.3 / 0.9, kFitted);
  ASSERT_EQ(sets[3].number, 2414);
  EXPECT_EQ(now[2], "         1") << "data at nodes";
  EXPECT_EQ(now[8], "         1         3         2         8         5         3");
  const auto record12 = numbers_in(now[11]);
  EXPECT_NEAR(record12[1], 200, kFitted_Hz);
  EXPECT_NEAR(record12[4] / 0.01, 1, kFitted);
  EXPECT_EQ(now.back(), old.back());
}

}  // namespace percuss::report::modes_uff_test
