#include "acquire/channels/stored_frfs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"

namespace percuss::acquire::stored_frfs_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kRounding = 1e-12;

// Two channels, one point, lines at 0, 1, 2 Hz of value 1.
StoredFrfs stored(std::optional<FrfUnit> unit = FrfUnit{}) {
  StoredFrfs frfs;
  frfs.record.files = {{.path = "x.csv"}};
  frfs.record.lines = lines_from_frequencies({0, 1, 2}, "x.csv");
  for (std::size_t c = 0; c < 2; ++c) {
    frfs.record.accel.push_back({.name = "accel " + std::to_string(c + 1)});
    frfs.frfs.push_back({.channel = c, .value = std::vector<Complex>(3, Complex(1, 0))});
  }
  frfs.unit = unit;
  return frfs;
}

Complex line(const FrfRecord& record, std::size_t frf, std::size_t k) { return record.frfs.at(frf).frf.value.at(k); }

TEST(StoredFrfs, TurnsEveryKindIntoAnAccelerance) {
  const Complex s(0, kTwoPi * 2);
  EXPECT_EQ(line(to_accelerances(stored(), {}), 0, 2), Complex(1, 0));
  const auto mobility = to_accelerances(stored(FrfUnit{.kind = FrfKind::mobility}), {});
  EXPECT_LE(std::abs(line(mobility, 0, 2) - s), kRounding * std::abs(s));
  const auto receptance = to_accelerances(stored(FrfUnit{.kind = FrfKind::receptance}), {});
  EXPECT_LE(std::abs(line(receptance, 0, 2) - s * s), kRounding * std::norm(s));
  EXPECT_EQ(line(receptance, 0, 0), Complex(0, 0));
}

// The normalised random error of H1, √2 √((1 − γ²)/(2 γ² n)) of the complex number, with n − 1 degrees of freedom.
TEST(StoredFrfs, TakesTheStandardDeviationFromCoherenceAndAverages) {
  StoredFrfs frfs = stored();
  frfs.frfs[0].coherence = {0.5, 0.8, 1};
  frfs.frfs[0].averages = 5;
  frfs.frfs[1].coherence = frfs.frfs[0].coherence;  // of an unknown number of averages
  const FrfRecord record = to_accelerances(frfs, {.read = {.accel_unit = "mm/s^2"}});
  ASSERT_THAT(record.frfs[0].frf.std, SizeIs(3));
  EXPECT_NEAR(record.frfs[0].frf.std[0], 1e-3 * std::sqrt(1.0 / 4), kRounding);
  EXPECT_NEAR(record.frfs[0].frf.std[1], 1e-3 * std::sqrt(0.25 / 4), kRounding);
  EXPECT_EQ(record.frfs[0].frf.std[2], 0);
  EXPECT_THAT(record.frfs[1].frf.std, IsEmpty());
  frfs.frfs[0].std = {1, 2, 3};
  EXPECT_EQ(to_accelerances(frfs, {}).frfs[0].frf.std, (std::vector<double>{1, 2, 3}));  // stated ones stay
}

TEST(StoredFrfs, TakesAStatedNumberOfAverages) {
  StoredFrfs frfs = stored();
  for (StoredFrf& frf : frfs.frfs) frf.coherence = {0.5, 0.8, 1};
  const FrfRecord record = to_accelerances(frfs, {.averages = 5});
  for (const PointFrf& one : record.frfs) {
    EXPECT_EQ(one.frf.averages, 5U);
    ASSERT_THAT(one.frf.std, SizeIs(3));
    EXPECT_NEAR(one.frf.std[0], std::sqrt(1.0 / 4), kRounding);
    EXPECT_NEAR(one.frf.std[1], std::sqrt(0.25 / 4), kRounding);
  }
  EXPECT_THAT(record.notes, IsEmpty());
  frfs.frfs[0].averages = 5;
  EXPECT_EQ(to_accelerances(frfs, {.averages = 5}).frfs[0].frf.averages, 5U);
}

