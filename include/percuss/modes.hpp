#pragma once
/// Modes and their classification, as plain data: the results of Analysis::modes(), Analysis::classifications() and
/// Survey::classifications().
///
/// @code
/// #include <iostream>
/// #include <percuss/analysis.hpp>
/// #include <percuss/modes.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::Record record = percuss::synthesise_preset("composite-bat").record;
///   const percuss::Analysis analysis(record, {.band_Hz = percuss::Band{60, 3200}});
///   const std::vector<percuss::ModeClassification> types = analysis.classifications();
///   for (const percuss::Mode& mode : analysis.modes()) {
///     const percuss::ModeClassification& type = types[mode.index];
///     std::cout << percuss::name_of(type.type) << ' ' << type.order << ": " << mode.freq_Hz << " ± "
///               << mode.freq_std_Hz << " Hz, damping " << 100 * mode.damping_ratio << " %\n";
///   }
/// }
/// @endcode
#include <percuss/error.hpp>
#include <percuss/hits.hpp>

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace percuss {

/// A mode's residue A at one point and channel: accelerance H(ω) = … + A·(jω)²/((jω)² + 2ζω_r jω + ω_r²).
struct Residue {
  std::size_t point = 0;    // number of the point, one of Analysis::points()
  std::size_t channel = 0;  // acceleration channel
  std::complex<double> value_per_kg;
  double std_per_kg = 0;  // of the real and of the imaginary part
};

/// A mode. Every ± is one standard deviation.
struct Mode {
  std::size_t index = 0;
  double freq_Hz = 0, freq_std_Hz = 0;  // undamped natural frequency
  double damping_ratio = 0, damping_ratio_std = 0;
  double freq_scatter_Hz = 0;  // standard deviation between points; 0: not significant
  std::vector<Residue> residues;
};

/// A mode, fitted to one hit alone. Each ± covers the noise of the hit and the scatter between the hits. It does not
/// cover the misfit of the model, which is common to all hits: the ± of Mode contains it.
struct ModeOfHit {
  std::size_t hit = 0, mode = 0;
  double freq_Hz = 0, freq_std_Hz = 0;
  double damping_ratio = 0, damping_ratio_std = 0;
};

enum class ModeType { bending, hoop, unknown };
/// "bending", "hoop", "unknown"
const char* name_of(ModeType type);

/// Two peaks so close that they count as one split mode.
struct SplitMode {
  std::size_t partner = 0;  // index of the other mode
  double separation_Hz = 0, separation_std_Hz = 0;
  bool first = false;   // this mode has the lower frequency of the two
  bool quoted = false;  // reports quote the frequency of this mode
};

/// The type of a mode of a tube: bending or hoop.
struct ModeClassification {
  ModeType type = ModeType::unknown;
  int order = 0;          // counts from 1 within the type; 0 when unknown
  double confidence = 0;  // posterior probability of the type; unknown: 1 − the larger of both
  // The second type, if confidence < 0.9 or its own probability > 0.03. Beside `unknown`: the likelier of bending and
  // hoop. The alternative `unknown` means three waves around the barrel.
  std::optional<ModeType> alternative{};
  std::optional<double> overlay_dB{};           // magnitude of the second FRF over the first at the peak
  bool overlaid = false;                        // |overlay_dB| is at most AnalysisOptions::overlay_dB
  std::optional<std::complex<double>> ratio{};  // residue of the second sensor over the residue of the first
  double ratio_std = 0;                         // of the real and of the imaginary part
  std::optional<SplitMode> split_mode{};
  bool possible_three_waves = false;  // it may have n = 3 waves around the barrel, which lowers `confidence`
  bool order_uncertain = false;       // bending: the order depends on a mode below that may have three waves
};

/// A warning about a result.
struct Warning {
  std::string code, message;
  std::vector<OptionId> options{};  // that the message concerns
  std::string remedy{};             // what to do, if known; `message` ends with it
  Severity severity = Severity::warn;
};

}  // namespace percuss
