#pragma once
#include <vector>

#include "cli/command_line.hpp"
#include "core/budget.hpp"

namespace percuss::tools {

/// Declares --budget, for commands whose computation can take long.
void add_model_budget(Command& command, std::vector<double>& budget);

/// Limits the computations of one model to --budget during its lifetime.
class ModelBudget {
 public:
  /// `values` of --budget; `command` names the model in the error. Throws OptionError.
  ModelBudget(const std::vector<double>& values, const char* command);

 private:
  BudgetMeter meter_;
  BudgetScope scope_;
};

}  // namespace percuss::tools