TEST(StoredFrfs, RefusesAveragesThatContradictTheFile) {
  StoredFrfs frfs = stored();
  frfs.frfs[1].averages = 4;
  const auto read = [&](std::size_t averages) { to_accelerances(frfs, {.averages = averages}); };
  EXPECT_THAT(test::input_error_of([&] { read(5); }), HasSubstr("of 5 contradicts the file, which states 4"));
  EXPECT_THAT(test::options_of_error([&] { read(5); }), testing::ElementsAre("averages"));
  EXPECT_NO_THROW(read(4));
  frfs.frfs[1].averages = 0;
  frfs.frfs[0].coherence = {1, 1, 1};
  EXPECT_NO_THROW(read(1));
  frfs.frfs[0].coherence = {1, 0.9, 1};
  EXPECT_THAT(test::input_error_of([&] { read(1); }), HasSubstr("1 average contradicts the coherence"));
}

TEST(StoredFrfs, NotesThatAveragesTellNothingWithoutACoherence) {
  StoredFrfs frfs = stored();
  EXPECT_THAT(test::texts(to_accelerances(frfs, {.averages = 3}).notes),
              testing::ElementsAre(HasSubstr("does not change the ±")));
  frfs.frfs[0].std = {1, 1, 1};
  EXPECT_THAT(to_accelerances(frfs, {.averages = 3}).notes, IsEmpty());
}

// The frequencies 0.333, 0.667 and 1.0 permit a spacing from 0.33325 to 0.3335 Hz.
TEST(StoredFrfs, TakesAStatedSpacingWithinTheRoundingOfTheFrequencies) {
  StoredFrfs frfs = stored();
  frfs.set_lines(frequency_lines({0.333, 0.667, 1}, 1, "x.csv"));
  const auto spacing_Hz = [&](double df_Hz) { return to_accelerances(frfs, {.read = {.df_Hz = df_Hz}}).lines.df_Hz(); };
  for (const double df_Hz : {0.33335, 1.0 / 3}) EXPECT_NEAR(spacing_Hz(df_Hz), df_Hz, kRounding);
  for (const double df_Hz : {0.334, 0.332, 0.6666, -1.0, std::nan("")}) {
    EXPECT_THAT(test::input_error_of([&] { spacing_Hz(df_Hz); }), HasSubstr("contradicts the frequencies of the file"));
    EXPECT_THAT(test::options_of_error([&] { spacing_Hz(df_Hz); }), testing::ElementsAre("df"));
  }
}

TEST(StoredFrfs, NotesRoundedFrequenciesUnlessTheUserStatesTheSpacing) {
  StoredFrfs frfs = stored();
  FrequencyLines lines = frequency_lines({0, 1, 2}, 1, "x.csv");
  lines.note = "rounded";
  frfs.set_lines(lines);
  const FrfRecord noted = to_accelerances(frfs, {});
  EXPECT_THAT(test::texts(noted.notes), testing::ElementsAre(testing::StartsWith("rounded")));
  EXPECT_THAT(noted.notes.at(0).options, testing::ElementsAre("df"));
  EXPECT_THAT(to_accelerances(frfs, {.read = {.df_Hz = 1}}).notes, IsEmpty());
}

// Accelerance of one mode: its phase falls by π for exp(+jωt).
TEST(StoredFrfs, RecognisesFrfsForTheOppositeTimeDependence) {
  StoredFrfs frfs = stored();
  std::vector<double> freq_Hz(200);
  for (std::size_t k = 0; k < freq_Hz.size(); ++k) freq_Hz[k] = static_cast<double>(k);
  frfs.record.lines = lines_from_frequencies(freq_Hz, "x.csv");
  for (StoredFrf& frf : frfs.frfs) {
    frf.value.clear();
    for (const double f : freq_Hz) frf.value.push_back(-f * f / Complex(100.0 * 100 - f * f, 2 * 0.02 * 100 * f));
  }
  EXPECT_THAT(to_accelerances(frfs, {}).notes, IsEmpty());
  for (StoredFrf& frf : frfs.frfs) {
    for (Complex& h : frf.value) h = std::conj(h);
  }
  EXPECT_THAT(test::texts(to_accelerances(frfs, {}).notes),
              testing::ElementsAre(testing::AllOf(HasSubstr("for exp(−jωt)"),
                                                  HasSubstr("sign of their imaginary part (or of their phase)"))));
}

