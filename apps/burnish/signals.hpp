// What ends a program from outside: SIGINT (Ctrl-C), SIGTERM, and SIGHUP unless it is ignored, as
// under nohup. All of them mean the same, and this is the one place that takes them.
#pragma once

namespace burnish::app {

/// From now on they end the program at once, with a sentence: for all that is not worth keeping.
void end_on_signals();

/// While it lives, the first of them asks for an end and the second ends the program at once.
class StopRequest {
 public:
  /// `answer`: what is said when the first one comes, such as "the run ends, and is written".
  explicit StopRequest(const char* answer);
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Whether one has come. From any thread.
  static bool asked() noexcept;
};

}  // namespace burnish::app
