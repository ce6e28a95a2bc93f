#include "cli/output.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>
#include <system_error>

#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/page_output.hpp"
#include "cli/shell_argument.hpp"
#include "cli/terminal/color.hpp"
#include "core/error.hpp"
#include "core/visible_text.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxNoteBytes = 2000;
constexpr std::string_view kPageExtension = ".html";

// The kinds, and .pdf after .html.
std::vector<std::string> with_pdf(std::vector<std::string> kinds) {
  if (const auto page = std::find(kinds.begin(), kinds.end(), kPageExtension); page != kinds.end())
    kinds.insert(page + 1, ".pdf");
  return kinds;
}

// Fails before anything is computed rather than at the end.
void check_pages(const OutputFlags& flags) {
  const bool page = std::any_of(flags.paths.begin(), flags.paths.end(), is_page);
  if (flags.title.given()) {
    if (!page && flags.host == nullptr) {
      throw OptionError({"title", "customer", "operator", "specimen", "date", "note", "logo", "paper"}, "need a page",
                        "write a .html or .pdf file", {"output"});
    }
    title_block(flags.title);
  }
  for (const std::string& path : flags.paths) {
    if (extension_of(path) == ".pdf") require_browser(path);
  }
}

}  // namespace

void add_output_flags(Command& command, OutputFlags& flags, const std::vector<std::string>& kinds) {
  flags.host = command.host();
  const std::string previous = command.heading("Output");
  const std::string help =
      fmt::format("Write this file; its extension sets the kind: {} (repeatable)", fmt::join(with_pdf(kinds), ", "));
  command.repeatable("-o,--output", flags.paths, help.c_str()).type("FILE");
  command.flag("--json", flags.json, "Print one JSON document on standard output");
  command.flag("--force", flags.force, "Overwrite existing files");
  command.flag("--quiet", flags.quiet, "Print no progress and no warnings");
  command.heading(previous);
  if (std::find(kinds.begin(), kinds.end(), kPageExtension) != kinds.end()) add_title_flags(command, flags.title);
}

void add_formula_flag(Command& command, bool& keep_formulas) {
  const std::string previous = command.heading("Output");
  command.flag("--keep-formulas", keep_formulas,
               "Write texts such as =1+1 to CSV without the apostrophe that keeps a spreadsheet from computing them");
  command.heading(previous);
}

CsvFormulas csv_formulas(bool keep_formulas) { return keep_formulas ? CsvFormulas::keep : CsvFormulas::neutralise; }

OutputFlags captured_output(const OutputFlags& flags) {
  OutputFlags kept = flags;
  kept.equivalent_command = flags.host->equivalent_command;
  kept.host = nullptr;
  return kept;
}

OutputFlags single_output(const OutputFlags& kept, const std::string& path, bool force) {
  OutputFlags one = kept;
  one.paths = {path};
  if (!is_page(path)) one.title = {};  // it stands on pages alone
  one.force = force;
  return one;
}

OutputFlags single_output(const OutputFlags& kept, const SaveRequest& request) {
  OutputFlags one = single_output(kept, request.path, request.force);
  for (const auto& [name, value] : request.page) {
    set_title_flag(one.title, name, value);
    one.equivalent_command += " " + shell_quoted_argument("--" + name + "=" + value);
  }
  return one;
}

void print(const OutputFlags& flags, const std::string& text) {
  if (flags.host != nullptr) {
    flags.host->outcome.document = text;
  } else if (!flags.json && wants_color(STDOUT_FILENO)) {
    std::cout << std::flush;
    // std::cout would write the control characters as escapes (VisibleOutput).
    const std::string shown = in_color(visible_text(text));
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0)
      std::cout.setstate(std::ios::badbit);
  } else {
    std::cout << text << std::flush;
  }
}

void print_note(const OutputFlags& flags, const Message& note) {
  if (flags.host != nullptr) {
    flags.host->outcome.notes.push_back(note);
  } else if (!flags.quiet) {
    if (wants_color(STDERR_FILENO)) fmt::print(stderr, "{}", kYellow);
    std::cerr << "percuss: " << one_line(note.written(flag_of), kMaxNoteBytes) << '\n';
    if (wants_color(STDERR_FILENO)) fmt::print(stderr, "{}", kPlain);
  }
}

std::string with_display_names(const Host* host, std::string text) {
  if (host == nullptr) return text;
  for (const auto& [path, name] : host->names) {
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at + name.size()))
      text.replace(at, path.size(), name);
  }
  return text;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_uff(const std::string& path) { return extension_of(path) == ".uff" || extension_of(path) == ".unv"; }

bool is_page(const std::string& path) { return extension_of(path) == kPageExtension || extension_of(path) == ".pdf"; }

bool is_json(const std::string& path) { return extension_of(path) == ".json"; }

bool writes_charts(const OutputFlags& flags) {
  return std::any_of(flags.paths.begin(), flags.paths.end(),
                     [](const std::string& path) { return is_page(path) || extension_of(path) == ".svg"; });
}

namespace {

void require_folder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failed;
  if (folder.empty() || std::filesystem::is_directory(folder, failed)) return;
  if (failed && failed != std::errc::no_such_file_or_directory && failed != std::errc::not_a_directory)
    return;  // writing tells why
  const bool absent = !std::filesystem::exists(folder, failed);
  throw_system_error("cannot write", absent ? ENOENT : ENOTDIR, path, "create the folder first");
}

// Refuses a folder and a pipe or device; without `force` also an existing file, and a link whose target does not exist:
// writing follows a link only to an existing file.
void require_place(const std::string& path, bool force) {
  std::error_code ignored;
  const std::filesystem::file_status found = std::filesystem::status(path, ignored);
  const bool exists = std::filesystem::exists(found);
  if (std::filesystem::is_directory(found)) throw InputError("is a folder", path, "name a file");
  if (exists && !std::filesystem::is_regular_file(found))
    throw InputError("is not a regular file", path, "name a file");
  if (force) return;
  if (exists) throw InputError("file exists", path, "give another name, or overwrite it", {"force"});
  if (std::filesystem::is_symlink(path, ignored)) {
    throw InputError("is a link to a file that does not exist", path, "give another name, or replace the link",
                     {"force"});
  }
}

}  // namespace

void require_output_path(const std::string& path, bool force) {
  require_folder(path);
  require_place(path, force);
}

void check_outputs(const OutputFlags& flags, const std::vector<std::string>& kinds) {
  const std::vector<std::string> known = with_pdf(kinds);
  std::set<std::string> seen;
  for (const std::string& path : flags.paths) {
    if (std::find(known.begin(), known.end(), extension_of(path)) == known.end()) {
      throw OptionError({}, "cannot tell what to write to '" + path + "'",
                        fmt::format("use a name that ends in {}", fmt::join(known, ", ")));
    }
    if (!seen.insert(path).second)
      throw OptionError({}, "'" + path + "' is to be written twice", "name each file once");
    require_output_path(path, flags.force);
  }
  check_pages(flags);
}

bool can_plot_in_terminal() {
  constexpr std::size_t kRoom = 80;
  return isatty(STDOUT_FILENO) == 1 && terminal_width() >= kRoom;
}

std::size_t terminal_width() {
  constexpr std::size_t kMaxTerminalWidth = 140;  // longer lines are hard to read
  winsize size{};
  if (isatty(STDOUT_FILENO) == 1 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40)
    return std::min<std::size_t>(size.ws_col, kMaxTerminalWidth);
  return 100;
}

}  // namespace percuss::tools
