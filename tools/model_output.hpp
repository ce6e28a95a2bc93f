#pragma once
#include "output.hpp"
#include "report/model_report.hpp"

namespace percuss::tools {

/// The kinds of file that models are written to: .json, .csv and .svg. UsageError or InputError as check_outputs.
void check_model_outputs(const OutputFlags& flags);

/// Writes the files asked for, then the document or the text to standard output; returns kOk.
int show_model(const ModelReport& report, const OutputFlags& flags);

}  // namespace percuss::tools
