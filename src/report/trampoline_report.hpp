#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/io/csv_cell.hpp"
#include "model/trampoline/exponent_family.hpp"
#include "model/trampoline/trampoline.hpp"
#include "model/trampoline/trampoline_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// A bat with measured hoop frequency and BBCOR.
struct MeasuredBat {
  std::string id;
  double hoop_Hz = 0, bbcor = 0;
};

/// Results shown besides the sweep.
struct TrampolineExtras {
  std::optional<model::FittedExponents> fitted;  // needs `measured` and `fit`; the report computes the rest
  std::optional<double> modal_mass_kg;           // from a measured shift of the hoop frequency
  std::vector<MeasuredBat> bats{};
  CsvFormulas formulas = CsvFormulas::neutralise;  // of the bats' ids in the table
};

/// JSON: percuss/model-trampoline/1. COR over the hoop frequency, its maximum, the COR at a rigid wall, and the COR at
/// 10 kHz. The source takes a barrel of 10 kHz as rigid and divides by its COR. With fitted exponents: the fit, and the
/// range of the curve and of its maximum over the exponents that the measurements allow. With bats: their BBCOR beside
/// the model's COR at their hoop frequency, and a row of the table for each. errors  as rebound.
CommandReport trampoline_report(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                const TrampolineExtras& extras = {});

}  // namespace percuss::report
