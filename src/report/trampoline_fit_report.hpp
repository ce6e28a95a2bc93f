#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/html/command_report.hpp"
#include "report/trampoline_report.hpp"

namespace percuss::report {

/// A remark on a model's result, for the document and for the text.
struct TrampolineWarning {
  std::string code, message, remedy;
  std::vector<OptionId> options;
};

/// What limits the result: a maximum at an end of the sweep, exponents that the CCOR does not determine, a bad fit.
std::vector<TrampolineWarning> trampoline_warnings(const model::Trampoline& model, const model::HoopPeak& peak,
                                                   const std::optional<FittedExponents>& fitted);

/// The model's CCOR over the speeds around the measured ones, and its range over the allowed exponents.
struct CcorCurve {
  std::vector<double> speed_mps, cor, low, high;
};
CcorCurve ccor_curve(const model::Trampoline& model, const FittedExponents& fitted);

/// "fit" of the document, and its lines of the text.
nlohmann::ordered_json trampoline_fit_json(const FittedExponents& fitted, const CcorCurve& curve);
ReportText trampoline_fit_text(const FittedExponents& fitted);

/// The measured CCOR over the speed, with the model's curve and its range.
LineChart ccor_chart(const FittedExponents& fitted, CcorCurve curve);

}  // namespace percuss::report
