#include "pipeline/survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "support/changed_record.hpp"
#include "support/input_error.hpp"
#include "synth/structure.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::survey_test {

using std::numbers::pi;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

constexpr double kDeviations = 5;  // allowed standard deviations; 5, because dozens of values are compared

// An aluminium bat whose first hoop mode is split.
synth::SynthSpec barrel() {
  synth::SynthSpec spec;
  spec.fs_Hz = 8192;
  spec.samples = 8192;  // all modes have decayed by then: truncated records take much longer to fit
  spec.seed = 4;
  spec.band_high_Hz = 3000;
  const auto mode = [&](double freq_Hz, double damping, synth::SynthModeType type, int order, double angle_deg) {
    spec.modes.push_back({.freq_Hz = freq_Hz,
                          .damping_ratio = damping,
                          .type = type,
                          .order = order,
                          .angle_rad = angle_deg * kDegree_rad,
                          .amplitude_per_sqrt_kg = 2});
  };
  mode(205, 0.02, synth::SynthModeType::bending, 1, 20);
  mode(690, 0.008, synth::SynthModeType::bending, 2, 20);
  mode(1900, 0.004, synth::SynthModeType::hoop, 1, 12);
  mode(1912, 0.0044, synth::SynthModeType::hoop, 1, 57);
  mode(2700, 0.003, synth::SynthModeType::hoop, 2, 5);
  spec.pulse.width_s = 0.25e-3;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  spec.hits = 2;
  return spec;
}

// Sets one sensor, and rings of 8 impact points on the barrel.
synth::SynthSpec roving(synth::SynthSpec spec, int rings = 5) {
  spec.sensors = {{.position_m = 0.05, .angle_rad = 0}};
  spec.points.clear();
  for (int ring = 0; ring < rings; ++ring) {
    for (int a = 0; a < 8; ++a) spec.points.push_back({.position_m = 0.05 + 0.06 * ring, .angle_rad = a * pi / 4});
  }
  return spec;
}

// Without a limit of time, which sanitizers on a busy machine would exceed.
AnalysisOptions in_band() { return {.band_Hz = std::pair{60.0, 3000.0}, .budget = Budget{}}; }

// Two sensors 90° apart, and both planes of two bending modes at one frequency, or `split` apart.
synth::SynthSpec round_barrel(double split, std::uint64_t seed) {
  synth::SynthSpec spec = roving(barrel(), 3);
  spec.seed = seed;
  spec.sensors.push_back({.position_m = 0.05, .angle_rad = pi / 2});
  spec.modes.erase(spec.modes.begin() + 2, spec.modes.end());
  for (std::size_t m = 0; m < 2; ++m) {
    synth::SynthMode other = spec.modes[m];
    other.freq_Hz *= 1 + split;
    other.angle_rad += pi / 2;
    spec.modes.push_back(other);
  }
  std::swap(spec.modes[1], spec.modes[2]);  // ascending
  return spec;
}

std::vector<std::string> codes_of(const std::vector<Warning>& warnings) {
  std::vector<std::string> out;
  for (const Warning& warning : warnings) out.push_back(warning.code);
  return out;
}

TEST(RoundBarrelSurvey, HasBothModesOfEachPairOfPlanes) {
  for (const double split : {0.0, 5e-4}) {
    const synth::SyntheticTest made = synth::synthesise(round_barrel(split, 4));
    const Analysis analysis(made.record, in_band());
    const Survey survey(analysis, {});
    EXPECT_EQ(analysis.modes().size(), 2U) << split;
    ASSERT_EQ(survey.modes().size(), 4U) << split;
    ASSERT_EQ(survey.shapes().size(), 4U);
    for (std::size_t m = 0; m < 4; ++m) {
      EXPECT_EQ(survey.classifications()[m].type, identify::ModeType::bending) << split << " " << m;
      EXPECT_EQ(survey.classifications()[m].order, m < 2 ? 1 : 2) << split << " " << m;
      const identify::Mode& mode = survey.modes()[m];
      EXPECT_NEAR(mode.pole.freq_Hz, made.truth.spec.modes[m].freq_Hz, kDeviations * mode.freq_std_Hz) << split;
      ASSERT_TRUE(survey.tubes()[m] && survey.tubes()[m]->plane_rad);
      const double plane_rad = *survey.tubes()[m]->plane_rad, std_rad = survey.tubes()[m]->plane_std_rad;
      const auto off_rad = [&](double truth_rad) { return std::abs(std::remainder(plane_rad - truth_rad, pi)); };
      if (split > 0) {
        EXPECT_LT(off_rad(made.truth.spec.modes[m].angle_rad), kDeviations * std_rad) << m;
      } else {  // the planes of the sensors
        EXPECT_LT(std::min(off_rad(0), off_rad(pi / 2)), kDeviations * std_rad) << m;
      }
    }
    EXPECT_EQ(survey.split_modes().pairs.size(), 2U);
    const auto repeated = Contains(std::string("repeated_modes"));
    if (split > 0) {
      EXPECT_THAT(codes_of(survey.warnings()), Not(repeated));
    } else {
      EXPECT_THAT(codes_of(survey.warnings()), repeated);
    }
    EXPECT_THAT(codes_of(survey.warnings()), Not(Contains(std::string("moving_modes"))));
  }
}

