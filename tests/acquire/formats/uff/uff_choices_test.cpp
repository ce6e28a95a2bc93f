#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/uff/read_frf_uff.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/formats/uff/uff_roles.hpp"
#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_record.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"

// The choice of functions of data set 58 by options and axes, and unusable abscissas.
namespace percuss::acquire::uff_choices_test {

using test::accel_mps2;
using test::csv_bytes;
using test::force_N;
using test::input_error_of;
using test::kUffForce;
using test::opened_uff;
using test::uff_frf;
using test::uff_frf_header;
using test::uff_function;
using test::UffText;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const UffText kAccel{.response = "acc", .ordinate = 12, .ordinate_unit = "m/s^2"};

// A function of three numbers 1, 2, 3 at the times.
std::string uneven_text(UffText set, const std::vector<double>& times_s) {
  set.spacing = 0;
  set.values = 3;
  std::string numbers;
  for (std::size_t i = 0; i < 3; ++i) numbers += fmt::format("{:13.5E}{:13.5E}", times_s[i], 1.0 + double(i));
  return set.text(numbers + "\n");
}

TEST(UffChoices, TakeAReactionForceAsForce) {
  UffText plate = kUffForce;
  plate.response = "plate";
  plate.ordinate = 9;
  plate.ordinate_unit = "NONE";
  const Record record = opened_uff(uff_function(plate, 1) + uff_function(kAccel, 3));
  EXPECT_EQ(record.force.name, "plate");
  EXPECT_THAT(force_N(record), ElementsAre(1, 2));
}

TEST(UffChoices, TakeTheForceThatTheSetUpNames) {
  UffText first = kAccel, second = kAccel;
  first.response = "ch1";
  second.response = "ch2";
  first.ordinate = second.ordinate = 0;
  first.ordinate_unit = second.ordinate_unit = "NONE";
  const std::string text = uff_function(second, 5) + uff_function(first, 1);
  const Record record =
      opened_uff(text, {.setup = {{.name = "ch1", .role = "acceleration"}, {.name = "ch2", .role = "force"}}});
  EXPECT_EQ(record.force.name, "ch2");
  EXPECT_THAT(force_N(record), ElementsAre(5, 6));
  EXPECT_THAT(accel_mps2(record), ElementsAre(1, 2));
}

TEST(UffChoices, CallASensorRovingWhereOneNodeWasStruck) {
  const auto points = [](const std::vector<std::pair<int, int>>& nodes) {
    std::string text;
    for (const auto& [struck, sensed] : nodes) {
      UffText force = kUffForce, accel = kAccel;
      accel.reference_node = struck;
      accel.response_node = sensed;
      text += uff_function(force, 1) + uff_function(accel, 3);
    }
    std::vector<int> out;
    for (const RowInfo& row : opened_uff(text).rows) out.push_back(row.point);
    return out;
  };
  EXPECT_THAT(points({{1, 4}, {1, 9}, {1, 7}}), ElementsAre(4, 9, 7));
  EXPECT_THAT(points({{1, 4}, {1, 9}, {1, 4}}), ElementsAre(4, 9, 4)) << "several hits for each node";
  EXPECT_THAT(points({{2, 4}, {3, 9}, {4, 5}}), ElementsAre(2, 3, 4)) << "several struck nodes";
  const char* const refused = "-2 is not a point number (x.csv: line 3); number points from 0 to 1000000000";
  EXPECT_EQ(input_error_of([&] { points({{-2, 4}, {-1, 4}}); }), refused);
  EXPECT_EQ(input_error_of([&] { points({{1, -2}, {1, -1}}); }), refused);
}

TEST(UffChoices, RefuseTimeStepsThatAreNotPositive) {
  for (const auto& [dx, named] : {std::pair{"  0.00000E+00", "a time step of 0 s"},
                                  {" -1.00000E-03", "a time step of -0.001 s"},
                                  {"          inf", "a time step of inf s"}}) {
    UffText force = kUffForce, accel = kAccel;
    force.dx = accel.dx = dx;
    const std::string text = uff_function(force, 1) + uff_function(accel, 3);
    EXPECT_THAT(input_error_of([&] { opened_uff(text); }), HasSubstr(named));
    EXPECT_EQ(opened_uff(text, {.fs_Hz = 500}).fs_Hz, 500);
  }
}

// Six digits leave a doubt of a few ppm: the note gives it, and warns only of more than the clocks of recorders reach.
TEST(UffChoices, NoteHowFarARoundedStepMayBeOff) {
  UffText force = kUffForce, accel = kAccel;
  const auto note_of = [&](const char* dx) {
    force.dx = accel.dx = dx;
    const Record record = opened_uff(uff_function(force, 1) + uff_function(accel, 3));
    for (const Message& note : record.notes) {
      if (note.text.starts_with("sampling rate ")) return note;
    }
    return Message();
  };
  const Message six = note_of("  1.22070E-04");  // 8192 Hz, 1.220703125e-4 s, or as little as 1.2206950e-4 s
  EXPECT_THAT(six.text, StartsWith("sampling rate 8192 Hz"));
  EXPECT_THAT(six.text, EndsWith("all frequencies are off, by at most 6.7 ppm"));
  EXPECT_TRUE(six.information);
  const Message four = note_of("    1.221E-04");
  EXPECT_THAT(four.text, HasSubstr("by at most "));
  EXPECT_FALSE(four.information) << "half a unit of 1.221e-4 is 410 ppm";
}

// A step of six digits is replaced by the roundest rate that it may stand for. One digit allows too many rates.
TEST(UffChoices, DoNotRoundTheRateOfAStepOfOneDigit) {
  UffText force = kUffForce, accel = kAccel;
  force.dx = accel.dx = "       3.E-04";
  EXPECT_EQ(opened_uff(uff_function(force, 1) + uff_function(accel, 3)).fs_Hz, 1 / 3e-4);
}

TEST(UffChoices, RequireOneRateOfUnevenTimes) {
  const std::vector<double> slow{0, 0.001, 0.002}, later{5, 5.001, 5.002}, fast{0, 0.0005, 0.001};
  const Record record = opened_uff(uneven_text(kUffForce, slow) + uneven_text(kAccel, slow) +
                                   uneven_text(kUffForce, later) + uneven_text(kAccel, later));
  EXPECT_EQ(record.fs_Hz, 1000);
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_THAT(accel_mps2(record, 0, 1), ElementsAre(1, 2, 3));
  EXPECT_THAT(input_error_of([&] { opened_uff(uneven_text(kUffForce, slow) + uneven_text(kAccel, fast)); }),
              HasSubstr("functions of hit 1 differ in their sampling rate"));
  UffText even = kAccel;
  even.values = 3;
  EXPECT_THAT(input_error_of([&] {
                opened_uff(uneven_text(kUffForce, slow) + even.text("  1.00000E+00  2.00000E+00  3.00000E+00\n"));
              }),
              HasSubstr("functions of hit 1 differ in their sampling rate"));
  EXPECT_THAT(input_error_of([&] {
                opened_uff(uneven_text(kUffForce, {0, 1, 5}) + uneven_text(kAccel, {0, 1, 5}));
              }),
              HasSubstr("state the sampling rate"));
}

TEST(UffChoices, ReadUnevenTimesOfBinarySets) {
  std::string bytes;
  for (const float number : {0.0F, 1.0F, 0.001F, 2.0F, 0.002F, 3.0F}) bytes += test::number_bytes(number);
  UffText force = kUffForce, accel = kAccel;
  for (UffText* set : {&force, &accel}) {
    set->spacing = 0;
    set->values = 3;
  }
  const Record record = opened_uff(force.binary(bytes, 1, bytes.size()) + accel.binary(bytes, 1, bytes.size()));
  EXPECT_NEAR(record.fs_Hz, 2 / static_cast<double>(0.002F), 1e-9);  // rounding
  EXPECT_THAT(force_N(record), ElementsAre(1, 2, 3));
}

TEST(UffChoices, TakeFunctionsOfUnknownTypeByTheirAbscissa) {
  UffText complex{.type = 0, .ordinate_type = 5, .values = 1, .abscissa = 17};
  const std::string numbers = "  1.00000E+00  2.00000E+00\n";
  EXPECT_THAT(input_error_of([&] { opened_uff(complex.text(numbers)); }), HasSubstr("no time records and no FRFs"));
  complex.abscissa = 18;
  EXPECT_THAT(input_error_of([&] { opened_uff(complex.text(numbers)); }), HasSubstr("the file holds FRFs"));
}

TEST(UffChoices, NameDegreesOfFreedom) {
  EXPECT_EQ(uff_dof_name({"tip", 5, 1}), "tip");
  EXPECT_EQ(uff_dof_name({"", 5, -2}), "5-Y");
  EXPECT_EQ(uff_dof_name({"", 5, 6}), "5+RZ");
  EXPECT_EQ(uff_dof_name({"", 5, 7}), "node 5");
  EXPECT_EQ(uff_dof_name({"", 5, 0}), "node 5");
}

std::string uneven_frf_text(UffText set, double first_Hz, double second_Hz) {
  set.spacing = 0;
  return set.text(
      fmt::format("{:13.5E}{:13.5E}{:13.5E}{:13.5E}{:13.5E}{:13.5E}\n", first_Hz, 1.0, -1.0, second_Hz, 2.0, 0.0));
}

FrfRecord read(const std::string& text) {
  const FileBytes bytes = csv_bytes(text);
  auto stored = read_frf_uff(bytes, read_uff_contents(bytes), false);
  EXPECT_TRUE(stored.has_value());
  return to_accelerances(std::move(stored).value(), {});
}

TEST(UffFrfAxes, StateTheQuotientInTheOrdinateAlone) {
  const FrfRecord quotient = read(uff_frf(uff_frf_header({.ordinate_unit = "g/lbf", .denominator_unit = "m"})));
  EXPECT_DOUBLE_EQ(quotient.accel[0].to_SI, kStandardGravity_mps2 / kPoundForce_N);
  const FrfRecord bare = read(uff_frf(uff_frf_header({.ordinate = 0})));
  EXPECT_EQ(bare.accel[0].to_SI, 1);
  EXPECT_THAT(bare.notes.at(0).text, HasSubstr("the kind of the FRFs is not stated"));
}

TEST(UffFrfAxes, StateEachFrequencyOfUnevenLines) {
  const FrfRecord record = read(uneven_frf_text(uff_frf_header(), 10, 12));
  EXPECT_EQ(record.lines.first, 5U);
  EXPECT_NEAR(record.lines.df_Hz(), 2, 1e-12);  // rounding
  EXPECT_EQ(record.frfs[0].frf.value[1], Complex(2, 0));
  UffText second = uff_frf_header();
  second.response_node = 2;
  EXPECT_EQ(read(uneven_frf_text(uff_frf_header(), 10, 12) + uneven_frf_text(second, 10, 12)).frfs.size(), 2U);
  EXPECT_THAT(
      input_error_of([&] { read(uneven_frf_text(uff_frf_header(), 10, 12) + uneven_frf_text(second, 20, 24)); }),
      HasSubstr("FRFs with other lines than the first one"));
  EXPECT_THAT(input_error_of([&] { read(uff_frf(uff_frf_header()) + uneven_frf_text(second, 10, 12)); }),
              HasSubstr("FRFs with other lines than the first one"));
  second.x0 = "  1.20000E+01";
  EXPECT_THAT(input_error_of([&] { read(uff_frf(uff_frf_header()) + uff_frf(second)); }),
              HasSubstr("FRFs with other lines than the first one"));
}

TEST(UffFrfAxes, RefuseLinesThatAreNoMultiplesOfTheirSpacing) {
  const auto refusal = [](const std::string& x0, const std::string& dx) {
    UffText set = uff_frf_header();
    set.x0 = x0;
    set.dx = dx;
    return input_error_of([&] { read(uff_frf(set)); });
  };
  EXPECT_THAT(refusal("  1.00000E+01", "  0.00000E+00"), HasSubstr("2 lines from 10 Hz in steps of 0 Hz"));
  EXPECT_THAT(refusal("  1.10000E+01", "  2.00000E+00"), HasSubstr("2 lines from 11 Hz in steps of 2 Hz"));
  EXPECT_THAT(refusal(" -2.00000E+00", "  2.00000E+00"), HasSubstr("2 lines from -2 Hz in steps of 2 Hz"));
  UffText one = uff_frf_header();
  one.values = 1;
  EXPECT_THAT(input_error_of([&] { read(one.text("  1.00000E+00  2.00000E+00\n")); }),
              HasSubstr("1 lines from 10 Hz in steps of 2 Hz"));
}

TEST(UffFrfAxes, RefuseFrfsThatAreNotComplex) {
  UffText real = uff_frf_header();
  real.ordinate_type = 2;
  EXPECT_THAT(input_error_of([&] { read(real.text("  1.00000E+00  2.00000E+00\n")); }),
              HasSubstr("an FRF that is not complex"));
}

TEST(UffFrfAxes, RefuseACoherenceThatIsNotFinite) {
  UffText coherence = uff_frf_header();
  coherence.type = 6;
  coherence.ordinate_type = 2;
  const auto with = [&](const std::string& numbers) { return uff_frf(uff_frf_header()) + coherence.text(numbers); };
  EXPECT_THAT(read(with("  5.00000E-01  1.00000E+00\n")).frfs[0].frf.coherence, ElementsAre(0.5, 1));
  EXPECT_THAT(input_error_of([&] { read(with("  5.00000E-01          nan\n")); }),
              HasSubstr("a coherence that is not a finite number"));
  coherence.ordinate_type = 5;
  EXPECT_THAT(read(with("  5.00000E-01  0.00000E+00  5.00000E-01  0.00000E+00\n")).frfs[0].frf.coherence,
              testing::IsEmpty());
}

}  // namespace percuss::acquire::uff_choices_test
