#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/shapes/mac.hpp"

namespace percuss::metrics {

/// Places at which two shapes must be known to be compared.
inline constexpr std::size_t kMinPlaces = 3;

/// A mode of a test or a model, with the properties that its document states.
struct ComparedMode {
  double freq_Hz = 0;
  double freq_std_Hz = 0;  // 0: not stated
  std::optional<double> damping_ratio{};
  double damping_std = 0;  // 0: not stated
  std::string family;      // "bending", "hoop"; "" or "unknown": any
  bool second = false;     // second peak of a split mode: it pairs only with second peaks and unclassified modes
  int order = 0;           // within the family, from 1; 0: not stated
  double confidence = 0;   // of the family
  struct Component {
    std::complex<double> value;
    double std = 0;
  };
  std::map<std::pair<int, int>, Component> shape;  // by point and channel (-1: every sensor); empty: none
};

/// The place of a point of the shapes.
struct ComparedPlace {
  int number = 0;  // of the point, as texts show it
  std::optional<std::array<double, 3>> xyz_m{};
  std::optional<std::array<double, 3>> direction{};  // unit vector in which a positive value points
};

/// The largest deflection under an impact.
struct ComparedDeflection {
  std::optional<int> point;          // of a test
  std::optional<double> position_m;  // along the structure
  double peak_m = 0, std_m = 0;
};

/// The contents of a document that can be compared.
struct ComparedDocument {
  std::string name, schema;  // "bat.json", "percuss/analysis/1"
  bool model = false;        // the document is a prediction
  std::vector<ComparedMode> modes;
  std::vector<ComparedDeflection> deflections;
  std::map<int, ComparedPlace> places{};  // by the point of ComparedMode::shape; a point without one has its own number
};

/// The modes of one family and order in a document (3a, 3b), ascending by frequency. Modes of 0 Hz are left out.
std::vector<std::size_t> modes_of_order(const ComparedDocument& document, const std::string& family, int order);

/// Orders of a family that contradict the frequencies: all from `from` on.
struct DoubtedOrders {
  std::string family;
  int from = 0;
};

struct PairOptions {
  double furthest = 0.25;           // largest difference of frequency, relative to the first document's
  double furthest_of_orders = 0.5;  // the same limit, for modes that pair by order
  double min_mac = 0.6;             // smallest MAC, if both modes have shapes
};

/// What paired two modes.
enum class PairedBy { shape, order, frequency };
/// "shape", "order" or "frequency".
const char* name_of(PairedBy by);

struct ModePair {
  std::size_t a = 0, b = 0;  // indices of the modes
  PairedBy by = PairedBy::frequency;
  double difference_percent = 0;  // of b relative to a
  std::optional<double> difference_std_percent;
  std::optional<double> damping_difference_percent{};  // if both state a damping ratio above zero
  std::optional<double> damping_difference_std_percent{};
  std::optional<identify::Mac> mac{};         // if both modes have shapes
  std::vector<std::size_t> exchangeable_a{};  // modes of other pairs whose partner may be b instead; ascending
};

struct PairedModes {
  std::vector<ModePair> pairs;  // ascending by a
  std::vector<std::size_t> unpaired_a, unpaired_b;
  std::vector<DoubtedOrders> doubted_orders;
};

/// Pairs the modes of two documents, by shape, then by order, then by frequency. A bending mode never pairs with a hoop
/// mode. Modes of 0 Hz (rigid-body modes) are left out.
///   shape      Two modes with shapes at three common places or more pair by shape only, the best MAC first, if their
///              frequencies differ by at most PairOptions::furthest. Shapes are compared at equal points: see
///              common_places().
///   order      Modes of equal family and order pair if CommonOrders::hold, and if their frequencies differ by at most
///              furthest_of_orders. Of several peaks of one order (3a and 3b), the lower pairs with the lower, however
///              far apart they are. If one document has more peaks of an order, its upper peaks have no partner; the
///              first peak of a split mode stands for it.
///   frequency  The remaining modes pair in ascending order, up to PairOptions::furthest apart: the number of pairs is
///              maximised, then the sum of |ln(f_b/f_a)| is minimised.
/// Frequencies cannot show that two modes changed places. Two pairs without a MAC are therefore named as exchangeable
/// if their modes could also pair crosswise, and if the two modes of one document lie no further apart than the two
/// modes of one of the pairs.
PairedModes pair_modes(const ComparedDocument& a, const ComparedDocument& b, const PairOptions& options = {});

/// Two modes without a partner whose shapes agree (MAC of 0.9 or more), although their frequencies differ by more than
/// PairOptions::furthest, as after a stiffener was added.
struct DistantPair {
  std::size_t a = 0, b = 0;  // indices of the modes
  identify::Mac mac;
  double difference = 0;  // of b relative to a
  double furthest = 0;    // a value of PairOptions::furthest that pairs them
};

/// The distant pairs among the modes that pair_modes(a, b, options) left without a partner, ascending by a. The
/// frequencies of a pair differ by a factor of two at most.
std::vector<DistantPair> distant_pairs(const ComparedDocument& a, const ComparedDocument& b, const PairedModes& paired,
                                       const PairOptions& options = {});

/// The MAC of two modes at their common places; nothing for fewer than three.
std::optional<identify::Mac> mac_between(const ComparedMode& a, const ComparedMode& b);

struct DeflectionPair {
  std::optional<int> point;
  std::optional<double> position_m;
  double a_m = 0, b_m = 0;
  double ratio = 0, ratio_std = 0;  // model/test if one document is a model, otherwise b/a
};

/// Pairs the largest deflections (peak_m) at the same place. The test leads if the other document is a model,
/// otherwise `a` leads. Each deflection of the leading document is paired at its position (interpolated in a model's
/// sweep), or at its point if it has no position.
std::vector<DeflectionPair> pair_deflections(const ComparedDocument& a, const ComparedDocument& b);

}  // namespace percuss::metrics
