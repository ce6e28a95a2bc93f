#pragma once
/// Deflection under an impact, from the acceleration.
///
/// @code
/// #include <iostream>
/// #include <percuss/deflection.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::Record record = percuss::synthesise_preset("wood-bat").record;
///   const percuss::Deflections deflections(record, {.free_body = true});
///   for (const percuss::PointDeflection& at : deflections.points())
///     std::cout << "point " << at.point << ": " << at.peak_m << " ± " << at.std_m << " m\n";
/// }
/// @endcode
#include <percuss/analysis.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace percuss {

namespace api {
struct DeflectionData;
}

/// automatic: modal if force and modes are known and the record does not show the structure at rest before the impact;
/// otherwise drift_free.
enum class DeflectionMethod { automatic, small_interval, drift_free, frequency, modal };

struct DeflectionOptions {
  AnalysisOptions analysis{};
  DeflectionMethod method = DeflectionMethod::automatic;
  double highpass_corner_Hz = 0;              // of the charge amplifier, first order; 0: none
  std::optional<double> lowest_Hz{};          // for `frequency`; default: half the frequency of the largest line
  bool free_body = false;                     // the structure may move away from its rest position
  std::optional<double> effective_mass_kg{};  // of the free body at the struck point
  std::optional<double> beam_distance_m{};    // from the light beam to the structure: gives the ball's speed
  double beam_time_s = 0;                     // when the ball broke the beam, from the row's beginning
  std::vector<double> positions_m{};          // of the points, in ascending order of their numbers
};

/// One impact, measured by one accelerometer.
struct HitDeflection {
  std::size_t hit = 0, channel = 0;
  int point = 0;
  double first_s = 0;  // of the first sample, from the row's beginning
  std::vector<double> velocity_mps, deflection_m;
  std::vector<double> std_m;          // of the deflection; empty where the method gives none
  double peak_m = 0, peak_std_m = 0;  // signed; NaN where no deflection is significant
  double peak_time_s = 0;             // from the row's beginning
};

/// The mean over the hits at one point, for one channel.
struct PointDeflection {
  int point = 0;
  std::size_t channel = 0, hits = 0;
  std::optional<double> position_m{};
  // Mean of the peaks, signed, and its standard deviation; NaN where no hit has a peak or their directions differ.
  double peak_m = 0, std_m = 0;
};

/// The ball's speed between the light beam and the structure.
struct ImpactSpeed {
  std::size_t hit = 0;
  double speed_mps = 0, std_mps = 0;
};

/// Copies share the results.
/// Hits that Analysis rejects have a deflection too, with these exceptions. Hits in reject_hit have none. Hits without
/// a pulse, with too many lost samples or with a clipped acceleration have one only if they are in accept_hit. The
/// modal method uses hits with a clipped acceleration in any case.
/// errors  InputError, of the constructor: options that contradict each other, several runs (see Record::runs), samples
///         that cannot be read, no force or no mode where the options need them, a number of positions that differs
///         from the number of points.
class Deflections {
 public:
  explicit Deflections(const Record& record, const DeflectionOptions& options = {});

  std::vector<HitDeflection> hits() const;  // hit by hit, channel by channel
  std::vector<PointDeflection> points() const;
  std::vector<ImpactSpeed> speeds() const;
  std::vector<Warning> warnings() const;
  /// The document percuss/deflection/1, as `percuss deflect --json` prints it.
  std::string json() const;

  const api::DeflectionData& data() const { return *data_; }

 private:
  std::shared_ptr<const api::DeflectionData> data_;
};

}  // namespace percuss
