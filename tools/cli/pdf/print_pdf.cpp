#include "cli/pdf/print_pdf.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/temporary_folder.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX lets a program declare it

namespace percuss::tools {
namespace {

constexpr std::chrono::seconds kMaxTime{60};
constexpr std::chrono::milliseconds kPoll{20};
constexpr std::uint64_t kMaxPdf_bytes = std::uint64_t{1} << 28U;

bool is_program(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::string program_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return is_program(name) ? name : "";
  const char* const folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (folder.empty()) continue;
    folder += "/";
    folder += name;
    if (is_program(folder)) return folder;
  }
  return "";
}

std::vector<std::string> browser_arguments(const std::string& browser, const TemporaryFolder& folder) {
  std::vector<std::string> words{browser,
                                 "--headless=new",
                                 "--disable-gpu",
                                 "--disable-extensions",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--no-first-run",
                                 "--host-resolver-rules=MAP * ~NOTFOUND",
                                 "--no-pdf-header-footer",
                                 "--user-data-dir=" + folder.file("profile"),
                                 "--print-to-pdf=" + folder.file("page.pdf")};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // a browser refuses to run as root otherwise
  words.push_back("file://" + folder.file("page.html"));
  return words;
}

// Starts a program as the leader of a process group, without input and output.
pid_t start(const std::vector<std::string>& words, const std::string& where) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  posix_spawn_file_actions_init(&files);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_RDWR, 0);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  const int error = ::posix_spawn(&child, words.front().c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw_system_error("cannot start the browser", error, where, "write .html and print it yourself");
  return child;
}

// Waits for the program. Returns false if it takes longer than kMaxTime; then kills it and its children.
bool ended_in_time(pid_t child) {
  const auto began = std::chrono::steady_clock::now();
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() - began > kMaxTime) {
      ::kill(-child, SIGKILL);
      ::waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

}  // namespace

std::string find_browser(const std::string& where) {
  const char* const named = std::getenv("PERCUSS_BROWSER");
  if (named != nullptr && *named != '\0') {
    std::string found = program_in_path(named);
    if (!found.empty()) return found;
    throw InputError("PERCUSS_BROWSER names no program: " + one_line(named), where,
                     "name Chromium, Chrome or Edge, or write .html and print it from a browser");
  }
  for (const char* name : {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome",
                           "microsoft-edge", "microsoft-edge-stable"}) {
    std::string found = program_in_path(name);
    if (!found.empty()) return found;
  }
  throw InputError("no browser is installed that could print a PDF", where,
                   "install Chromium or Chrome, name one in the environment variable PERCUSS_BROWSER, or write .html "
                   "and print it from a browser");
}

std::string printed_pdf(const std::string& html, const std::string& where) {
  const std::string browser = find_browser(where);
  const TemporaryFolder folder("percuss-pdf");  // the page, the document and the profile of the browser
  // Not write_file: within an OutputGroup its file appears only at the end.
  std::ofstream page(folder.file("page.html"), std::ios::binary);
  page << html;
  page.close();
  if (!page) throw InputError("cannot write the page for the browser", folder.file("page.html"), "free some room");
  if (!ended_in_time(start(browser_arguments(browser, folder), where)))
    throw InputError("the browser took more than a minute", where, "write .html and print it from a browser");
  std::error_code ignored;
  if (!std::filesystem::exists(folder.file("page.pdf"), ignored))
    throw InputError("the browser printed nothing: " + browser, where, "write .html and print it from a browser");
  return std::string(read_input(folder.file("page.pdf"), kMaxPdf_bytes).view());
}

}  // namespace percuss::tools
