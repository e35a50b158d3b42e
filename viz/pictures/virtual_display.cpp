#include "viz/pictures/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace gnomon::viz {
namespace {

constexpr int patience = 20000;  ///< milliseconds for a server to start

/// The two ends of a pipe.
struct Pipe {
  int read = -1;
  int write = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a virtual display can be made");
    read = ends[0];
    write = ends[1];
  }
  ~Pipe() {
    close(read);
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_write() {
    if (write >= 0) close(write);
    write = -1;
  }
};

/// The server itself: it picks a free number, writes it to the pipe, and goes when its parent goes.
[[noreturn]] void become_server(const Pipe& pipe, pid_t parent, const std::string& descriptor) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  close(pipe.read);
  execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24", "-noreset", "-nolisten",
         "tcp", static_cast<char*>(nullptr));
  _exit(127);
}

/// What the server writes, up to the end of the line; less if it ends or takes too long.
std::string first_line(int descriptor) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience);
  std::string line;
  while (line.find('\n') == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd wait{descriptor, POLLIN, 0};
    if (left.count() <= 0 || poll(&wait, 1, static_cast<int>(left.count())) == 0) break;
    std::array<char, 32> buffer{};
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count <= 0) break;
    line.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return line;
}

/// Ends a server and returns its exit code; -1 if it had to be told to end.
int ended(pid_t server) {
  int status = 0;
  if (waitpid(server, &status, WNOHANG) == 0) {
    kill(server, SIGTERM);
    waitpid(server, &status, 0);
    return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  Pipe pipe;
  const pid_t parent = getpid();
  const std::string descriptor = std::to_string(pipe.write);  // made here: a forked process must not allocate
  server_ = fork();
  if (server_ < 0) throw std::runtime_error("no process for a virtual display can be made");
  if (server_ == 0) become_server(pipe, parent, descriptor);
  pipe.close_write();
  const std::string line = first_line(pipe.read);
  if (line.find('\n') != std::string::npos) {
    name_ = ":" + line.substr(0, line.find('\n'));
    return;
  }
  poll(nullptr, 0, line.empty() ? 100 : 0);  // the pipe closes a moment before the exit code is there
  const int code = ended(server_);
  throw std::runtime_error(code == 127 ? "Xvfb, which makes a virtual one, is not installed" : "Xvfb does not start");
}

VirtualDisplay::~VirtualDisplay() {
  ended(server_);
}

}  // namespace gnomon::viz
