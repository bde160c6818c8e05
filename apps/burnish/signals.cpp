#include "signals.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "record/run_folder.hpp"

namespace burnish::app {
namespace {

/// Text to print at the first signal; null: the first signal ends the program. Signal handlers read
/// this variable.
std::atomic<const char*> answer_to_first = nullptr;
std::atomic<bool> stop_asked = false;
static_assert(std::atomic<const char*>::is_always_lock_free);
static_assert(std::atomic<bool>::is_always_lock_free);

/// Prints text with functions that a signal handler may call.
void say(const char* text) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
}

const char* name_of(int signal) {
  return signal == SIGTERM ? "SIGTERM" : signal == SIGHUP ? "SIGHUP" : "Ctrl-C";
}

extern "C" void take_signal(int signal) {
  const int interrupted = errno;                    // the interrupted code may still use errno
  if (isatty(STDERR_FILENO) != 0) say("\r\033[K");  // erases the progress bar
  say("burnish: ");
  say(name_of(signal));
  const char* answer = answer_to_first;
  if (answer != nullptr && !stop_asked.exchange(true)) {
    say(": ");
    say(answer);
    say("; repeat it to end immediately\n");
    errno = interrupted;
    return;
  }
  mark_running_as_stopped();
  say(answer != nullptr ? ": ended immediately\n" : ": interrupted, nothing was written\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void end_on_signals() {
  answer_to_first = nullptr;
  stop_asked = false;
  std::signal(SIGINT, take_signal);
  std::signal(SIGTERM, take_signal);
  if (std::signal(SIGHUP, take_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

StopRequest::StopRequest(const char* answer) {
  stop_asked = false;
  answer_to_first = answer;
}

StopRequest::~StopRequest() { answer_to_first = nullptr; }

bool StopRequest::asked() noexcept { return stop_asked; }

}  // namespace burnish::app
