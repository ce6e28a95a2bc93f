#pragma once
#include <optional>
#include <string>
#include <vector>

#include "model/trampoline/exponent_family.hpp"
#include "model/trampoline/trampoline.hpp"
#include "model/trampoline/trampoline_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// The fit of the exponents that the sweep uses, and the measurements that it used.
struct FittedExponents {
  std::vector<model::MeasuredCor> measured;
  model::ExponentFit fit;
  std::vector<model::FamilyPair> family{};  // computed by trampoline_report
  model::SweepRange range{};                // computed by trampoline_report
};

/// Results shown besides the sweep.
struct TrampolineExtras {
  std::optional<FittedExponents> fitted;
  std::optional<double> modal_mass_kg;  // from a measured shift of the hoop frequency
};

/// JSON: percuss/model-trampoline/1. COR over the hoop frequency, its maximum, the COR at a rigid wall, and the COR at
/// 10 kHz. The source calls that barrel rigid and divides by its COR. With fitted exponents: the fit, and the range of
/// the curve and of its maximum over the exponents that the measurements allow. errors  as rebound.
CommandReport trampoline_report(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                const TrampolineExtras& extras = {});

}  // namespace percuss::report
