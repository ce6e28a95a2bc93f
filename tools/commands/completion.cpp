#include <iostream>
#include <memory>

#include "cli/completion/completion_scripts.hpp"
#include "commands/commands.hpp"

namespace percuss::tools {
namespace {

int print_script(const Declaration& all, const std::string& shell) {
  std::cout << (shell == "bash" ? bash_completion(all) : shell == "zsh" ? zsh_completion(all) : fish_completion(all));
  return kOk;
}

}  // namespace

void add_completion(CommandLine& line) {
  auto shell = std::make_shared<std::string>();
  Command command =
      line.command("completion", "Print a script that completes percuss's commands and options in a shell",
                   [&line, shell] { return print_script(line.declaration(), *shell); });
  command.about(
      "An installation of percuss includes these scripts. Without an installation, put the script where the shell "
      "finds it. bash: source it in ~/.bashrc. zsh: save it as _percuss in a folder of fpath. fish: save it as "
      "percuss.fish in ~/.config/fish/completions.");
  command.example("percuss completion bash > percuss.bash",
                  "Write the script for bash; load it with: source percuss.bash");
  command.example("percuss completion zsh > _percuss");
  command.example("percuss completion fish > percuss.fish");
  command.argument("SHELL", *shell, "Shell to print the script for").one_of({"bash", "zsh", "fish"}).required();
}

}  // namespace percuss::tools
