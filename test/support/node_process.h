// A node started by a test: its output, line by line, and how it ended.
#pragma once

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace cdpr_kinetostatics {

class NodeProcess {
 public:
  explicit NodeProcess(const std::string& name) : NodeProcess(NODE_EXECUTABLE, {"__name:=" + name}) {}

  NodeProcess(const std::string& executable, const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>(executable.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      execv(executable.c_str(), words.data());
      _exit(127);
    }
    close(ends[1]);
    output_end_ = ends[0];
  }
  NodeProcess(const NodeProcess&) = delete;
  NodeProcess& operator=(const NodeProcess&) = delete;

  ~NodeProcess() {
    if (!ended_) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    close(output_end_);
  }

  // Reads until the output holds `words`; false if it ends or time is up before.
  bool waitFor(const std::string& words, std::chrono::seconds limit = std::chrono::seconds(30)) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (output_.find(words) == std::string::npos) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
      pollfd poll_end{output_end_, POLLIN, 0};
      if (left.count() <= 0 || poll(&poll_end, 1, static_cast<int>(left.count())) <= 0) return false;
      char buffer[4096];
      const ssize_t count = read(output_end_, buffer, sizeof buffer);
      if (count <= 0) return false;
      output_.append(buffer, static_cast<std::size_t>(count));
    }
    return true;
  }

  // Reads to the end of the output; the exit code, or -1 if a signal ended it or it had to be killed.
  int exitCode() {
    waitFor(std::string(1, '\0'));
    pollfd poll_end{output_end_, POLLIN, 0};
    const bool still_running = poll(&poll_end, 1, 0) == 0;
    if (still_running) kill(pid_, SIGKILL);
    int status = 0;
    waitpid(pid_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void interrupt() const { kill(pid_, SIGINT); }
  // Takes the processor away from it, and gives it back.
  void pause() const { kill(pid_, SIGSTOP); }
  void resume() const { kill(pid_, SIGCONT); }
  bool isRunning() {
    ended_ = ended_ || waitpid(pid_, nullptr, WNOHANG) != 0;
    return !ended_;
  }
  const std::string& output() const { return output_; }

 private:
  pid_t pid_ = -1;
  int output_end_ = -1;
  bool ended_ = false;
  std::string output_;
};

}  // namespace cdpr_kinetostatics
