#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/man_page.hpp"
#include "cli/option_error.hpp"
#include "cli/usage_errors.hpp"
#include "commands/commands.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::tools {
namespace {

struct ManFlags {
  std::vector<std::string> words;
  std::string folder;
  bool force = false;
};

const DeclaredCommand& command_named(const Declaration& all, const std::vector<std::string>& words) {
  const CommandMatch named = longest_command(all, words);
  if (named.words < words.size()) throw unknown_command(all, *named.command, words[named.words]);
  return *named.command;
}

void write_pages(const Declaration& all, const ManFlags& flags) {
  std::error_code failed;
  std::filesystem::create_directories(flags.folder, failed);
  if (failed) throw InputError("cannot create the folder: " + failed.message(), flags.folder, "name another");
  OutputGroup outputs;
  for (const DeclaredCommand& command : all.commands)
    write_file(flags.folder + "/" + page_name(all, command) + ".1", man_page(all, command), flags.force);
  outputs.commit();
}

int print_page(const Declaration& all, const ManFlags& flags) {
  if (!flags.folder.empty() && !flags.words.empty())
    throw OptionError({"folder"}, "writes all pages", "omit the command or the folder");
  if (flags.folder.empty()) {
    std::cout << man_page(all, command_named(all, flags.words));
    if (isatty(STDOUT_FILENO) == 1) std::cerr << "percuss: to read this page, type: percuss man ... | man -l -\n";
  } else {
    write_pages(all, flags);
  }
  return kOk;
}

}  // namespace

void add_man(CommandLine& line) {
  auto flags = line.values<ManFlags>();
  Command command = line.command("man", "Print the manual page of percuss or of a command, or write all pages",
                                 [&line, flags] { return print_page(line.declaration(), *flags); });
  command.about(
      "Prints the page in roff, the format of the program man. The page contains the text of --help. An installation "
      "of percuss includes its pages: man percuss-analyze shows one.");
  command.example("percuss man model beam > percuss-model-beam.1", "Write the page of percuss model beam");
  command.example("percuss man --folder man1", "Write all pages: percuss.1, percuss-analyze.1, ...");
  std::vector<std::string> names;
  for (const DeclaredCommand& one : line.declaration().commands) {
    if (!one.name.empty()) names.push_back(base_name(one));
  }
  command.arguments("COMMAND", flags->words, "Command, such as analyze or model beam (default: percuss itself)")
      .one_of(names);
  command.value("--folder", flags->folder, "Write all pages into this folder").type("FOLDER");
  command.flag("--force", flags->force, "Overwrite existing files");
}

}  // namespace percuss::tools