// The survey of barrel(), computed once; the sensor sits at point 0.
class BarrelSurvey : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<synth::SyntheticTest>(synth::synthesise(roving(barrel())));
    analysis_ = std::make_unique<Analysis>(made_->record, in_band());
    survey_ = std::make_unique<Survey>(*analysis_, SurveyOptions{});
  }
  static void TearDownTestSuite() {
    survey_.reset();
    analysis_.reset();
    made_.reset();
  }
  static const synth::SynthSpec& spec() { return made_->truth.spec; }
  static double truth(std::size_t mode, std::size_t point) {
    return synth::mode_shape_per_sqrt_kg(spec().structure, spec().modes[mode], spec().points[point].position_m,
                                         spec().points[point].angle_rad);
  }
  inline static std::unique_ptr<synth::SyntheticTest> made_;
  inline static std::unique_ptr<Analysis> analysis_;
  inline static std::unique_ptr<Survey> survey_;
};

TEST_F(BarrelSurvey, FindsTheShapes) {
  constexpr double kAlike = 1e-5;  // noise over 40 points; measured 4e-7
  ASSERT_EQ(survey_->shapes().size(), 5U);
  for (std::size_t m = 0; m < 5; ++m) {
    identify::ShapeValues found, exact;
    for (const identify::ShapePlace& place : survey_->shapes()[m].places) {
      found.value.push_back(place.value);
      found.std.push_back(place.std);
      exact.value.emplace_back(truth(m, place.point));
      exact.std.push_back(0);
    }
    EXPECT_LE(1 - identify::mac(found, exact).value, kAlike) << m;
    EXPECT_GE(survey_->shapes()[m].mpc, 1 - kAlike) << m;
  }
}

TEST_F(BarrelSurvey, ScalesShapesToUnitModalMassByTheDrivingPoint) {
  ASSERT_EQ(survey_->driving_points().size(), 1U);
  EXPECT_EQ(survey_->driving_points()[0].point, 0U);
  for (std::size_t m = 0; m < 5; ++m) {
    const identify::ModeShape& shape = survey_->shapes()[m];
    ASSERT_EQ(shape.normalisation, identify::Normalisation::unit_modal_mass) << m;
    const double sign = truth(m, 0) < 0 ? -1 : 1;
    for (const identify::ShapePlace& place : shape.places) {
      const double exact = sign * truth(m, place.point);
      const double std = std::hypot(place.std, shape.scale_std * std::abs(exact));
      EXPECT_LE(std::abs(place.value.real() - exact), kDeviations * std) << m << " " << place.point;
    }
  }
}

TEST_F(BarrelSurvey, NamesModesFromTheirShapes) {
  constexpr std::array circumferential{1, 1, 2, 2, 2}, order{1, 2, 1, 1, 2};
  for (std::size_t m = 0; m < 5; ++m) {
    ASSERT_TRUE(survey_->tubes()[m]);
    EXPECT_EQ(survey_->tubes()[m]->order, circumferential.at(m));
    EXPECT_EQ(survey_->classifications()[m].type,
              circumferential.at(m) == 1 ? identify::ModeType::bending : identify::ModeType::hoop);
    EXPECT_EQ(survey_->classifications()[m].order, order.at(m));
    EXPECT_GE(survey_->classifications()[m].confidence, 0.95);
  }
  EXPECT_EQ(survey_->tubes()[2]->sign_changes, 0);
  EXPECT_EQ(survey_->tubes()[4]->sign_changes, 1);
}

