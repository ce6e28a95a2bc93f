#pragma once
/// A test of many points: mode shapes, MAC, modal masses, waves around a tube.
///
/// @code
/// #include <iostream>
/// #include <percuss/survey.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   // A geometry from a file: {.geometry = percuss::read_geometry("points.csv")}
///   const percuss::Record record = percuss::synthesise_preset("roving-barrel").record;
///   const percuss::Survey survey(record, {.analysis = {.band_Hz = percuss::Band{60, 3200}}});
///   const std::vector<percuss::Mode> modes = survey.modes();
///   const std::vector<percuss::ModeShape> shapes = survey.shapes();
///   for (std::size_t m = 0; m < modes.size(); ++m)
///     std::cout << modes[m].freq_Hz << " Hz at " << shapes[m].places.size() << " points\n";
///   std::cout << "MAC of the first two: " << survey.macs().at(0).at(1).value << '\n';
/// }
/// @endcode
#include <percuss/analysis.hpp>

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

namespace api {
struct SurveyData;
}

/// Where a point lies: coordinates, or a place on a tube, or both.
struct GeometryPoint {
  int point = 0;  // its number: in the record, or in the name of the point's file
  std::optional<std::array<double, 3>> xyz_m{};
  double position_m = 0;                         // along the tube's axis, from the barrel's end
  double angle_rad = 0;                          // around the axis
  double radius_m = 0;                           // for drawings; 0: not known
  std::optional<std::array<double, 3>> along{};  // unit vector of a positive value: of the blow or of the sensor
};

struct Geometry {
  std::vector<GeometryPoint> points;
  bool tube = false;                        // position and angle are known for every point
  bool unit_assumed = false;                // the file states no unit: its lengths are taken as m
  std::size_t axis = 0;                     // of the tube: 0, 1, 2 for x, y, z; x without coordinates
  std::vector<std::array<int, 2>> lines{};  // drawn between points, by number; empty: none stated
  std::vector<std::vector<int>> faces{};    // drawn between three corners or more, in order around each, by number
};

/// Reads "point, x_m, y_m, z_m" or "point, position_m, angle_deg" from a text file, with the lines and faces that it
/// states, and directions of blows or sensors. Points around an axis become a tube. Lengths without a unit count as m.
/// errors  InputError: not such a file; lengths above 10 without a unit.
Geometry read_geometry(const std::string& path);

/// The part that moves from point to point; the other one stays.
enum class Roving { hammer, sensor };

/// A struck point right beside the sensor of a channel.
struct DrivingPoint {
  std::size_t point = 0, channel = 0;
};

struct SurveyOptions {
  AnalysisOptions analysis{};
  std::optional<Geometry> geometry{};         // default: the record's own
  std::optional<Roving> roving{};             // default: as the record states, else the hammer
  std::vector<DrivingPoint> driving_point{};  // default: the record's own, else points where a sensor sits
};

/// The value of a mode shape at one point and channel.
struct ShapePlace {
  std::size_t point = 0, channel = 0;  // roving hammer: channel is 0, as all sensors contribute to the point
  std::complex<double> value;          // 1/√kg with unit modal mass, else 1 at the largest
  double std = 0;                      // of the real and of the imaginary part
};

struct ModeShape {
  std::vector<ShapePlace> places;         // ascending by point, then channel
  std::vector<ShapePlace> sensors;        // roving hammer: the same shape at the fixed sensors; point is 0
  bool unit_modal_mass = false;           // false: 1 at the largest
  double scale_std = 0;                   // for unit modal mass: relative, of the common scale
  std::optional<double> modal_mass_kg{};  // of the shape with 1 at the largest; needs a driving point
  double modal_mass_std_kg = 0;
  double mpc = 0;  // modal phase collinearity: 1 for a real shape, 0 for a travelling wave
};

/// Modal assurance criterion. 0: orthogonal, 1: the same shape.
struct Mac {
  double value = 0, std = 0;
};

/// A shape on a tube: axial functions times cos nθ.
struct TubeShape {
  std::vector<double> energy;  // [n] fraction of the shape's energy
  int order = 0;               // the n that holds the most: 0 breathing, 1 bending, 2 and above hoop
  double confidence = 0;
  std::optional<double> plane_rad{};  // an antinode, 0 … π/n; none for n = 0, or where it is not observable
  double plane_std_rad = 0;
  std::vector<double> position_m, axial, axial_std;  // [rings]; the axial function of this order
};

/// Copies share the results. One thread at a time may call the accessors.
/// errors  InputError, of the constructors: a point without a place in the geometry; a line or a face of the geometry
///         with a point that it does not list, or with too few points; a tube with another axis than 0, 1 or 2; a
///         driving point that was not measured; several runs. Accessors as Analysis.
class Survey {
 public:
  explicit Survey(const Record& record, const SurveyOptions& options = {});
  explicit Survey(const FrfSet& frfs, const SurveyOptions& options = {});

  /// Hits, FRFs, modes.
  Analysis analysis() const;
  std::optional<Geometry> geometry() const;
  /// The modes of the shapes, ascending: the modes of the analysis, but two modes in place of each mode whose residues
  /// at several sensors need two shapes.
  std::vector<Mode> modes() const;
  std::vector<ModeShape> shapes() const;                    // [modes]
  std::vector<std::optional<TubeShape>> tubes() const;      // [modes]; no value where the shape is not on a tube
  std::vector<ModeClassification> classifications() const;  // [modes]; by the shapes on a tube, else as Analysis
  std::vector<std::vector<Mac>> macs() const;               // [modes][modes], symmetric
  std::vector<Warning> warnings() const;                    // of the analysis and of the survey

  /// The document percuss/analysis/1, as `percuss survey --json` prints it.
  std::string json() const;
  std::string text(std::size_t width = 100) const;

  const api::SurveyData& data() const { return *data_; }

 private:
  std::shared_ptr<const api::SurveyData> data_;
};

}  // namespace percuss
