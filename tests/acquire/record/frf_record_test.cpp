#include "acquire/record/frf_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/units.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::frf_record_test {

using testing::HasSubstr;
using testing::SizeIs;

// Two channels, one point, lines at 0, 1, 2 Hz.
FrfRecord small_frfs() {
  FrfRecord out;
  out.files = {{.path = "x.csv"}};
  out.lines = lines_from_frequencies({0, 1, 2}, "x.csv");
  out.notes = {"assumed"};
  for (std::size_t c = 0; c < 2; ++c) {
    out.accel.push_back({.name = "accel " + std::to_string(c + 1)});
    out.frfs.push_back({.point = 0, .channel = c, .frf = {.value = std::vector<Complex>(3, Complex(1, 0))}});
  }
  return out;
}

TEST(JoinFrfs, MakesEveryFileAPoint) {
  std::vector<FrfRecord> files(3, small_frfs());
  const FrfRecord all = join_frfs(files);
  ASSERT_THAT(all.frfs, SizeIs(6));
  EXPECT_EQ(all.frfs[5].point, 2);
  EXPECT_EQ(all.frfs[5].channel, 1U);
  EXPECT_THAT(all.notes, SizeIs(1)) << "a note on every file is given once";
  EXPECT_THAT(all.files, SizeIs(3));
}

TEST(JoinFrfs, NamesTheFileThatANoteConcerns) {
  std::vector<FrfRecord> files(3, small_frfs());
  files[0].notes.emplace_back("only here");
  EXPECT_THAT(join_frfs(files).notes, testing::ElementsAre(Message("assumed"), Message("x.csv: only here")));
}

TEST(JoinFrfs, RefusesPointNumbersThatBecomeTooLarge) {
  FrfRecord far = small_frfs(), other = small_frfs();
  for (PointFrf& frf : far.frfs) frf.point = 1'000'000'000;
  other.files[0].path = "other.csv";
  EXPECT_THAT(test::input_error_of([&] {
                join_frfs({far, other});
              }),
              HasSubstr("1000000001 is not a point number (other.csv)"));
}

TEST(JoinFrfs, RefusesNoFiles) {
  EXPECT_THAT(test::input_error_of([] { join_frfs({}); }), HasSubstr("nothing to join"));
}

TEST(JoinFrfs, RefusesOtherLinesAndNamesTheFile) {
  const FrfRecord first = small_frfs();
  FrfRecord other = first;
  other.files[0].path = "other.csv";
  other.lines = lines_from_frequencies({0, 2, 4}, "other.csv");
  EXPECT_THAT(test::input_error_of([&] { join_frfs({first, other}); }), HasSubstr("other.csv"));
}

// Under the window exp(−σt) the responses over force lie at s = jω + σ: velocity and displacement are accelerance/s and
// accelerance/s², whatever the accelerance.
TEST(WithExponentialWindow, TurnsEachKindIntoTheAccelerance) {
  constexpr double kDecay_per_s = 9, kRounding = 1e-12;
  const std::vector<Complex> accelerance{{3, 1}, {-2, 5}, {0.5, -4}};
  for (const FrfKind kind : {FrfKind::accelerance, FrfKind::mobility, FrfKind::receptance}) {
    FrfRecord read = small_frfs();
    read.kind = kind;
    const double power = kind == FrfKind::accelerance ? 0 : kind == FrfKind::mobility ? 1 : 2;
    for (PointFrf& one : read.frfs) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Complex s(kDecay_per_s, kTwoPi * read.lines.freq_Hz(k)), undamped(0, kTwoPi * read.lines.freq_Hz(k));
        const Complex stored = accelerance[k] / std::pow(s, power);
        // As to_accelerances() reads it, without knowing the window.
        one.frf.value[k] = power > 0 ? stored * std::pow(undamped, power) : stored;
        one.frf.std.push_back(0.1 * std::abs(one.frf.value[k]));
      }
    }
    const FrfRecord windowed = with_exponential_window(read, kDecay_per_s);
    EXPECT_EQ(windowed.decay_per_s, kDecay_per_s);
    const std::size_t left_out = power > 0 ? 1 : 0;
    EXPECT_EQ(windowed.lines.first, left_out) << "a mobility at 0 Hz was multiplied by 0";
    ASSERT_EQ(windowed.lines.count, 3 - left_out);
    for (const PointFrf& one : windowed.frfs) {
      ASSERT_THAT(one.frf.value, SizeIs(3 - left_out));
      for (std::size_t k = 0; k < one.frf.value.size(); ++k) {
        const Complex truth = accelerance[k + left_out];
        EXPECT_LE(std::abs(one.frf.value[k] - truth), kRounding * std::abs(truth));
        EXPECT_NEAR(one.frf.std[k], 0.1 * std::abs(truth), kRounding * std::abs(truth));
      }
    }
  }
}

TEST(WithExponentialWindow, RefusesAnotherWindowThanTheFileStates) {
  FrfRecord stated = small_frfs();
  stated.decay_per_s = 4.605;
  EXPECT_EQ(with_exponential_window(stated, 4.6).decay_per_s, 4.605) << "rounded to two digits";
  EXPECT_THAT(test::input_error_of([&] { with_exponential_window(stated, 9.21); }),
              HasSubstr("decays by 9.21 1/s contradicts the FRFs, which state 4.605 1/s"));
  EXPECT_THAT(test::options_of_error([&] { with_exponential_window(stated, 9.21); }),
              testing::ElementsAre("exponential"));
}

}  // namespace percuss::acquire::frf_record_test