TEST_F(BarrelSurvey, FindsThePlanesOfTheSplitHoopMode) {
  const auto& first = survey_->classifications()[2].split_mode;
  const auto& second = survey_->classifications()[3].split_mode;
  ASSERT_TRUE(first && second && first->planes && second->planes);
  EXPECT_NEAR(first->separation_Hz, 12, kDeviations * first->separation_std_Hz);
  EXPECT_NEAR(first->planes->own.plane_rad, 12 * kDegree_rad, kDeviations * first->planes->own.std_rad);
  EXPECT_NEAR(second->planes->own.plane_rad, 57 * kDegree_rad, kDeviations * second->planes->own.std_rad);
  EXPECT_EQ(first->planes->cause, identify::SplitCause::asymmetry);
  EXPECT_TRUE(first->quoted);
  EXPECT_FALSE(second->quoted);
}

TEST_F(BarrelSurvey, ExplainsTheFrfs) {
  ASSERT_EQ(survey_->synthesis().size(), 40U);
  for (const identify::SynthesisedFrf& frf : survey_->synthesis()) EXPECT_FALSE(poorly_explained(frf)) << frf.frac;
  EXPECT_EQ(static_cast<std::size_t>(survey_->indicator().rows()), survey_->band().count);
  EXPECT_EQ(survey_->analysis().frf_points().size(), 40U);
}

TEST_F(BarrelSurvey, AgreesWithTheTwoAccelerometerTest) {
  // [8] in docs/theory/sources.md, appendix A: the two-accelerometer test names the same modes as the survey.
  synth::SynthSpec quick = barrel();
  quick.points = {{.position_m = 0.11, .angle_rad = 35 * kDegree_rad}};
  quick.sensors = {{.position_m = 0.05, .angle_rad = 0}, {.position_m = 0.05, .angle_rad = pi / 2}};
  quick.hits = 5;
  const Analysis analysis(synth::synthesise(quick).record, in_band());
  ASSERT_EQ(analysis.modes().size(), survey_->shapes().size());
  for (std::size_t m = 0; m < 5; ++m) {
    const identify::Mode& a = analysis.modes()[m];
    const identify::Mode& b = analysis_->modes()[m];
    EXPECT_LE(std::abs(a.pole.freq_Hz - b.pole.freq_Hz), kDeviations * std::hypot(a.freq_std_Hz, b.freq_std_Hz)) << m;
    EXPECT_LE(std::abs(a.pole.damping_ratio - b.pole.damping_ratio),
              kDeviations * std::hypot(a.damping_std, b.damping_std))
        << m;
    EXPECT_EQ(analysis.classifications()[m].type, survey_->classifications()[m].type) << m;
    EXPECT_EQ(analysis.classifications()[m].order, survey_->classifications()[m].order) << m;
    EXPECT_EQ(analysis.classifications()[m].split_mode.has_value(),
              survey_->classifications()[m].split_mode.has_value())
        << m;
  }
}

TEST_F(BarrelSurvey, LeavesModeTypesUnknownWithoutAGeometry) {
  acquire::Record record = made_->record;
  record.geometry.clear();
  const Analysis analysis(record, in_band());
  const Survey survey(analysis, {});
  EXPECT_FALSE(survey.geometry());
  for (const auto& tube : survey.tubes()) EXPECT_FALSE(tube);
  for (const identify::ModeClassification& classification : survey.classifications())
    EXPECT_EQ(classification.type, identify::ModeType::unknown);
  EXPECT_THAT(survey.warnings(), Contains(Field(&Warning::code, "no_geometry")));
}

TEST_F(BarrelSurvey, TakesWhatMovedFromTheRecord) {
  acquire::Record record = made_->record;
  record.sensor_roves = true;
  const Analysis analysis(record, in_band());
  EXPECT_EQ(Survey(analysis, {}).roving(), identify::Roving::sensor);
  EXPECT_EQ(Survey(analysis, {.roving = identify::Roving::hammer}).roving(), identify::Roving::hammer);
  EXPECT_EQ(survey_->roving(), identify::Roving::hammer);
}

