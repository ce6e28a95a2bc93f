#pragma once
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/host.hpp"
#include "cli/title_flags.hpp"
#include "core/error.hpp"
#include "core/io/csv_cell.hpp"

namespace percuss::tools {

/// The output options that all commands share.
struct OutputFlags {
  std::vector<std::string> paths;  // -o, repeatable
  bool json = false;
  bool force = false;
  bool quiet = false;
  TitleFlags title;
  Host* host = nullptr;            // receives the results in place of standard output
  std::string equivalent_command;  // the host's command line, for files that it saves after the run
};

/// `kinds` are the extensions that the command passes to check_outputs. With .html, pages can be written as .pdf too,
/// and have a title block.
void add_output_flags(Command& command, OutputFlags& flags, const std::vector<std::string>& kinds);

/// Adds --keep-formulas, for commands that write texts to CSV. csv_formulas() converts the flag.
void add_formula_flag(Command& command, bool& keep_formulas);
CsvFormulas csv_formulas(bool keep_formulas);

/// The flags for files that a host saves after the command has run: without the host, but with its command line.
OutputFlags captured_output(const OutputFlags& flags);
/// `kept` with this path alone, and this value of --force. The title is kept for pages only.
OutputFlags single_output(const OutputFlags& kept, const std::string& path, bool force);
/// As above, with the page options of the request, which are also added to the equivalent command line.
/// errors  OptionError: an unknown paper
OutputFlags single_output(const OutputFlags& kept, const SaveRequest& request);

/// Prints the result of a command on standard output, a text in colour where wants_color() allows it, or gives it to
/// the host.
void print(const OutputFlags& flags, const std::string& text);
/// Prints a note on standard error unless --quiet is given, or gives it to the host. The note's options become flags.
void print_note(const OutputFlags& flags, const Message& note);

/// The text with the host's display names in place of the paths of documents in memory.
std::string with_display_names(const Host* host, std::string text);

/// The extension of a path in lower case with its dot, or "".
std::string extension_of(const std::string& path);

/// Whether the path ends in .uff or .unv (universal file).
bool is_uff(const std::string& path);

/// Whether the path ends in .html or .pdf.
bool is_page(const std::string& path);
bool is_json(const std::string& path);

/// Whether an output file holds charts: .svg or a page.
bool writes_charts(const OutputFlags& flags);

/// Checks before anything is computed that a file can be written to the path.
/// errors  InputError, as when the file is written: for a folder that does not exist; for a folder, pipe or device in
///         place of a file; without `force` also for an existing file, and for a link to a file that does not exist
void require_output_path(const std::string& path, bool force);

/// Checks the output paths before anything is computed. Throws UsageError for an extension that is not in `kinds`, for
/// a path given twice, and for options of the title block without a page. Throws InputError as require_output_path; for
/// files of the title block that cannot be used; and for .pdf without a browser.
void check_outputs(const OutputFlags& flags, const std::vector<std::string>& kinds);

/// Whether standard output is a terminal wide enough for a plot of characters.
bool can_plot_in_terminal();

/// Columns of the terminal on standard output, at most 140; 100 if it is not a terminal or has fewer than 40.
std::size_t terminal_width();

}  // namespace percuss::tools
