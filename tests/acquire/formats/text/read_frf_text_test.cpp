#include "acquire/formats/text/read_frf_text.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::read_frf_text_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kRounding = 1e-12;

StoredFrfs read(const std::string& text, bool forced = false) {
  auto frfs = read_frf_text(test::csv_bytes(text), forced);
  EXPECT_TRUE(frfs);
  return frfs ? std::move(*frfs) : StoredFrfs{};
}

// As DataPhysics SignalCalc writes it: Latin-1, an empty last column of units, CR LF.
TEST(ReadFrfText, ReadsAnAnalysersExport) {
  const auto frfs = read(
      "Units: Ratio\r\nRef Chan:Resp Chan\tI0-Z:0-Z\r\nChannel Name\t : \r\n\r\nFrequency\tReal\tImaginary\r\n\r\n"
      "Units:\r\nHz\t(m/s\xB2)(N)\t \r\n0.0000000000000e+000\t -0.15\t 0\r\n1.9531250000000e-002\t 3e-2\t 0.007\r\n"
      "3.9062500000000e-002\t -0.1\t -0.006\r\n");
  ASSERT_THAT(frfs.frfs, SizeIs(1));
  EXPECT_EQ(frfs.record.lines.first, 0U);
  EXPECT_EQ(frfs.record.lines.count, 3U);
  EXPECT_EQ(frfs.record.lines.df_Hz(), 0.01953125);
  EXPECT_EQ(frfs.frfs[0].value[1], Complex(0.03, 0.007));
  ASSERT_TRUE(frfs.unit);
  EXPECT_EQ(frfs.unit->kind, FrfKind::accelerance);
  EXPECT_THAT(frfs.frfs[0].coherence, IsEmpty());
  EXPECT_THAT(frfs.record.notes, IsEmpty());
}

TEST(ReadFrfText, ReadsWhatPercussWrites) {
  const auto frfs = read(
      "# mobility (m/s)/N, H1, exp(+jwt), angle_deg 0 90, decay_per_s 4.6\n"
      "frequency_hz,p3_c0_re,p3_c0_im,p3_c0_std,p3_c0_coherence,p3_c1_re,p3_c1_im,p3_c1_std,p3_c1_coherence\n"
      "60,1,2,0.1,0.9,3,4,,\n62,5,6,0.2,0.8,7,8,,\n");
  ASSERT_THAT(frfs.frfs, SizeIs(2));
  EXPECT_EQ(frfs.frfs[0].point, 3);
  EXPECT_EQ(frfs.frfs[1].channel, 1U);
  EXPECT_EQ(frfs.frfs[1].value[1], Complex(7, 8));
  EXPECT_EQ(frfs.frfs[0].coherence, (std::vector{0.9, 0.8}));
  EXPECT_THAT(frfs.frfs[1].coherence, IsEmpty());
  EXPECT_EQ(frfs.unit->kind, FrfKind::mobility);
  EXPECT_EQ(frfs.record.decay_per_s, 4.6);
  EXPECT_LE(std::abs(*frfs.record.accel.at(1).angle_rad - std::numbers::pi / 2), kRounding);
  EXPECT_EQ(frfs.record.lines.first, 30U);
}

TEST(ReadFrfText, ReadsTheAveragesThatPercussStates) {
  const auto averages = [](const std::string& statement) {
    const auto frfs = read("# accelerance (m/s^2)/N, " + statement +
                           "\nfrequency_hz,p0_c0_re,p0_c0_im,p1_c0_re,p1_c0_im\n60,1,2,3,4\n62,5,6,7,8\n");
    return std::vector{frfs.frfs.at(0).averages, frfs.frfs.at(1).averages};
  };
  using testing::ElementsAre;
  EXPECT_THAT(averages("H1, exp(+jwt), averages 5"), ElementsAre(5, 5));
  EXPECT_THAT(averages("exp(+jwt), angle_deg 0, averages 5 4"), ElementsAre(5, 4));
  EXPECT_THAT(averages("exp(+jwt), averages 5 4 3"), ElementsAre(0, 0));
  EXPECT_THAT(averages("exp(+jwt), averages -5 1e99"), ElementsAre(0, 0));
  EXPECT_THAT(averages("averages 5"), ElementsAre(0, 0)) << "of another program, it may mean other averages";
}

std::string refusal(const std::string& text) {
  return test::input_error_of([&] { read_frf_text(test::csv_bytes(text), false); });
}

TEST(ReadFrfText, ReadsMagnitudeAndPhase) {
  const auto frfs = read("Frequency (Hz);Magnitude (dB);Phase (deg)\n0;0;0\n1;20;90\n2;40;-180\n");
  EXPECT_LE(std::abs(frfs.frfs[0].value[1] - Complex(0, 10)), kRounding * 10);
  EXPECT_LE(std::abs(frfs.frfs[0].value[2] - Complex(-100, 0)), kRounding * 100);
}