// A point struck in a further direction lies at the place of another point.
TEST_F(BarrelSurvey, PlacesSeveralPointsAtOnePlace) {
  acquire::Record record = made_->record;
  for (acquire::RowInfo& row : record.rows) {
    if (row.point == 7) row.point = 107;
  }
  const Analysis unplaced(record, in_band());
  EXPECT_THAT(test::input_error_of([&] { const Survey survey(unplaced, {.geometry = survey_->geometry()}); }),
              HasSubstr("the geometry lacks point 107"));
  record.motions.push_back({.point = 107, .place = 7});
  const Analysis analysis(record, in_band());
  const Survey survey(analysis, {.geometry = survey_->geometry()});
  EXPECT_EQ(survey.place_of(107), 7);
  EXPECT_EQ(survey.places().size(), 40U);
}

TEST_F(BarrelSurvey, RefusesPointsThatTheGeometryLacks) {
  acquire::Geometry geometry = *survey_->geometry();
  geometry.points.erase(geometry.points.begin());
  const std::string message = test::input_error_of(
      [&] { const Survey survey(*analysis_, {.geometry = geometry, .geometry_source = "points.csv"}); });
  EXPECT_THAT(message, HasSubstr("the geometry lacks point 0, which was measured (points.csv)"));
  EXPECT_THAT(message, HasSubstr("0 to 39"));
  EXPECT_THAT(
      test::input_error_of([&] { const Survey survey(*analysis_, {.driving = {{.point = 40, .channel = 0}}}); }),
      HasSubstr("point 40 with channel 0 was not measured"));
}

TEST(Survey, WarnsOfASensorOnANode) {
  // The sensor lies almost in the plane of the bending mode. A mode that bends at right angles to it would have a node
  // there.
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(1);
  spec.modes[0].angle_rad = 1 * kDegree_rad;
  const Analysis analysis(synth::synthesise(spec).record, in_band());
  const Survey survey(analysis, {});
  ASSERT_EQ(survey.shapes().size(), 1U);
  const auto warnings = survey.warnings();
  ASSERT_THAT(warnings, Contains(Field(&Warning::code, "sensor_on_node")));
  EXPECT_THAT(warnings, Contains(Field(&Warning::message, HasSubstr("antinode at 91°"))));
}

TEST(Survey, NamesTheSensorOnANode) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(1);
  spec.modes[0].angle_rad = 0;
  spec.sensors.push_back({.position_m = 0.05, .angle_rad = pi / 2});
  const Analysis analysis(synth::synthesise(spec).record, in_band());
  const auto warnings = Survey(analysis, {}).warnings();
  EXPECT_THAT(warnings, Contains(Field(&Warning::message, HasSubstr("accel 2 sits on a node of mode 1"))));
}

TEST(Survey, NamesAllModesOfASensorOnTheirNodes) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(2);
  for (synth::SynthMode& mode : spec.modes) mode.angle_rad = 0;
  spec.sensors.push_back({.position_m = 0.05, .angle_rad = pi / 2});
  const Analysis analysis(synth::synthesise(spec).record, in_band());
  EXPECT_THAT(Survey(analysis, {}).warnings(),
              Contains(Field(&Warning::message, HasSubstr("accel 2 sits on a node of modes 1 (205.0 Hz), 2 (690.0 Hz): "
                                                          "only the other sensors measure their shapes"))));
}

TEST(Survey, TakesTheDrivingPointsThatTheRecordStates) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(1);
  acquire::Record record = synth::synthesise(spec).record;
  record.geometry.clear();  // no position shows a driving point
  const Analysis silent(record, in_band());
  EXPECT_TRUE(Survey(silent, {}).driving_points().empty());
  record.driving = {{.point = 1, .channel = 0}};
  const Analysis stated(record, in_band());
  ASSERT_EQ(Survey(stated, {}).driving_points().size(), 1U);
  EXPECT_EQ(Survey(stated, {}).driving_points()[0].point, 1U);
  EXPECT_EQ(Survey(stated, {.driving = {{.point = 2, .channel = 0}}}).driving_points()[0].point, 2U)
      << "the user's choice";
}

