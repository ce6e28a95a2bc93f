#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "acquire/calibrate.hpp"
#include "acquire/unfinished_files.hpp"
#include "command.hpp"
#include "core/error.hpp"

namespace {

using namespace percuss;
using namespace percuss::tools;

int report(const char* what, int code) {
  std::cerr << "percuss: " << what << '\n';
  return code;
}

void add_exit_codes(CommandLine& line) {
  line.exit_code(kOk, "done");
  line.exit_code(kInternalError, "internal error");
  line.exit_code(kUsage, "the command line was not understood");
  line.exit_code(kBadInput, "unusable input");
  line.exit_code(kImpossible, "the analysis is impossible (no hit can be used)");
  line.exit_code(kQualityGate, "a quality gate failed (the bat exceeds its limit)");
  line.exit_code(kPartial, "some records of a batch failed");
}

void add_models(CommandLine& line) {
  line.group("model", "Predictions: beams, bats, barrels and what a ball does to them");
  add_model_beam(line);
  add_model_impact(line);
  add_model_rigid(line);
  add_model_trampoline(line);
  add_model_bat(line);
  add_model_shell(line);
}

struct NamedCommand {
  std::string_view name;
  void (*add)(CommandLine&);
};

constexpr NamedCommand kCommands[] = {
    {"analyze", add_analyze}, {"frf", add_frf},         {"nodes", add_nodes},         {"survey", add_survey},
    {"info", add_info},       {"convert", add_convert}, {"calibrate", add_calibrate}, {"deflect", add_deflect},
    {"compare", add_compare}, {"synth", add_synth},     {"model", add_models},        {"metrics", add_metrics},
    {"certify", add_certify}, {"abi", add_abi},         {"study", add_study},         {"batch", add_batch},
};

// Declaring every option of every command takes longer than many a command does, so that only the one named first is,
// unless all are needed: for help, for what tells of all commands, and for a word that is no command.
void add_commands(CommandLine& line, std::string_view first_word) {
  if (first_word == "--version") return;
  for (const NamedCommand& command : kCommands) {
    if (command.name == first_word) return command.add(line);
  }
  for (const NamedCommand& command : kCommands) command.add(line);
  add_completion(line);
  add_man(line);
}

int parse_and_run(int argc, char** argv) {
  CommandLine line("percuss", "Modes of a structure from hammer tests, with error bars", PERCUSS_VERSION);
  Command program = line.program();
  program.about(
      "percuss turns hammer tests into natural frequencies, damping and mode shapes, each with its standard deviation, "
      "and predicts what beams, bats and barrels do. Data goes to standard output, progress and warnings to standard "
      "error. Options follow the command.");
  program.example("percuss synth composite-bat -o first.h5; percuss analyze first.h5 --band 60:3200",
                  "A made-up hammer test whose modes are known, and its analysis");
  add_commands(line, argc > 1 ? argv[1] : "");
  add_exit_codes(line);
  const int code = line.run(argc, argv);
  std::cout.flush();
  return std::cout ? code
                   : report("could not write to standard output; is the disk full or the pipe closed?", kBadInput);
}

}  // namespace

// Memory may run out where nothing may be thrown: within the JSON library, or while another error is on its way up.
[[noreturn]] static void end_at_once() {
  percuss::remove_unfinished_files();
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    std::cerr << "percuss: " << percuss::kNoMemory << '\n';
    std::_Exit(kInternalError);
  } catch (...) {
  }
  std::abort();
}

// Every file of a test stays open while it is analysed, and so does the talk with its reader.
static void allow_many_files() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &files);
}

extern "C" void clean_up_and_die(int signal) {
  percuss::remove_unfinished_files();  // safe within a signal handler
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int main(int argc, char** argv) {
  std::set_terminate(end_at_once);
  allow_many_files();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, clean_up_and_die);
  try {
    return parse_and_run(argc, argv);
  } catch (const UsageError& e) {
    return report(e.what(), kUsage);
  } catch (const NoHitError& e) {
    return report(e.what(), kImpossible);
  } catch (const InputError& e) {
    return report(e.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return report(kNoMemory, kInternalError);
  } catch (const std::exception& e) {
    return report(e.what(), kInternalError);
  }
}
