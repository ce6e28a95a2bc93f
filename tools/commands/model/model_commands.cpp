#include "commands/model/model_commands.hpp"

#include "commands/commands.hpp"

namespace percuss::tools {

void add_model(CommandLine& line) {
  line.group("model", "Predict the behaviour of beams, bats and barrels, and of a ball that strikes them");
  add_model_beam(line);
  add_model_impact(line);
  add_model_rigid(line);
  add_model_trampoline(line);
  add_model_bat(line);
  add_model_shell(line);
}

}  // namespace percuss::tools
