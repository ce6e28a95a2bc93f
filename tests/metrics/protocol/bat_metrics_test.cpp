#include "metrics/protocol/bat_metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "metrics/protocol/resolution.hpp"
#include "support/input_error.hpp"

namespace percuss::metrics::bat_metrics_test {

constexpr double kMph = kMilePerHour_mps;

// The readings of one bat and one impact, without their errors.
struct Numbers {
  double length_m = 34 * kInch_m, mass_kg = 31 * kOunce_kg, cg_m = 12.5 * kInch_m, period_s = 1.42;
  double ball_kg = 0.1454, z_m = 6 * kInch_m, in_mps = 136 * kMph, out_mps = 31 * kMph;
};

BatReadings readings_of(const Numbers& n, double relative_std) {
  const auto reading = [&](double value, Reading which) { return UncertainValue(value, relative_std * value, which); };
  return {.length_m = reading(n.length_m, Reading::length),
          .mass_kg = reading(n.mass_kg, Reading::weight),
          .cg_m = reading(n.cg_m, Reading::cg),
          .period_s = reading(n.period_s, Reading::period),
          .ball_kg = reading(n.ball_kg, Reading::ball),
          .z_m = reading(n.z_m, Reading::location),
          .in_mps = reading(n.in_mps, Reading::inbound),
          .out_mps = reading(n.out_mps, Reading::rebound)};
}

TEST(BatMetrics, RefuseBesrTogetherWithBbcor) {
  BatReadings readings{.besr = UncertainValue(0.7, 0.01, Reading::given_besr),
                       .bbcor = UncertainValue(0.5, 0.01, Reading::given_bbcor)};
  EXPECT_THAT(test::options_of_error([&] { bat_metrics(readings); }), testing::ElementsAre("besr", "bbcor"));
  readings.besr.reset();
  EXPECT_EQ(bat_metrics(readings).bbcor->value(), 0.5);
}

TEST(BatMetrics, PropagatesTheErrorOfEveryReading) {
  constexpr double kRelative = 1e-5;
  constexpr double kSecondOrder = 1e-3;  // of the standard deviation: bound of the second-order terms
  const std::array<std::pair<const char*, std::optional<UncertainValue> BatMetrics::*>, 9> results{
      {{"drop", &BatMetrics::drop},
       {"moi", &BatMetrics::moi_kgm2},
       {"besr", &BatMetrics::besr},
       {"ncaa", &BatMetrics::ncaa_besr},
       {"bbs", &BatMetrics::bbs_mps},
       {"bbcor", &BatMetrics::bbcor},
       {"contact", &BatMetrics::contact_mps},
       {"swing", &BatMetrics::swing_mps},
       {"k", &BatMetrics::k}}};
  const std::array<double Numbers::*, 8> members{&Numbers::length_m, &Numbers::mass_kg, &Numbers::cg_m,
                                                 &Numbers::period_s, &Numbers::ball_kg, &Numbers::z_m,
                                                 &Numbers::in_mps,   &Numbers::out_mps};
  const BatMetrics at = bat_metrics(readings_of({}, kRelative));
  for (const auto& [name, member] : results) {
    double squares = 0;
    for (const auto reading : members) {
      Numbers moved;
      moved.*reading *= 1 + kRelative;
      const BatMetrics there = bat_metrics(readings_of(moved, 0));
      const double change = (there.*member)->value() - (at.*member)->value();
      squares += change * change;
    }
    const double expected = std::sqrt(squares);
    EXPECT_NEAR((at.*member)->std(), expected, kSecondOrder * expected) << name;
  }
}

TEST(BatMetrics, OmitsResultsWithoutReadings) {
  BatReadings r;
  BatMetrics m = bat_metrics(r);
  EXPECT_FALSE(m.drop || m.moi_kgm2 || m.besr || m.ncaa_besr || m.bbs_mps || m.bbcor || m.contact_mps || m.swing_mps ||
               m.k || m.drop_class);
  r.in_mps = 60;
  r.out_mps = 14;
  m = bat_metrics(r);
  EXPECT_TRUE(m.besr);
  EXPECT_FALSE(m.ncaa_besr || m.bbcor || m.bbs_mps);
  r.length_m = 0.86;
  r.z_m = 0.15;
  m = bat_metrics(r);
  EXPECT_TRUE(m.ncaa_besr && m.contact_mps);
  EXPECT_FALSE(m.bbcor || m.moi_kgm2);
  r.moi_kgm2 = 0.19;
  m = bat_metrics(r);
  EXPECT_TRUE(m.bbs_mps && m.swing_mps);
  EXPECT_FALSE(m.bbcor || m.k);
  r.ball_kg = 0.145;
  EXPECT_TRUE(bat_metrics(r).bbcor);
}

TEST(BatMetrics, ComputesBesrFromBbcor) {
  BatReadings r = readings_of({}, 0);
  const BatMetrics there = bat_metrics(r);
  r.in_mps.reset();
  r.bbcor = there.bbcor;
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(bat_metrics(r).besr->value(), there.besr->value(), kRounding);
}

TEST(BatMetrics, AddsTheLotsCorrectionToTheRatioOfSpeeds) {
  BatReadings r = readings_of({}, 0);
  const BatMetrics plain = bat_metrics(r);
  r.lot_correction = 0.004;
  const BatMetrics corrected = bat_metrics(r);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(corrected.besr->value() - plain.besr->value(), 0.004, kRounding);
  EXPECT_NEAR(corrected.ncaa_besr->value() - plain.ncaa_besr->value(), 0.004, kRounding);
}

TEST(BatMetrics, ListsReadingsOfUnknownError) {
  const UncertainValue known(2, 0.1, Reading::length), unknown(3, 0, Reading::period);
  const UncertainValue product = known * unknown;
  EXPECT_TRUE(product.unknown(Reading::period));
  EXPECT_FALSE(product.unknown(Reading::length));
  EXPECT_DOUBLE_EQ(product.std(), 0.3);
  EXPECT_EQ((known - known).std(), 0);  // one reading's error cancels
}

TEST(BatMetrics, WarnsOfInconsistentConstants) {
  BatReadings r = readings_of({}, 0);
  const auto codes = [&] {
    std::vector<std::string> all;
    for (const auto& warning : metrics_warnings(r, bat_metrics(r))) all.push_back(warning.code);
    return all;
  };
  EXPECT_THAT(codes(), testing::ElementsAre("swing_speed_constant"));
  r.swing.v0_mps = 40 * kMph;
  EXPECT_THAT(codes(), testing::IsEmpty());
  r.swing.exponent = 0.5;
  r.mass_kg = 20 * kOunce_kg;
  r.out_mps = 200;
  EXPECT_THAT(codes(), testing::IsSupersetOf({"swing_exponent", "drop_class", "rebound_speed"}));
}

std::string implausible(const BatReadings& r) {
  std::string all;
  for (const auto& warning : metrics_warnings(r, bat_metrics(r))) {
    if (warning.code == "implausible_value") all += warning.message + "\n";
  }
  return all;
}

TEST(BatMetrics, NamesImplausibleValues) {
  using testing::AllOf;
  using testing::HasSubstr;
  BatReadings r;
  r.length_m = 33 * kInch_m;
  r.mass_kg = 30 * kOunce_kg;
  r.cg_m = 20 * kInch_m;  // from the knob
  r.period_s = 1.255;
  EXPECT_THAT(implausible(r), AllOf(HasSubstr("a balance point of 20 in from the tip"), HasSubstr("not from the knob"),
                                    HasSubstr("a moment of inertia of 3237 oz in² is implausible")));
  r.cg_m = 12.5 * kInch_m;
  r.period_s = 1.485;
  EXPECT_EQ(implausible(r), "");
  r.period_s = 1250;
  EXPECT_THAT(implausible(r), HasSubstr("a period of 1250 s is implausible: the usual range is 1 to 2 s"));
  BatReadings shot;
  for (const double bbcor : {1.08, 1023.0}) {
    shot.bbcor = bbcor;
    EXPECT_THAT(implausible(shot), AllOf(HasSubstr("a BBCOR of"), HasSubstr("0.25 to 0.8"), HasSubstr("energy")));
  }
  shot.bbcor = 0.497;
  EXPECT_EQ(implausible(shot), "");
  shot.in_mps = 60;
  shot.out_mps = -14;
  EXPECT_THAT(implausible(shot), HasSubstr("a rebound speed of -31.32 mph is implausible"));
}

// A rebound faster than the inbound ball is named once, with both speeds and the remedy.
TEST(BatMetrics, NamesExchangedSpeedsOnce) {
  BatReadings r;
  r.in_mps = 14;
  r.out_mps = 60;
  const auto warnings = metrics_warnings(r, bat_metrics(r));
  EXPECT_EQ(implausible(r).find("a rebound speed"), std::string::npos) << "the rebound speed is named twice";
  EXPECT_EQ(warnings.front().code, "rebound_speed");
  EXPECT_EQ(warnings.front().severity, warnings::Severity::reject);
  EXPECT_NE(warnings.front().message.find("134.2 mph"), std::string::npos) << warnings.front().message;
}

TEST(BatMetrics, EndsEachWarningWithItsRemedy) {
  BatReadings r = readings_of({}, 0);
  r.swing.exponent = 0.5;
  r.mass_kg = 20 * kOunce_kg;
  r.out_mps = 200;
  std::vector<std::string> codes;
  for (const auto& warning : metrics_warnings(r, bat_metrics(r))) {
    EXPECT_NE(warning.remedy, "") << warning.code;
    EXPECT_TRUE(warning.message.ends_with("; " + warning.remedy)) << warning.message;
    codes.push_back(warning.code);
  }
  EXPECT_THAT(codes, testing::IsSupersetOf({"swing_speed_constant", "swing_exponent", "drop_class", "rebound_speed"}));
}

TEST(BatMetrics, PutsImplausibleValuesFirst) {
  BatReadings r = readings_of({}, 0);
  r.period_s = 1250;
  const auto warnings = metrics_warnings(r, bat_metrics(r));
  ASSERT_GE(warnings.size(), 2U);
  EXPECT_EQ(warnings.front().severity, warnings::Severity::reject);
  EXPECT_NE(warnings.front().remedy, "");
  EXPECT_EQ(warnings.back().severity, warnings::Severity::info);
}

}  // namespace percuss::metrics::bat_metrics_test