// One file per point, P1.csv to P16.csv, and a geometry that counts from 1: the user's point 7 is P7.csv.
TEST(Survey, TakesTheNumberOfADrivingPointFromTheNameOfItsFile) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(1);
  acquire::Record record = synth::synthesise(spec).record;
  acquire::Geometry geometry = acquire::geometry_of_record(record.geometry).value();
  acquire::shift_points(geometry, 1);
  record.geometry.clear();  // no position shows a driving point
  record.files.clear();
  for (std::size_t p = 0; p < 16; ++p) record.files.push_back({.path = "P" + std::to_string(p + 1) + ".csv"});
  for (acquire::RowInfo& row : record.rows) row.file = static_cast<std::size_t>(row.point);
  const Analysis analysis(record, in_band());
  const Survey numbered(analysis, {.geometry = geometry, .stated_driving = {{.point = 7}}});
  ASSERT_EQ(numbered.driving_points().size(), 1U);
  EXPECT_EQ(numbered.driving_points()[0].point, 6U);
  EXPECT_THAT(numbered.warnings(), Contains(Field(&Warning::code, "driving_point_numbers")));
  const Survey named(analysis, {.geometry = geometry, .stated_driving = {{.file = "P7"}}});
  EXPECT_EQ(named.driving_points().at(0).point, 6U);
  EXPECT_THAT(named.warnings(), Not(Contains(Field(&Warning::code, "driving_point_numbers"))));
  const Survey own(analysis, {.geometry = geometry, .driving = {{.point = 7, .channel = 0}}});
  EXPECT_EQ(own.driving_points().at(0).point, 7U) << "the record's number, as in C++";
  EXPECT_THAT(
      test::input_error_of([&] { const Survey survey(analysis, {.stated_driving = {{.point = 7, .channel = 1}}}); }),
      HasSubstr("with channel 1 was not measured"));
}

// P7.csv is missing. Without the numbers in the names, the shape at P8 would be drawn at point 7, and so on.
TEST(Survey, PlacesFilesByTheNumbersInTheirNames) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(2);
  const synth::SyntheticTest made = synth::synthesise(spec);
  acquire::Geometry geometry = acquire::geometry_of_record(made.record.geometry).value();
  acquire::shift_points(geometry, 1);
  constexpr int kMissing = 6;  // as an index
  acquire::Record record =
      acquire::select_rows(made.record, [](const acquire::RowInfo& row) { return row.point != kMissing; });
  record.geometry.clear();
  record.files.clear();
  for (std::size_t p = 0; p < 16; ++p) {
    if (p != kMissing) record.files.push_back({.path = "P" + std::to_string(p + 1) + ".csv"});
  }
  for (acquire::RowInfo& row : record.rows) {
    if (row.point > kMissing) --row.point;
    row.file = static_cast<std::size_t>(row.point);
  }
  const Analysis analysis(record, in_band());
  const auto mac_with_truth = [&](const acquire::Geometry& of) {
    const Survey survey(analysis, {.geometry = of});
    double least = 1;
    for (std::size_t m = 0; m < 2; ++m) {
      double product = 0, own = 0, true_ones = 0;
      for (const identify::ShapePlace& place : survey.shapes()[m].places) {
        const int number = survey.stated_number(static_cast<int>(place.point));
        const double truth = made.truth.residue_per_kg.at(static_cast<std::size_t>(number - 1))[0][m];
        product += place.value.real() * truth;
        own += std::norm(place.value);
        true_ones += truth * truth;
      }
      least = std::min(least, product * product / (own * true_ones));
    }
    return least;
  };
  constexpr double kMinMac = 0.9999;  // noise of 1e-3
  EXPECT_GT(mac_with_truth(geometry), kMinMac);
  const Survey survey(analysis, {.geometry = geometry});
  EXPECT_THAT(survey.warnings(),
              Contains(Field(&Warning::message, HasSubstr("1 of the geometry's 16 points were not measured: 7; each "
                                                          "file is the point of the number in its name"))));
  acquire::Geometry without = geometry;
  std::erase_if(without.points, [](const acquire::GeometryPoint& p) { return p.point == kMissing + 1; });
  EXPECT_GT(mac_with_truth(without), kMinMac);
  std::erase_if(without.points, [](const acquire::GeometryPoint& p) { return p.point == 16; });
  EXPECT_THAT(test::input_error_of([&] { const Survey refused(analysis, {.geometry = without}); }),
              HasSubstr("the geometry lacks point 16, the number in the name of P16.csv"));
}

