#pragma once

namespace percuss::tools {

/// Prepares the process for limits of the shell that started it. Call it first.
/// - Closed standard streams are opened again so that their use fails. Otherwise a file would get their number, and
///   messages would be written into it.
/// - Writing beyond `ulimit -f` is an error, not a signal.
/// - The process may open as many files as the hard limit allows.
/// - A crash within a library call that ran out of memory (core/library_call.hpp) gives the message for missing memory.
/// - SIGINT, SIGTERM and SIGHUP remove temporary files.
void set_up_process();

/// Calls run(argc, argv) and returns its result. Uses a thread with a stack of its own if the limit of the stack
/// (`ulimit -s`) is too low.
int run_with_enough_stack(int (*run)(int, char**), int argc, char** argv);

}  // namespace percuss::tools
