#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/html/command_report.hpp"
#include "report/trampoline_report.hpp"

namespace percuss::report {

/// The model's CCOR over the speeds around the measured ones, and its range over the exponent pairs on the contour of
/// the fit.
struct CcorCurve {
  std::vector<double> speed_mps, cor, low, high;
};
CcorCurve ccor_curve(const model::Trampoline& model, const model::FittedExponents& fitted);

/// "fit" of the document, and its lines of the text.
nlohmann::ordered_json trampoline_fit_json(const model::FittedExponents& fitted, const CcorCurve& curve);
ReportText trampoline_fit_text(const model::FittedExponents& fitted);

/// The measured CCOR over the speed, with the model's curve and its range.
LineChart ccor_chart(const model::FittedExponents& fitted, CcorCurve curve);

}  // namespace percuss::report
