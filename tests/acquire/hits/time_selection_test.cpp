#include "acquire/hits/time_selection.hpp"

#include <gtest/gtest.h>

#include "support/force_row.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::time_selection_test {

using test::input_error_of;
using testing::HasSubstr;

const Record& record() {
  static const Record one = test::force_record(1000, {std::vector<double>(500), std::vector<double>(2000)});
  return one;
}

TEST(SelectTimeRange, IsTheWholeRowByDefault) {
  const SampleRange part = select_time_range(record(), 1, {});
  EXPECT_EQ(part.first, 0U);
  EXPECT_EQ(part.last, 2000U);
}

TEST(SelectTimeRange, EndsWithTheRow) {
  const SampleRange part = select_time_range(record(), 0, {.from_s = 0.25, .to_s = 1e300});
  EXPECT_EQ(part.first, 250U);
  EXPECT_EQ(part.last, 500U);
}

TEST(SelectTimeRange, RejectsEmptyRanges) {
  for (const HitOptions& options : {HitOptions{.from_s = 0.5}, HitOptions{.from_s = 0.3, .to_s = 0.3}}) {
    EXPECT_THAT(input_error_of([&] { select_time_range(record(), 0, options); }), HasSubstr("the row is 0.5 s long"));
    try {
      select_time_range(record(), 0, options);
    } catch (const InputError& error) {
      EXPECT_THAT(error.options(), testing::ElementsAre("from", "to"));
    }
  }
}

TEST(PretriggerSamples, AreFiveMillisecondsAndAtLeast128) {
  EXPECT_EQ(pretrigger_samples(record(), {}), 128U);
  EXPECT_EQ(pretrigger_samples(test::force_record(100000, {{0.0}}), {}), 500U);
  EXPECT_EQ(pretrigger_samples(record(), {.pretrigger_s = 0.02}), 20U);
}

TEST(SelectedLength, HasAtLeastTwoSamples) {
  EXPECT_EQ(selected_length(record(), {}), std::nullopt);
  EXPECT_EQ(selected_length(record(), {.length_s = 0.1}), 100U);
  EXPECT_THAT(input_error_of([] { selected_length(record(), {.length_s = 0.001}); }),
              HasSubstr("fewer than two samples at 1000 Hz (memory)"));
}

}  // namespace percuss::acquire::time_selection_test
