#include <cxxabi.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>
#include <typeinfo>

#include "acquire/calibrate.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/suggested_command.hpp"
#include "cli/terminal/color.hpp"
#include "cli/terminal/visible_output.hpp"
#include "commands/commands.hpp"
#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/io/temporary_files.hpp"
#include "malloc_options.hpp"
#include "process_setup.hpp"
#include "report/text/version.hpp"

namespace {

using namespace percuss;
using namespace percuss::tools;

int print_error(std::string_view what, int code) {
  const bool color = wants_color(STDERR_FILENO);
  if (color) std::fputs(kRed, stderr);
  std::cerr << "percuss: " << what << '\n';
  if (color) std::fputs(kPlain, stderr);
  return code;
}

int parse_and_run(int argc, char** argv) {
  CommandLine line("percuss", "Identify the modes of a structure from hammer tests, with standard deviations",
                   report::version());
  add_program(line);
  add_commands(line, argc > 1 ? argv[1] : "");
  const int code = line.run(argc, argv);
  std::cout.flush();
  return std::cout
             ? code
             : print_error("could not write to standard output; is the disk full, the pipe closed or memory exhausted?",
                           kBadInput);
}

}  // namespace

// The terminate handler. An exception can escape a noexcept function of the JSON library or of oneTBB, or arise during
// stack unwinding.
[[noreturn]] static void end_at_once() {
  percuss::remove_temporary_files();
  const std::type_info* const type = abi::__cxa_current_exception_type();
  // Inspected without rethrowing, because rethrowing takes memory.
  if (type != nullptr && *type == typeid(std::bad_alloc)) std::_Exit(print_error(kOutOfMemoryMessage, kInternalError));
  try {
    if (type != nullptr) throw;
  } catch (const std::exception& e) {
    std::_Exit(print_error(e.what(), kInternalError));
  } catch (...) {
  }
  std::abort();
}

// FFTW reports a failed allocation here. Its own function prints a line of its own before it calls abort().
extern "C" [[noreturn]] void fftw_assertion_failed(const char* /*condition*/, int /*line*/, const char* /*file*/) {
  std::abort();
}

static int run_guarded(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const OptionError& e) {
    return print_error(e.written(flag_of), kUsage);
  } catch (const UsageError& e) {
    return print_error(e.what(), kUsage);
  } catch (const acquire::AmbiguousColumns& e) {
    return print_error(e.written(flag_of) + suggested_command({argv, argv + argc}, e.guess), kBadInput);
  } catch (const acquire::NoHitError& e) {
    return print_error(e.written(flag_of), kImpossible);
  } catch (const BudgetSpent& e) {
    return print_error(e.written(flag_of), kImpossible);
  } catch (const InputError& e) {
    return print_error(e.written(flag_of), kBadInput);
  } catch (const std::bad_alloc&) {
    return print_error(kOutOfMemoryMessage, kInternalError);
  } catch (const std::exception& e) {
    return print_error(e.what(), kInternalError);
  }
}

int main(int argc, char** argv) {
  percuss::tools::set_up_process();
  const VisibleOutput output(std::cout), messages(std::cerr);
  std::set_terminate(end_at_once);
  percuss::tools::configure_malloc();
  return percuss::tools::run_with_enough_stack(run_guarded, argc, argv);
}
