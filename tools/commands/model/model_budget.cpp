#include "commands/model/model_budget.hpp"

#include "cli/analysis_flags.hpp"

namespace percuss::tools {

void add_model_budget(Command& command, std::vector<double>& budget) {
  command
      .list("--budget", budget,
            "Stop a model that takes more than this time in seconds or memory in GB (default: 120 s; 2.1 GB)")
      .above_zero()
      .type("S[,GB]");
}

ModelBudget::ModelBudget(const std::vector<double>& values, const char* command)
    : meter_(budget_of(values).value_or(default_budget(0)), command, BudgetedWork::model), scope_(meter_) {}

}  // namespace percuss::tools
