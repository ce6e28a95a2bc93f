#include <csignal>
#include <exception>
#include <iostream>
#include <new>

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

int parse_and_run(int argc, char** argv) {
  CLI::App app{"percuss: modes of a structure from hammer tests, with error bars"};
  app.name("percuss");
  app.set_version_flag("--version", "percuss " PERCUSS_VERSION);
  app.require_subcommand(1);
  Run run;
  add_analyze(app, run);
  add_frf(app, run);
  add_nodes(app, run);
  add_survey(app, run);
  add_info(app, run);
  add_calibrate(app, run);
  add_synth(app, run);
  // A word that is no command would be called a missing command.
  const auto named = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty())
    throw UsageError(std::string("there is no command '") + argv[1] + "'", "percuss --help lists them");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);  // --help and --version
  } catch (const CLI::ParseError& e) {
    return report((one_line(e.what()) + "; see percuss --help or percuss COMMAND --help").c_str(), kUsage);
  }
  const int code = run();
  std::cout.flush();
  return std::cout ? code
                   : report("could not write to standard output; is the disk full or the pipe closed?", kBadInput);
}

}  // namespace

extern "C" void clean_up_and_die(int signal) {
  percuss::remove_unfinished_files();  // safe within a signal handler
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int main(int argc, char** argv) {
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
    return report("not enough memory (the whole run); analyse fewer rows or channels at a time", kInternalError);
  } catch (const std::exception& e) {
    return report(e.what(), kInternalError);
  }
}
