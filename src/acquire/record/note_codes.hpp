#pragma once

namespace percuss::acquire {

/// Codes of a reader's notes (Message::code) that the analysis acts on.
inline constexpr const char* kResponseUnitAssumed = "response_unit_assumed";  // nothing states a response's unit
inline constexpr const char* kFullScaleAssumed = "full_scale_assumed";        // nothing states a sound file's scale
inline constexpr const char* kReversedPhase = "reversed_phase";               // all FRFs are for exp(−jωt)

}  // namespace percuss::acquire
