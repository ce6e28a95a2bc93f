#pragma once

namespace percuss::tools {

/// Whether this process may read the terminal and set its mode: a job in the background would be stopped.
bool in_foreground(int terminal);

/// Lets a terminal deliver keys one by one, without echo. Its mode is restored by leave_raw_mode(), at the end of the
/// process, and by the signals that usually end or stop it. When the process goes on in the foreground, the mode is set
/// again.
void enter_raw_mode(int terminal);
/// Sets the mode again in a process that has come to the foreground.
void renew_raw_mode();
/// Restores the mode after the terminal has shown all output. Waits for this at most two seconds, because a stopped
/// terminal shows nothing.
void leave_raw_mode();
/// Whether the process was stopped and goes on, since the last call.
bool has_continued();

/// While it lives, SIGINT, SIGTERM and SIGHUP ask the session to finish. A second signal, more than half a second
/// later, restores the terminal's mode and takes its previous action, which normally ends the process. Writing to a
/// closed pipe is an error, not a signal.
class SessionSignals {
 public:
  SessionSignals();
  ~SessionSignals();
  SessionSignals(const SessionSignals&) = delete;
  SessionSignals& operator=(const SessionSignals&) = delete;

  /// The signal that arrived; 0: none.
  static int arrived();
};

}  // namespace percuss::tools
