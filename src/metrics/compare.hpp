#pragma once
#include <complex>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/shapes/mac.hpp"

namespace percuss::metrics {

/// A mode of a test or a model, as far as its document tells.
struct ComparedMode {
  double freq_Hz = 0;
  double freq_std_Hz = 0;  // 0: not stated
  std::string family;      // "bending", "hoop"; "" or "unknown": any
  bool second = false;     // of a double peak, of which the first is quoted: pairs with another such alone
  struct Component {
    std::complex<double> value;
    double std = 0;
  };
  std::map<std::pair<int, int>, Component> shape;  // by point and channel; empty: none
};

/// A largest deflection under an impact.
struct ComparedDeflection {
  std::optional<int> point;          // of a test
  std::optional<double> position_m;  // along the structure
  double peak_m = 0, std_m = 0;
  double forward_m = 0, forward_std_m = 0;  // the way the structure first went, as a model states it; 0: not stated
};

/// What one document has to compare.
struct ComparedDocument {
  std::string name, schema;  // "bat.json", "percuss/analysis/1"
  bool model = false;        // a prediction
  std::vector<ComparedMode> modes;
  std::vector<ComparedDeflection> deflections;
};

struct PairOptions {
  double furthest = 0.25;  // of the frequency: modes further apart are not the same
  double min_mac = 0.6;    // where both have shapes
};

struct ModePair {
  std::size_t a = 0, b = 0;       // indices of the modes
  double difference_percent = 0;  // of b from a
  std::optional<double> difference_std_percent;
  std::optional<identify::Mac> mac;
};

struct PairedModes {
  std::vector<ModePair> pairs;  // ascending by a
  std::vector<std::size_t> unpaired_a, unpaired_b;
};

/// Which modes are the same: by shape where both documents have at least three places in common, the best MAC first;
/// else by frequency, in order, so that the most are paired and, among those ways, the logarithms of the frequencies
/// differ least. A bending mode is never paired with a hoop mode. Every mode of 0 Hz (a rigid body's) is left out.
PairedModes pair_modes(const ComparedDocument& a, const ComparedDocument& b, const PairOptions& options = {});

struct DeflectionPair {
  std::optional<int> point;
  std::optional<double> position_m;
  double a_m = 0, b_m = 0;
  double ratio = 0, ratio_std = 0;  // model over test where one of them is a model, else b over a
};

/// Deflections at the same place: the same position (a model's sweep is interpolated between its positions) where both
/// have positions, else the same point. Against a model the deflections the way the structure first went count, where
/// they are stated.
std::vector<DeflectionPair> pair_deflections(const ComparedDocument& a, const ComparedDocument& b);

}  // namespace percuss::metrics
