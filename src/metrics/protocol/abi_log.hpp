#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace percuss::metrics {

/// The barrel's compression: the mean force at the set displacement over the orientations 0°, 90°, 45° and −45°.
///   BC = (F_0 + F_90 + F_45 + F_−45)/4                                                         (P13)
struct AbiCompression {
  std::vector<double> force_lbf;          // four
  std::optional<double> displacement_in;  // of this compression, where stated
  double mean_lbf() const;
};

/// One rolling over all four orientations, with the rollers at this depth.
struct AbiRoll {
  double depth_in = 0;
};

/// One performance test: BESR or BBCOR at the highest performing location.
struct AbiPerformance {
  double value = 0;
  std::string id;              // of this state in a study table; empty: the bat's id, then with "-2", "-3", …
  std::optional<double> z_in;  // the location, from the barrel's tip
  bool damage = false;         // visible damage, or failed the ring test
  bool broken = false;         // the bat cannot be tested further
  std::optional<double> hoop_Hz;
};

struct AbiEntry {
  std::string place;  // in the log, for messages
  std::variant<AbiCompression, AbiRoll, AbiPerformance> what;
};

/// The steps carried out on a bat, in their order.
struct AbiLog {
  std::string bat, material;
  std::optional<double> length_in, moi_ozin2;
  std::optional<double> displacement_in;  // of every compression; otherwise 0.03 in
  bool bbcor = false;                     // judged by BBCOR, else by BESR
  std::optional<double> limit;
  bool continued = false;  // at the sponsor's request, after failing by the limit
  std::vector<AbiEntry> entries;
};

/// Reads percuss/abi-log/1 (docs/schema/abi-log.schema.json).
/// errors  InputError with file and key: another document, a force outside the range of the load frame, an impossible
/// number.
AbiLog parse_abi_log(std::string_view text, const std::string& where);
AbiLog read_abi_log(const std::string& path);

/// An example log to start from.
std::string abi_log_example();

}  // namespace percuss::metrics
