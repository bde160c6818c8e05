// Handling of the signals SIGINT (Ctrl-C), SIGTERM and SIGHUP, which all end the program. SIGHUP
// stays ignored if it is ignored at the start of the program, as under nohup.
#pragma once

namespace burnish::app {

/// Makes all three signals end the program immediately, with a sentence on the standard error.
void end_on_signals();

/// Graceful stop on signals, for the lifetime of this object. The first signal makes asked() true;
/// the second ends the program immediately.
class StopRequest {
 public:
  /// `answer`: text printed at the first signal, such as "the run ends and is written".
  explicit StopRequest(const char* answer);
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Returns whether a signal has arrived. May be called from any thread.
  static bool asked() noexcept;
};

}  // namespace burnish::app