TEST(ReadFrfText, TellsDecibelsHoweverTheyAreWritten) {
  for (const char* const name : {"Magnitude (dB re 1 g/N)", "Magnitude [dB re g/N]", "Magnitude (dBg/N)"}) {
    const auto frfs = read("Frequency (Hz);" + std::string(name) + ";Phase (deg)\n0;0;0\n1;20;90\n2;40;-180\n");
    EXPECT_LE(std::abs(frfs.frfs[0].value[1] - Complex(0, 10)), kRounding * 10) << name;
    ASSERT_TRUE(frfs.unit) << name;
    EXPECT_EQ(frfs.unit->response_to_SI, kStandardGravity_mps2) << name;
  }
  const auto named = read("Freq;Mag_dB;Phase (deg)\n0;0;0\n1;20;90\n2;40;-180\n");
  EXPECT_LE(std::abs(named.frfs[0].value[2] - Complex(-100, 0)), kRounding * 100);
}

TEST(ReadFrfText, ReadsUnitsFromARowOfTheirOwn) {
  const auto frfs = read("Frequency,Magnitude,Phase\nHz,g/N,deg\n0,0,0\n1,10,90\n2,100,-180\n");
  EXPECT_LE(std::abs(frfs.frfs[0].value[1] - Complex(0, 10)), kRounding * 10);
  EXPECT_EQ(frfs.unit->response_to_SI, kStandardGravity_mps2);
  EXPECT_THAT(frfs.record.notes, IsEmpty());
}

// The tolerance of 1e-9 Hz allows for rounding.
TEST(ReadFrfText, ConvertsTheFrequencies) {
  EXPECT_NEAR(
      read("Frequency (rad/s),Re,Im\n0,0,0\n6.283185307179586,1,0\n12.566370614359172,1,0\n").record.lines.df_Hz(), 1,
      1e-9);
  EXPECT_NEAR(read("Frequency (rpm),Re,Im\n0,0,0\n60,1,0\n120,1,0\n").record.lines.df_Hz(), 1, 1e-9);
  EXPECT_THAT(refusal("Frequency (order),Re,Im\n0,0,0\n1,1,0\n2,1,0\n"),
              HasSubstr("the unit of the frequencies, order, is not known"));
}

// Many programs round the frequencies to two decimals. The spacing is 0.78125 Hz, but the last frequency, 1599.22 Hz,
// divided by its number, 2047, is 0.7812506 Hz.
TEST(ReadFrfText, FindsTheSpacingOfRoundedFrequencies) {
  std::string text = "Frequency (Hz),Re,Im\n";
  for (int k = 0; k < 2048; ++k) text += fmt::format("{:.2f},{},1\n", 0.78125 * k, k);
  EXPECT_EQ(read(text).record.lines.df_Hz(), 0.78125);
}

TEST(ReadFrfText, TakesTheColumnBeforeAPhaseForItsMagnitude) {
  const auto frfs = read("Hz,H1,phase,Coherence\n0,1,0,1\n1,10,90,1\n2,100,-180,0.5\n");
  ASSERT_EQ(frfs.frfs.size(), 1U);
  EXPECT_LE(std::abs(frfs.frfs[0].value[1] - Complex(0, 10)), kRounding * 10);
  EXPECT_EQ(frfs.frfs[0].coherence.at(2), 0.5);
  EXPECT_THAT(refusal("frequency,phase\n0,1\n1,1\n"), HasSubstr("no partner"));
  EXPECT_THAT(refusal("frequency,csd,phase\n0,1,1\n1,1,1\n"), HasSubstr("no partner"));
}

// Phases within ±π that span more than π/2, as at a resonance, are radians. Other phases are degrees.
TEST(ReadFrfText, TellsRadiansFromDegrees) {
  const auto radians = read("Hz,mag,phase\n0,1,0\n1,10,1.570796\n2,100,-3.14159\n");
  EXPECT_LE(std::abs(radians.frfs[0].value[1] - Complex(0, 10)), 1e-5);  // π/2 has six decimals
  EXPECT_THAT(radians.record.notes.at(0).text, HasSubstr("taken as radians"));
  const auto degrees = read("Hz,mag,phase\n0,1,0\n1,10,0.5\n2,100,1\n");
  EXPECT_THAT(degrees.record.notes.at(0).text, HasSubstr("taken as degrees"));
}

TEST(ReadFrfText, TakesColumnsWithoutNamesWhenForced) {
  EXPECT_FALSE(read_frf_text(test::csv_bytes("0 1 2\n1 3 4\n2 5 6\n"), false));
  EXPECT_EQ(read("0 1 2\n1 -3 4\n2 5 6\n", true).frfs.at(0).value[2], Complex(5, 6));
}