TEST(StoredFrfs, AppliesTheFilesUnitUnlessTheUserNamesOne) {
  const FrfUnit g_per_lbf{.response_to_SI = kStandardGravity_mps2, .force_to_SI = kPoundForce_N};
  EXPECT_EQ(to_accelerances(stored(g_per_lbf), {}).accel[0].to_SI, kStandardGravity_mps2 / kPoundForce_N);
  EXPECT_EQ(to_accelerances(stored(g_per_lbf), {.read = {.accel_unit = "m/s^2"}}).accel[0].to_SI, 1 / kPoundForce_N);
  EXPECT_EQ(to_accelerances(stored(g_per_lbf), {.read = {.force_scale = {2}, .accel_scale = {3}}}).accel[0].to_SI, 1.5);
}

TEST(StoredFrfs, TurnsTheSignOfASensorThatPointsBackwards) {
  const auto record =
      to_accelerances(stored(), {.read = {.setup = {{.name = "accel 2", .sign = -1, .angle_rad = 1.0}}}});
  EXPECT_EQ(line(record, 0, 1), Complex(1, 0));
  EXPECT_EQ(line(record, 1, 1), Complex(-1, 0));
  EXPECT_EQ(record.accel[1].angle_rad, 1.0);
  const auto down =
      to_accelerances(stored(), {.read = {.setup = {{.name = "force", .sign = -1, .axis = Direction{0, 0, 1}}}}});
  EXPECT_EQ(line(down, 0, 1), Complex(-1, 0));
  const auto hammer = to_accelerances(stored(), {.read = {.setup = {{.name = "force", .sign = -1}}}});
  EXPECT_EQ(line(hammer, 0, 1), Complex(-1, 0));
}

TEST(StoredFrfs, KeepsTheChannelsAskedFor) {
  const auto record = to_accelerances(stored(), {.read = {.accel_channels = {"2"}}});
  ASSERT_THAT(record.frfs, SizeIs(1));
  EXPECT_EQ(record.accel.at(0).name, "accel 2");
  EXPECT_EQ(record.frfs[0].channel, 0U);
}

TEST(StoredFrfs, NotesAnAssumedKindAndAnOverruledOne) {
  EXPECT_THAT(to_accelerances(stored(), {}).notes, IsEmpty());
  EXPECT_THAT(test::texts(to_accelerances(stored(std::nullopt), {}).notes),
              testing::ElementsAre(HasSubstr("taken as accelerance")));
  const auto overruled = to_accelerances(stored(), {.kind = FrfKind::mobility});
  EXPECT_EQ(overruled.kind, FrfKind::mobility);
  EXPECT_THAT(overruled.notes.at(0).options, testing::ElementsAre("frf_kind"));
}

TEST(StoredFrfs, RefusesOptionsWithoutMeaningAndImplausibleNumbers) {
  EXPECT_THAT(test::options_of_error([] { to_accelerances(stored(), {.read = {.fs_Hz = 100}}); }),
              testing::ElementsAre("fs"));
  EXPECT_THAT(test::input_error_of([] { to_accelerances(stored(), {.read = {.force_sensitivity_V_per_N = 1}}); }),
              HasSubstr("sensitivity"));
  EXPECT_THAT(test::input_error_of([] { to_accelerances(stored(), {.read = {.accel_scale = {1e40}}}); }),
              HasSubstr("too large"));
  EXPECT_THAT(test::input_error_of([] { to_accelerances(stored(), {.read = {.force_scale = {0}}}); }),
              HasSubstr("scale"));
}

}  // namespace percuss::acquire::stored_frfs_test
