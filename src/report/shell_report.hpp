#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "model/shell/shell.hpp"
#include "model/shell/shell_fit.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// The fit that gave the shell, and the measurements that it used.
struct FittedShell {
  std::vector<model::MeasuredHoop> measured;
  model::ShellFit fit;
};

/// JSON: percuss/model-shell/1. Hoop frequencies of a tube with n waves around it: of a ring; by Rayleigh; by Love; and
/// by Flügge for each number of half-waves along the tube, 1 … `modes`.
CommandReport shell_report(const model::TubeShell& shell, std::size_t n, std::size_t modes,
                           const std::optional<FittedShell>& fitted = {});

}  // namespace percuss::report
