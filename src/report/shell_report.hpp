#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/shell/shell.hpp"
#include "model/shell/shell_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// A fit that the shell shown was taken from, and what it was made from.
struct FittedShell {
  std::vector<model::MeasuredHoop> measured;
  model::ShellFit fit;
};

/// percuss/model-shell/1: hoop frequencies of a tube with n waves around it, Flügge's for 1 … modes half-waves along.
CommandReport shell_report(const model::TubeShell& shell, std::size_t n, std::size_t modes,
                           const std::optional<FittedShell>& fitted = {});

}  // namespace percuss::report
