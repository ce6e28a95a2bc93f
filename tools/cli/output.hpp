#pragma once
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/host.hpp"

namespace percuss::tools {

/// Where results go: flags that every command shares.
struct OutputFlags {
  std::vector<std::string> paths;  // -o, repeatable
  bool json = false;
  bool force = false;
  bool quiet = false;
  Host* host = nullptr;            // gets the results, in place of standard output
  std::string equivalent_command;  // once the command has run: the host's word for the command line
};

/// `kinds` are those that check_outputs will be asked for, in words: ".json, .csv".
void add_output_flags(Command& command, OutputFlags& flags, const char* kinds);

/// The flags for what a host may ask for once the command has run.
OutputFlags captured_output(const OutputFlags& flags);
/// … for one more file.
OutputFlags single_output(const OutputFlags& kept, const std::string& path, bool force);

/// What a command has to say in the end, on standard output or to the host.
void print(const OutputFlags& flags, const std::string& text);
/// A remark beside it, on standard error unless --quiet is given.
void print_note(const OutputFlags& flags, const std::string& text);

/// The text with the host's names in place of paths that stand for documents in memory, which nobody has seen.
std::string with_display_names(const Host* host, std::string text);

/// The extension of a path in lower case, with its dot; "" for none.
std::string extension_of(const std::string& path);

/// Whether the path names a universal file: .uff or .unv.
bool is_uff(const std::string& path);

bool is_html(const std::string& path);

/// Whether a file is asked for that holds pictures: .svg or .html.
bool writes_charts(const OutputFlags& flags);

/// Nothing is read or computed for a file that cannot be written: UsageError when a path's extension is not among
/// `known` or a path is named twice, InputError when the file exists and --force is not given.
void check_outputs(const OutputFlags& flags, const std::vector<std::string>& known);

/// Whether standard output is a terminal with room for a drawing of characters.
bool can_plot_in_terminal();

/// Columns of the terminal on standard output; 100 when it is none.
std::size_t terminal_width();

}  // namespace percuss::tools
