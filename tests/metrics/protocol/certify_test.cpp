#include "metrics/protocol/certify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "metrics/protocol/performance.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "synth/random_stream.hpp"

namespace percuss::metrics::certify_test {

using test::codes_of;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

constexpr double kMph = kMilePerHour_mps;
constexpr double kRounding = 1e-12;  // means of six values near 1

Session fresh_session() {
  return {.bat = {.id = "b", .length_in = 33, .moi_ozin2 = 9600, .days_in_lab = 3},
          .lot = {.days_in_lab = 20, .correction = 0},
          .temperature_F = 72,
          .humidity_percent = 50,
          .limit = 0.728};
}

double target_mph(const Session& s, double z_in) {
  return contact_speed_mps(s.bat.length_in * kInch_m, z_in * kInch_m) / kMph;
}

// A shot at the target speed with this NCAA BESR: v_out from (P7) solved for it.
SessionShot shot_with(const Session& s, double z_in, double value, int number = 0) {
  const double in = target_mph(s, z_in), delta = 136 - in;
  return {.place = "shot",
          .ball = "ball " + std::to_string(number / 8),
          .z_in = z_in,
          .ball_g = 145.4,
          .in_mph = in,
          .out_mph = (value - 0.5) * (in + delta) + delta};
}

// Fires every shot that certify() asks for, at most `most`.
Certification run_session(Session& s, const std::function<double(double)>& barrel, std::size_t most = 2000) {
  Certification c = certify(s);
  while (c.next.code == "shoot" && s.shots.size() < most) {
    s.shots.push_back(shot_with(s, *c.next.z_in, barrel(*c.next.z_in), static_cast<int>(s.shots.size())));
    c = certify(s);
  }
  return c;
}

const TestedLocation* location_at(const Certification& c, double z_in) {
  for (const TestedLocation& location : c.locations) {
    if (location.z_in == z_in) return &location;
  }
  return nullptr;
}

double peak(double z_in) { return 0.72 - 0.01 * std::abs(z_in - 5.5); }

TEST(Certify, FindsTheSweetSpotAndPassesABatWithinTheLimit) {
  Session s = fresh_session();
  const Certification c = run_session(s, peak);
  EXPECT_EQ(c.verdict, CertifyVerdict::pass);
  EXPECT_EQ(c.sweet_spot_in, 5.5);
  EXPECT_NEAR(*c.best, 0.72, kRounding);
  EXPECT_EQ(c.next.code, "stop");
  EXPECT_EQ(s.shots.size(), 6 * 4U);  // 6, 5, 7, 5.5
}

TEST(Certify, PassesOnTheLimitAndFailsAboveIt) {
  Session s = fresh_session();
  s.limit = 0.72;
  EXPECT_EQ(run_session(s, peak).verdict, CertifyVerdict::pass);
  s.limit = 0.7199;
  EXPECT_EQ(certify(s).verdict, CertifyVerdict::fail);
  s.limit.reset();
  EXPECT_EQ(certify(s).verdict, CertifyVerdict::no_limit);
}

TEST(Certify, StopsAsSoonAsALocationExceedsTheLimit) {
  Session s = fresh_session();
  s.limit = 0.71;
  const Certification c = run_session(s, peak);
  EXPECT_EQ(c.verdict, CertifyVerdict::fail);
  EXPECT_EQ(s.shots.size(), 6U);
  EXPECT_THAT(c.next.message, HasSubstr("exceeds the limit"));
}

TEST(Certify, FailsADamagedBat) {
  Session s = fresh_session();
  s.shots.push_back(shot_with(s, 6, 0.7));
  s.shots.back().damage = "crack";
  EXPECT_EQ(certify(s).verdict, CertifyVerdict::fail);
  EXPECT_EQ(certify(s).next.message, "stop: the bat is damaged");
}

TEST(Certify, GivesNoVerdictOnAPlateauOrAtTheEnd) {
  Session flat = fresh_session(), rising = fresh_session();
  EXPECT_EQ(run_session(flat, [](double z) { return z < 5.4 || z > 6.1 ? 0.70 : 0.72; }).verdict,
            CertifyVerdict::undecided);
  EXPECT_THAT(certify(flat).next.message, HasSubstr("5.5 to 6 in, are within the margin"));
  EXPECT_EQ(run_session(rising, [](double z) { return 0.7 - 0.01 * z; }).verdict, CertifyVerdict::undecided);
  EXPECT_THAT(certify(rising).next.message, HasSubstr("the best location, 3 in, is at an end"));
}

TEST(Certify, AcceptsAPlateauWhereAsked) {
  Session flat = fresh_session();
  run_session(flat, [](double z) { return z < 5.4 || z > 6.1 ? 0.70 : 0.72; });
  const Certification c = certify(flat, {.accept_plateau = true});
  EXPECT_EQ(c.verdict, CertifyVerdict::pass);
  EXPECT_EQ(c.sweet_spot_in, 6);
  EXPECT_THAT(codes_of(c.remarks), Contains("plateau"));
  flat.limit = 0.719;
  EXPECT_EQ(certify(flat, {.accept_plateau = true}).verdict, CertifyVerdict::fail);
  Session pointed = fresh_session();
  run_session(pointed, peak);
  const Certification without_plateau = certify(pointed, {.accept_plateau = true});
  EXPECT_EQ(without_plateau.verdict, CertifyVerdict::pass);
  EXPECT_THAT(codes_of(without_plateau.remarks), testing::Not(Contains("plateau")));
}

TEST(Certify, WithholdsTheVerdictForAnImplausibleBat) {
  Session s = fresh_session();
  run_session(s, peak);
  EXPECT_EQ(certify(s).verdict, CertifyVerdict::pass);
  s.bat.moi_ozin2 = 96;
  const Certification c = certify(s);
  EXPECT_EQ(c.verdict, CertifyVerdict::in_progress);
  EXPECT_EQ(c.next.code, "check_bat");
  EXPECT_THAT(c.next.message, testing::HasSubstr("a moment of inertia of 96 oz in² is implausible"));
}

TEST(Certify, WaitsForConditioningAndClimate) {
  const std::vector<std::pair<const char*, std::function<void(Session&)>>> faults{
      {"condition_bat", [](Session& s) { s.bat.days_in_lab = 1.9; }},
      {"condition_balls", [](Session& s) { s.lot.days_in_lab = 13; }},
      {"restore_climate", [](Session& s) { s.temperature_F = 76.1; }},
      {"restore_climate", [](Session& s) { s.humidity_percent = 44.9; }}};
  for (const auto& [action, spoil] : faults) {
    Session s = fresh_session();
    spoil(s);
    for (int i = 0; i < 6; ++i) s.shots.push_back(shot_with(s, 6, 0.9, i));
    const Certification c = certify(s);
    EXPECT_EQ(c.next.code, action);
    EXPECT_EQ(c.verdict, CertifyVerdict::in_progress);
    EXPECT_TRUE(c.locations.empty());
  }
  Session at_the_limits = fresh_session();
  at_the_limits.bat.days_in_lab = 2;
  at_the_limits.lot.days_in_lab = 14;
  at_the_limits.temperature_F = 68;
  at_the_limits.humidity_percent = 55;
  EXPECT_EQ(certify(at_the_limits).next.code, "shoot");
}

// Each limit of a valid shot: a shot on the limit counts, a shot just beyond it does not.
TEST(Certify, CountsOnlyShotsWithinEveryLimit) {
  struct Case {
    const char* code;
    std::function<void(SessionShot&, double)> set;
    double limit, beyond;
  };
  const std::vector<Case> cases{
      {"inbound_speed", [](SessionShot& shot, double by) { shot.in_mph += by; }, 2, 2.001},
      {"inbound_speed", [](SessionShot& shot, double by) { shot.in_mph -= by; }, 2, 2.001},
      {"rebound_angle", [](SessionShot& shot, double by) { shot.angle_deg = by; }, 5, 5.01},
      {"rebound_angle", [](SessionShot& shot, double by) { shot.angle_deg = -by; }, 5, 5.01},
      {"ball_mass", [](SessionShot& shot, double by) { shot.ball_g += by; }, 1, 1.1},
      {"ball_mass", [](SessionShot& shot, double by) { shot.ball_g -= by; }, 1, 1.1},
      {"gate_pairs_in",
       [](SessionShot& shot, double by) {
         shot.pairs_in_mph = {136, 136 + by, 136};
       },
       1.5, 1.51},
      {"gate_pairs_out",
       [](SessionShot& shot, double by) {
         shot.pairs_out_mph = {30, 30 - by, 30};
       },
       1.5, 1.51},
      {"temperature", [](SessionShot& shot, double by) { shot.temperature_F = 72 + by; }, 4, 4.1},
      {"humidity", [](SessionShot& shot, double by) { shot.humidity_percent = 50 - by; }, 5, 5.1},
      {"location", [](SessionShot& shot, double by) { shot.z_in -= by; }, 0, 0.01}};
  for (const Case& c : cases) {
    Session s = fresh_session();
    s.shots = {shot_with(s, 6, 0.7), shot_with(s, 6, 0.7)};
    c.set(s.shots[0], c.limit);
    c.set(s.shots[1], c.beyond);
    const Certification result = certify(s);
    EXPECT_THAT(codes_of(result.shots[0].reasons), ElementsAre()) << c.code;
    EXPECT_THAT(codes_of(result.shots[1].reasons), ElementsAre(c.code));
  }
}

TEST(Certify, RefusesLocationsOutsideTheRange) {
  Session s = fresh_session();
  s.shots = {shot_with(s, 2.5, 0.7), shot_with(s, 9.5, 0.7)};
  const Certification c = certify(s);
  EXPECT_THAT(codes_of(c.shots[0].reasons), ElementsAre("location"));
  EXPECT_THAT(codes_of(c.shots[1].reasons), ElementsAre("location"));
}

TEST(Certify, CountsTheImpactsOfEachBall) {
  Session s = fresh_session();
  for (int i = 0; i < 9; ++i) {
    s.shots.push_back(shot_with(s, 6, 0.7));
    s.shots.back().ear = 1 + (i / 2) % 4;
  }
  s.shots.push_back(shot_with(s, 6, 0.7, 8));
  s.shots.back().ear = 2;
  s.shots.push_back(s.shots.back());
  s.shots.push_back(s.shots.back());
  const Certification c = certify(s);
  EXPECT_TRUE(c.shots[7].valid());
  EXPECT_THAT(codes_of(c.shots[8].reasons), ElementsAre("ball_impacts", "ear_impacts"));
  EXPECT_EQ(c.balls.at("ball 0").impacts, 9);
  EXPECT_EQ(c.balls.at("ball 0").spent, "it had 8 impacts");
  EXPECT_TRUE(c.shots[10].valid());
  EXPECT_THAT(codes_of(c.shots[11].reasons), ElementsAre("ear_impacts"));
  EXPECT_EQ(c.next.ball, "ball 1");
  s.shots.push_back(shot_with(s, 6, 0.7, 16));
  EXPECT_EQ(certify(s).next.ball, "ball 2");  // it has fewer impacts than ball 1
}

TEST(Certify, CountsOnlyTheFirstSixShots) {
  Session s = fresh_session();
  for (int i = 0; i < 6; ++i) s.shots.push_back(shot_with(s, 6, 0.7, i));
  const double before = certify(s).locations[0].mean;
  s.shots.push_back(shot_with(s, 6, 0.9, 6));
  const Certification c = certify(s);
  EXPECT_EQ(c.locations[0].mean, before);
  EXPECT_EQ(c.locations[0].valid, 7U);
  EXPECT_FALSE(c.shots[6].counted);
  EXPECT_EQ(c.next.z_in, 5);
}

TEST(Certify, CompletesABetterLocationThatHasStarted) {
  Session s = fresh_session();
  s.shots.push_back(shot_with(s, 8, 0.727));
  const Certification c = run_session(s, [](double z_in) { return z_in == 8 ? 0.727 : peak(z_in); });
  const TestedLocation* const location = location_at(c, 8);
  ASSERT_NE(location, nullptr);
  EXPECT_TRUE(location->complete);
  EXPECT_NEAR(location->mean, 0.727, kRounding);
  EXPECT_EQ(c.sweet_spot_in, 8);
}

TEST(Certify, LeavesAStartedLocationThatIsNotBetter) {
  Session s = fresh_session();
  s.shots.push_back(shot_with(s, 8, 0.727));
  const Certification c = run_session(s, peak);  // its second shot lowers its mean below the best location
  EXPECT_EQ(c.verdict, CertifyVerdict::pass);
  EXPECT_EQ(c.sweet_spot_in, 5.5);
  const TestedLocation* const location = location_at(c, 8);
  ASSERT_NE(location, nullptr);
  EXPECT_FALSE(location->complete);
  EXPECT_EQ(location->valid, 2U);
  EXPECT_LT(location->mean, *c.best);
}

TEST(Certify, CorrectsByTheLotAfterThirtyHits) {
  Session s = fresh_session();
  s.lot.correction.reset();
  for (int i = 0; i < 29; ++i) {
    s.lot.hits.push_back({.ball = "n" + std::to_string(i), .ball_g = 145.4, .in_mph = 136, .out_mph = 31});
  }
  Certification c = certify(s);
  EXPECT_EQ(c.next.code, "lot_hit");
  EXPECT_EQ(c.next.left, 1U);
  EXPECT_FALSE(c.correction);
  s.lot.hits.push_back({.ball = "heavy", .ball_g = 160, .in_mph = 136, .out_mph = 31});
  c = certify(s);
  EXPECT_FALSE(c.lot_hits.back().valid());
  EXPECT_EQ(c.next.left, 1U);
  s.lot.hits.push_back({.ball = "last", .ball_g = 145.4, .in_mph = 134.5, .out_mph = 30});
  c = certify(s);
  EXPECT_NEAR(*c.correction, 0.231 - (29 * 31 / 136.0 + 30 / 134.5) / 30, kRounding);
  s.shots = {shot_with(s, 6, 0.7)};
  EXPECT_NEAR(certify(s).locations[0].mean, 0.7 + *c.correction, kRounding);
}

TEST(Certify, JudgesByBbcorWhereAsked) {
  Session s = fresh_session();
  s.metric = PerformanceMetric::bbcor;
  s.limit = 0.6;
  const SessionShot shot = shot_with(s, 6, 0.7);
  s.shots = {shot};
  const double k = ball_to_bat_inertia(0.1454, 33 * kInch_m, 6 * kInch_m, 9600 * kOunceInch2_kgm2);
  EXPECT_NEAR(certify(s).locations[0].mean, bbcor_of(0.7, k), kRounding);
}

TEST(Certify, NeedsTheMomentOfInertiaForBbcor) {
  Session s = fresh_session();
  s.metric = PerformanceMetric::bbcor;
  s.bat.moi_ozin2.reset();
  EXPECT_THAT(test::input_error_of([&] { certify(s); }), HasSubstr("bat.moi_oz_in2"));
}

TEST(Certify, NamesItsVerdicts) {
  EXPECT_STREQ(name_of(CertifyVerdict::pass), "pass");
  EXPECT_STREQ(name_of(CertifyVerdict::fail), "fail");
  EXPECT_STREQ(name_of(CertifyVerdict::undecided), "undecided");
  EXPECT_STREQ(name_of(CertifyVerdict::no_limit), "no_limit");
  EXPECT_STREQ(name_of(CertifyVerdict::in_progress), "in_progress");
}

// Random barrels, rebound angles and balls. The session always ends and asks only for permitted locations. A bat that
// passes has a sweet spot and keeps the limit at every tested location.
TEST(Certify, NeverPassesABatThatFails) {
  std::array<int, 5> verdicts{};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    synth::RandomStream random{5, seed};
    Session s = fresh_session();
    s.metric = seed % 2 == 0 ? PerformanceMetric::ncaa_besr : PerformanceMetric::besr;
    s.limit = random.uniform(0.715, 0.735);
    const double centre = random.uniform(3, 9), fall = random.uniform(0, 0.02), height = random.uniform(0.71, 0.73);
    Certification c = certify(s);
    for (int fired = 0; c.next.code == "shoot"; ++fired) {
      ASSERT_LT(fired, 2000) << "does not end";
      ASSERT_GE(*c.next.z_in, s.low_in);
      ASSERT_LE(*c.next.z_in, s.high_in);
      const double z = *c.next.z_in, noise = 0.002 * (random.uniform() - 0.5);
      s.shots.push_back(shot_with(s, z, height - fall * std::abs(z - centre) + noise, fired));
      if (random.uniform() < 0.2) s.shots.back().angle_deg = random.uniform(-20, 20);
      if (random.uniform() < 0.1) s.shots.back().ball_g = random.uniform(140, 150);
      c = certify(s);
    }
    EXPECT_EQ(c.next.code, "stop");
    ++verdicts.at(static_cast<std::size_t>(c.verdict));
    if (c.verdict != CertifyVerdict::pass) continue;
    EXPECT_TRUE(c.sweet_spot_in);
    for (const TestedLocation& location : c.locations) EXPECT_LE(location.mean, *s.limit + 1e-9);
  }
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(CertifyVerdict::pass)), 20);
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(CertifyVerdict::fail)), 20);
  EXPECT_GT(verdicts.at(static_cast<std::size_t>(CertifyVerdict::undecided)), 20);
}

