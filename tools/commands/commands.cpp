#include <array>
#include <string_view>

#include "commands/commands.hpp"

namespace percuss::tools {
namespace {

void add_exit_codes(CommandLine& line) {
  line.exit_code(kOk, "done");
  line.exit_code(kInternalError, "internal error");
  line.exit_code(kUsage, "the command line was not understood");
  line.exit_code(kBadInput, "unusable input");
  line.exit_code(kImpossible,
                 "the analysis is impossible (no hit can be used, or no decay can be fitted), or its budget is spent; "
                 "or no blow of a recording counts");
  line.exit_code(kQualityGate, "a quality gate failed (the bat exceeds its limit or is damaged)");
  line.exit_code(
      kPartial,
      "some records of a batch failed, or the machine failed before all were analysed (run the batch again); or a "
      "recording ended early");
}

struct NamedCommand {
  std::string_view name;
  void (*add)(CommandLine&);
};

constexpr std::array kNamedCommands = {
    NamedCommand{"analyze", add_analyze},     NamedCommand{"frf", add_frf},
    NamedCommand{"nodes", add_nodes},         NamedCommand{"survey", add_survey},
    NamedCommand{"info", add_info},           NamedCommand{"convert", add_convert},
    NamedCommand{"calibrate", add_calibrate}, NamedCommand{"deflect", add_deflect},
    NamedCommand{"compare", add_compare},     NamedCommand{"synth", add_synth},
    NamedCommand{"model", add_model},         NamedCommand{"metrics", add_metrics},
    NamedCommand{"certify", add_certify},     NamedCommand{"abi", add_abi},
    NamedCommand{"study", add_study},         NamedCommand{"batch", add_batch},
    NamedCommand{"record", add_record},       NamedCommand{"devices", add_devices},
};

}  // namespace

// Declaring all commands takes longer than running many of them. Therefore only the named command is declared. Other
// first words, such as --help, help, completion, man and a mistyped command, need all; --version needs none.
void add_commands(CommandLine& line, std::string_view first_word) {
  if (first_word == "--version") return;
  for (const NamedCommand& command : kNamedCommands) {
    if (command.name == first_word) return command.add(line);
  }
  for (const NamedCommand& command : kNamedCommands) command.add(line);
  add_completion(line);
  add_man(line);
}

void add_program(CommandLine& line) {
  Command program = line.program();
  program.about(
      "percuss turns hammer tests into natural frequencies, damping ratios and mode shapes, each with its standard "
      "deviation. It also predicts the modes and impacts of beams, bats and barrels. Results and their warnings go to "
      "standard output, progress and notes on the input to standard error. Options follow the command; percuss help "
      "COMMAND explains one.");
  program.example("percuss synth composite-bat -o first.h5; percuss analyze first.h5 --band 60:3200",
                  "Make a synthetic hammer test with known modes, and analyse it");
  add_exit_codes(line);
}

}  // namespace percuss::tools