TEST(Survey, WarnsOfAWrongDrivingPointSignAndBrokenReciprocity) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(2);
  spec.sensors.push_back({.position_m = 0.11, .angle_rad = pi / 4, .gain = 1.2});
  const Analysis good(synth::synthesise(spec).record, in_band());
  ASSERT_EQ(Survey(good, {}).driving_points().size(), 2U);
  EXPECT_THAT(Survey(good, {}).warnings(), Contains(Field(&Warning::code, "reciprocity")));
  spec.sensors[0].sign = -1;
  const Analysis bad(synth::synthesise(spec).record, in_band());
  EXPECT_THAT(Survey(bad, {}).warnings(), Contains(Field(&Warning::code, "driving_point_sign")));
}

// The blows go against the sensor. If the geometry does not state this, the remedy of the warning names what to state.
TEST(Survey, AllowsForBlowsAgainstTheSensor) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.modes.resize(2);
  const auto masses_of = [](const Survey& survey) {
    std::vector<double> out;
    for (const identify::ModeShape& shape : survey.shapes()) out.push_back(shape.modal_mass_kg.value_or(0));
    return out;
  };
  AnalysisOptions options = in_band();
  options.classes.object = identify::ObjectKind::other;
  const std::vector<identify::DrivingPoint> driving{{.point = 0, .channel = 0}};
  const acquire::Record aligned = synth::synthesise(spec).record;
  const Analysis first(aligned, options);
  const auto masses = masses_of(Survey(first, {.driving = driving}));
  ASSERT_EQ(masses.size(), 2U);
  EXPECT_GT(masses[0], 0);
  spec.sensors[0].sign = -1;
  acquire::Record record = synth::synthesise(spec).record;
  record.accel[0].axis = acquire::Direction{0, 0, 1};
  const Analysis analysis(record, options);
  acquire::Geometry geometry;
  for (int p = 0; p < 16; ++p) geometry.points.push_back({.point = p, .xyz_m = std::array<double, 3>{0.1 * p, 0, 0}});
  const Survey unstated(analysis, {.geometry = geometry, .driving = driving});
  const auto warnings = unstated.warnings();
  const auto sign =
      std::find_if(warnings.begin(), warnings.end(), [](const auto& w) { return w.code == "driving_point_sign"; });
  ASSERT_NE(sign, warnings.end());
  EXPECT_THAT(sign->remedy, HasSubstr("without a set-up, the scale -1"));
  EXPECT_THAT(sign->options, testing::ElementsAre("setup", "accel_scale"));
  for (acquire::GeometryPoint& point : geometry.points) point.along = acquire::Direction{0, 0, -1};
  const Survey stated(analysis, {.geometry = geometry, .driving = driving});
  EXPECT_THAT(stated.warnings(), Not(Contains(Field(&Warning::code, "driving_point_sign"))));
  const auto found = masses_of(stated);
  ASSERT_EQ(found.size(), masses.size());
  for (std::size_t m = 0; m < found.size(); ++m) EXPECT_NEAR(found[m], masses[m], 1e-3 * masses[m]) << m;
}

// The second of two fixed sensors was mounted the other way round before the last four points were struck.
TEST(SurveyWarnings, NameThePointsAtWhichASensorWasReversed) {
  synth::SynthSpec spec = roving(barrel(), 2);
  spec.sensors.push_back({.position_m = 0.05, .angle_rad = 40 * kDegree_rad});
  const acquire::Record good = synth::synthesise(spec).record;
  const auto disagreement_message = [&](const acquire::Record& record) {
    const Analysis analysis(record, in_band());
    std::string message;
    for (const Warning& warning : Survey(analysis, SurveyOptions{}).warnings()) {
      if (warning.code == "sensors_disagree") message += warning.message;
    }
    return message;
  };
  EXPECT_EQ(disagreement_message(good), "");
  const acquire::Record reversed =
      test::with_changed_accel(good, [&](std::size_t row, std::size_t channel, std::vector<double>& x) {
        if (channel == 1 && good.rows[row].point >= 12)
          for (double& value : x) value = -value;
      });
  EXPECT_THAT(disagreement_message(reversed),
              HasSubstr("at points 12, 13, 14, 15 it is -1 times this: one of them was reversed"));
}

}  // namespace percuss::pipeline::survey_test