TEST(ReadFrfText, RefusesColumnsWithoutNamesThatMayBeMagnitudes) {
  try {
    read_frf_text(test::csv_bytes("0 1 170\n1 3 90\n2 5 -10\n"), true);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("column 2 has no name and is never negative"));
  }
}

// The accelerance of two modes, once in dB and degrees, once as real and imaginary part.
TEST(ReadFrfText, RefusesColumnsWithoutNamesThatMayBeLevelAndPhase) {
  std::string polar, cartesian;
  for (int k = 0; k < 400; ++k) {
    const double f = 20 + k;
    const auto mode = [&](double f0) { return -f * f / Complex(f0 * f0 - f * f, 0.02 * f0 * f); };
    const Complex h = 0.1 * mode(120) + 0.05 * mode(310);
    polar += fmt::format("{},{},{}\n", f, 20 * std::log10(std::abs(h)), std::arg(h) * 180 / std::numbers::pi);
    cartesian += fmt::format("{},{},{}\n", f, h.real(), h.imag());
  }
  EXPECT_THAT(test::input_error_of([&] { read_frf_text(test::csv_bytes(polar), true); }),
              HasSubstr("columns 2 and 3 have no names and may be a level in dB and a phase in degrees"));
  EXPECT_EQ(read(cartesian, true).frfs.size(), 1U);
  EXPECT_EQ(read("Hz,dB,phase\n" + polar).frfs.at(0).value.size(), 400U);
  // 0.1/0.02 at 120 Hz, and 0.01 of the other mode.
  EXPECT_NEAR(std::abs(read("Hz,dB,phase\n" + polar).frfs.at(0).value[100]), 5, 0.2);
}

TEST(ReadFrfText, IgnoresTimeRecords) {
  EXPECT_FALSE(read_frf_text(test::csv_bytes("t_s,force_N,acc_m_s2\n0,1,2\n1,3,4\n2,5,6\n"), false));
  EXPECT_FALSE(read_frf_text(test::csv_bytes("Frequency,Power\n0,1\n1,3\n2,5\n"), false));
}

TEST(ReadFrfText, RefusesColumnsWithoutTheirPartner) {
  EXPECT_THAT(refusal("frequency,a_re,b_re\n0,1,2\n1,1,2\n"), HasSubstr("b_re has no partner"));
  EXPECT_THAT(refusal("frequency,a_im\n0,1\n1,1\n"), HasSubstr("no partner"));
  EXPECT_THAT(refusal("frequency,a_re,a_phase\n0,1,2\n1,1,2\n"), HasSubstr("no partner"));
}

TEST(ReadFrfText, RefusesPointNumbersThatAreTooLarge) {
  EXPECT_THAT(refusal("frequency,p2000000000_c0_re,p2000000000_c0_im\n0,1,2\n1,1,2\n"),
              HasSubstr("2000000000 is not a point number"));
}

TEST(ReadFrfText, RefusesPointsThatLackAChannel) {
  const char* const kIncomplete = "not one FRF of every channel for every point";
  EXPECT_THAT(refusal("frequency,p0_c0_re,p0_c0_im,p1_c1_re,p1_c1_im\n0,1,2,3,4\n1,1,2,3,4\n"), HasSubstr(kIncomplete));
  EXPECT_THAT(refusal("frequency,p0_c0_re,p0_c0_im,p0_c0_re,p0_c0_im\n0,1,2,3,4\n1,1,2,3,4\n"), HasSubstr(kIncomplete));
  EXPECT_THAT(refusal("frequency,p0_c0_re,p0_c0_im,p1_c9223372036854775808_re,p1_c9223372036854775808_im\n"
                      "0,1,2,3,4\n1,1,2,3,4\n"),
              HasSubstr(kIncomplete));
}

TEST(ReadFrfText, RefusesGapsAndUnevenFrequencies) {
  EXPECT_THAT(refusal("frequency,re,im\n0,1,2\n1,,2\n2,3,4\n"), AllOf(HasSubstr("x.csv"), HasSubstr("line 3")));
  EXPECT_THAT(refusal("frequency,re,im\n0,1,2\n1,1,2\n3,3,4\n"), HasSubstr("not a multiple"));
  EXPECT_THAT(refusal("frequency,re,im\n3,1,2\n2,1,2\n1,3,4\n"), HasSubstr("do not rise"));
  EXPECT_THAT(refusal("frequency,re,im\n0,1,2\n0,1,2\n0,3,4\n"), HasSubstr("do not rise"));
  EXPECT_THAT(refusal("frequency,re,im\n1,1,2\n"), HasSubstr("fewer than two"));
  EXPECT_THAT(refusal("frequency,re,im\n1e15,1,2\n1000000000000001,1,2\n"), HasSubstr("too close together"));
}

}  // namespace percuss::acquire::read_frf_text_test
