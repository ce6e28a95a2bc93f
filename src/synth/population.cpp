#include "synth/population.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/resolution.hpp"
#include "synth/random_stream.hpp"

namespace percuss::synth {
namespace {

constexpr double kBall_kg = 0.1454, kSweetSpot_in = 6;
constexpr double kHighestHoop_Hz = 2800;
constexpr std::uint64_t kPopulationStream = 0x62617473;  // "bats"

class PopulationMaker {
 public:
  explicit PopulationMaker(const PopulationSpec& spec) : spec_(spec), random_({spec.seed, kPopulationStream}) {}

  std::vector<metrics::StudyBat> make() {
    for (std::size_t i = 0; i < spec_.wood; ++i) bats_.push_back(wood());
    for (std::size_t i = 0; i < spec_.aluminum; ++i)
      bats_.push_back(hollow(metrics::BarrelMaterial::aluminum, 1800, 2400));
    for (std::size_t i = 0; i < spec_.composite; ++i)
      bats_.push_back(hollow(metrics::BarrelMaterial::composite, 1300, 2800));
    if (spec_.break_in) add_break_in();
    for (std::size_t b = 0; b < bats_.size(); ++b) bats_[b].id = fmt::format("S{:03}", b + 1);
    return std::move(bats_);
  }

 private:
  double normal(double sigma) {
    std::array<double, 2> pair{};
    random_.add_normal(sigma, pair);
    return pair[0];
  }

  static std::optional<double>& at(metrics::StudyBat& bat, metrics::StudyQuantity q) {
    return bat.values.at(static_cast<std::size_t>(q));
  }

  // A bat of this length, with its drop, MOI and bending frequencies.
  metrics::StudyBat body(metrics::BarrelMaterial material, double length_in, double drop, double moi_33_ozin2,
                         double bending_Hz) {
    metrics::StudyBat bat{.length_in = length_in, .material = material};
    at(bat, metrics::StudyQuantity::drop) = metrics::round_to_step(drop, 0.005);
    at(bat, metrics::StudyQuantity::moi) =
        metrics::round_to_step(moi_33_ozin2 + 850 * (length_in - 33) + 300 * (drop + 3) + normal(250), 1);
    at(bat, metrics::StudyQuantity::bending1) = metrics::round_to_step(bending_Hz - 9 * (length_in - 33), 0.1);
    at(bat, metrics::StudyQuantity::bending2) =
        metrics::round_to_step(3.6 * *at(bat, metrics::StudyQuantity::bending1) + normal(10), 0.1);
    return bat;
  }

  void perform(metrics::StudyBat& bat, double bbcor) {
    const double length_m = bat.length_in * kInch_m, z_m = kSweetSpot_in * kInch_m;
    const double moi_kgm2 = *at(bat, metrics::StudyQuantity::moi) * metrics::kOunceInch2_kgm2;
    const double k = metrics::ball_to_bat_inertia(kBall_kg, length_m, z_m, moi_kgm2);  // (P10)
    double besr = metrics::besr_from_bbcor(bbcor, k);                                  // (P9)
    double bbs_mph = metrics::batted_ball_speed_mps(besr, metrics::swing_speed_mps(length_m, z_m, moi_kgm2)) /
                     kMilePerHour_mps;  // (P8)
    if (!spec_.related) {
      bbcor = 0.49 + normal(0.01);
      besr = 0.70 + 0.005 * (bat.length_in - 33) + normal(0.01);
      bbs_mph = 96 + 1.5 * (bat.length_in - 33) + normal(1);
    }
    at(bat, metrics::StudyQuantity::besr) = metrics::round_to_step(besr, 1e-5);
    at(bat, metrics::StudyQuantity::bbs) = metrics::round_to_step(bbs_mph, 1e-3);
    at(bat, metrics::StudyQuantity::bbcor) = metrics::round_to_step(bbcor, 1e-5);
  }

  metrics::StudyBat wood() {
    const double length_in = 30 + std::floor(random_.uniform(0, 5));
    // Drawn before the call, because the order of evaluation of arguments is unspecified.
    const double bending_Hz = 155 + normal(14), drop = random_.uniform(-3, 0.5);
    metrics::StudyBat bat = body(metrics::BarrelMaterial::wood, length_in, drop, 10600, bending_Hz);
    perform(bat, 0.480 + normal(spec_.noise));
    return bat;
  }

  double hollow_bbcor(double hoop_Hz) {
    return 0.480 + spec_.hoop_gain * (kHighestHoop_Hz - hoop_Hz) + normal(spec_.noise);
  }

  metrics::StudyBat hollow(metrics::BarrelMaterial material, double low_Hz, double high_Hz) {
    const double length_in = 31 + std::floor(random_.uniform(0, 4));
    const double hoop_Hz = metrics::round_to_step(random_.uniform(low_Hz, high_Hz), 1);
    const double bending_Hz = 175 + normal(30), drop = random_.uniform(-3, -2.1);
    metrics::StudyBat bat = body(material, length_in, drop, 9600, bending_Hz);
    at(bat, metrics::StudyQuantity::hoop1) = hoop_Hz;
    at(bat, metrics::StudyQuantity::hoop2) = metrics::round_to_step(1.25 * hoop_Hz + normal(30), 1);
    bat.broken_in = material == metrics::BarrelMaterial::composite && hoop_Hz < 1700;
    perform(bat, hollow_bbcor(hoop_Hz));
    return bat;
  }

  void add_break_in() {
    constexpr std::array<double, 9> hoops_Hz{1970, 1880, 1800, 1720, 1630, 1550, 1450, 1354, 1340};
    const metrics::StudyBat fresh = hollow(metrics::BarrelMaterial::composite, 1960, 1980);
    for (std::size_t i = 0; i < hoops_Hz.size(); ++i) {
      metrics::StudyBat state = fresh;
      state.bat = "break-in";
      state.broken_in = i > 0;
      at(state, metrics::StudyQuantity::hoop1) = hoops_Hz[i];
      at(state, metrics::StudyQuantity::hoop2) = metrics::round_to_step(1.25 * hoops_Hz[i], 1);
      const bool cracked = i + 1 == hoops_Hz.size();
      perform(state, hollow_bbcor(hoops_Hz[i]) - (cracked ? 0.022 : 0));
      bats_.push_back(std::move(state));
    }
  }

  const PopulationSpec& spec_;
  RandomStream random_;
  std::vector<metrics::StudyBat> bats_;
};

}  // namespace

std::vector<metrics::StudyBat> synthetic_population(const PopulationSpec& spec) { return PopulationMaker(spec).make(); }

}  // namespace percuss::synth
