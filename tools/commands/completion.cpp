#include <iostream>
#include <memory>

#include "cli/completion_scripts.hpp"
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
  Command command = line.command("completion", "A script that lets a shell complete percuss's commands and options",
                                 [&line, shell] { return print_script(line.declaration(), *shell); });
  command.about(
      "An installed percuss has these scripts in place. Without an installation, put the script where the shell looks: "
      "source it in ~/.bashrc; save it as _percuss in a folder of zsh's fpath; save it as percuss.fish in "
      "~/.config/fish/completions.");
  command.example("percuss completion bash > percuss.bash", "Then, for the bash at hand: source percuss.bash");
  command.example("percuss completion zsh > _percuss");
  command.example("percuss completion fish > percuss.fish");
  command.word("SHELL", *shell, "Which shell the script is for").one_of({"bash", "zsh", "fish"}).required();
}

}  // namespace percuss::tools
