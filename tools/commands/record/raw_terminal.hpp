#pragma once

namespace percuss::tools {

/// Lets a terminal deliver keys one by one, without echo. Its mode is restored by leave_raw_mode(), at the end of the
/// process, and by every signal that ends or stops it and can be caught.
void enter_raw_mode(int terminal);
void leave_raw_mode();

/// While it lives, SIGINT, SIGTERM and SIGHUP ask the session to finish; the second SIGINT ends the process as before.
/// Writing to a closed pipe is an error, not a signal.
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