// Six shots at 136.0 mph, 6 in from the tip of a 33 in bat. By hand, BESR = v/136 + 1/2 + ε, with v the rebound speed
// of each shot and ε the correction of the lot.
TEST(Certify, GivesAllMetricsOfALocation) {
  Session s = fresh_session();
  s.lot.correction = 0.002;
  double sum = 0, bbcor = 0;
  for (int i = 0; i < 6; ++i) {
    SessionShot shot = shot_with(s, 6, 0.7, i);
    shot.in_mph = 136;
    shot.out_mph = 29 + 0.1 * i;
    shot.ball_g = 145.0 + 0.1 * i;
    s.shots.push_back(shot);
    const double besr = shot.out_mph / 136 + 0.5 + 0.002;
    const double k = shot.ball_g / 28.349523125 * 21 * 21 / 9600;  // ball in oz, lever 33 − 6 − 6 in, MOI in oz·in²
    sum += besr;
    bbcor += (besr - 0.5) * (1 + k) + k;
  }
  const double besr = sum / 6, swing_mph = 60 * 27.0 / 28 * std::pow(15000.0 / 9600, 0.3);
  for (const PerformanceMetric metric :
       {PerformanceMetric::besr, PerformanceMetric::ncaa_besr, PerformanceMetric::bbcor}) {
    s.metric = metric;
    const Certification c = certify(s);
    ASSERT_EQ(c.best_location, 0U);
    const LocationMetrics& m = c.locations[0].metrics;
    EXPECT_NEAR(m.besr, besr, kRounding);
    EXPECT_NEAR(m.ncaa_besr, besr, kRounding);  // at 136 mph both are the same
    EXPECT_NEAR(*m.bbcor, bbcor / 6, kRounding);
    EXPECT_NEAR(*m.swing_mph, swing_mph, 1e-9);
    EXPECT_NEAR(*m.bbs_mph, 70 * (besr - 0.5) + swing_mph * (besr + 0.5), 1e-9);
    EXPECT_NEAR(c.locations[0].mean, metric == PerformanceMetric::bbcor ? *m.bbcor : m.besr, kRounding);
  }
  s.metric = PerformanceMetric::besr;
  s.bat.moi_ozin2.reset();
  EXPECT_FALSE(certify(s).locations[0].metrics.bbcor || certify(s).locations[0].metrics.bbs_mph);
}

TEST(Certify, NamesNoBestLocationOfAFlatBat) {
  Session s = fresh_session();
  run_session(s, [](double z) { return 0.7 - 0.0001 * z; });
  EXPECT_EQ(certify(s).verdict, CertifyVerdict::undecided);
  EXPECT_THAT(certify(s).next.message,
              HasSubstr("13 adjacent locations, 3 to 9 in, are within the margin, up to an end"));
  EXPECT_THAT(certify(s).next.message, testing::Not(HasSubstr("best")));
}

}  // namespace percuss::metrics::certify_test
