#pragma once
#include <optional>
#include <string>
#include <vector>

#include "model/trampoline/trampoline.hpp"
#include "model/trampoline/trampoline_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// A fit of the exponents that the sweep was made with, and what it was made from.
struct FittedExponents {
  std::vector<model::MeasuredCor> measured;
  model::ExponentFit fit;
};

/// What percuss model trampoline shows beside the sweep.
struct TrampolineExtras {
  std::optional<FittedExponents> fitted;
  std::optional<double> modal_mass_kg;  // from a measured shift of the hoop frequency
};

/// percuss/model-trampoline/1: COR over the hoop frequency, the best, the wall's, and the one at 10 kHz, which the
/// source divides by. errors  as rebound.
CommandReport trampoline_report(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                const TrampolineExtras& extras = {});

}  // namespace percuss::report
