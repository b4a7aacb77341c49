// SPDX-License-Identifier: Apache-2.0
#include "cli/workers.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>

#include "cli/progress.hpp"
#include "golden/error.hpp"

namespace trihedron::cli {
namespace {

/// What a worker sends ahead of each text.
struct Header {
  std::uint64_t item = 0;
  std::uint64_t bytes = 0;
  std::uint64_t failed = 0;  ///< the text is an error message
};

struct Answer {
  bool done = false, failed = false;
  std::string text;
};

Answer answer_of(std::size_t item, const std::function<std::string(std::size_t)>& work) {
  try {
    return {true, false, work(item)};
  } catch (const std::exception& error) {
    return {true, true, error.what()};
  }
}

bool write_all(int pipe, const void* data, std::size_t bytes) {
  const char* at = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = write(pipe, at, bytes);
    if (written <= 0) return false;
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

struct Worker {
  pid_t process = -1;
  int pipe = -1;
  std::string received;
};

/// Starts the worker of every jobs-th item from `first`.
Worker start_worker(std::size_t first, std::size_t count, int jobs,
                    const std::function<std::string(std::size_t)>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw Error("cannot make a pipe to a worker process");
  std::fflush(stdout);
  const pid_t process = fork();
  if (process < 0) throw Error("cannot start a worker process; expected fewer --jobs");
  if (process > 0) {
    close(ends[1]);
    return {process, ends[0], {}};
  }
  close(ends[0]);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody would read what it does any more
  for (std::size_t item = first; item < count; item += static_cast<std::size_t>(jobs)) {
    const Answer answer = answer_of(item, work);
    const Header header{item, answer.text.size(), answer.failed ? 1u : 0u};
    if (!write_all(ends[1], &header, sizeof header) ||
        !write_all(ends[1], answer.text.data(), answer.text.size()))
      break;
    if (answer.failed) break;
  }
  _exit(0);  // leaves the parent's buffers and exit handlers alone
}

/// Takes the whole answers off what has been received.
void take_answers(Worker& worker, std::vector<Answer>& answers, Progress& progress) {
  Header header;
  while (worker.received.size() >= sizeof header) {
    std::memcpy(&header, worker.received.data(), sizeof header);
    if (worker.received.size() < sizeof header + header.bytes) return;
    answers[header.item] = {true, header.failed != 0,
                            worker.received.substr(sizeof header, header.bytes)};
    worker.received.erase(0, sizeof header + header.bytes);
    progress.step();
  }
}

void listen(std::vector<Worker>& workers, std::vector<Answer>& answers, Progress& progress) {
  std::size_t open = workers.size();
  while (open > 0) {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers) waiting.push_back({worker.pipe, POLLIN, 0});
    if (poll(waiting.data(), waiting.size(), -1) < 0) continue;
    for (std::size_t w = 0; w < workers.size(); ++w) {
      if (waiting[w].revents == 0) continue;
      std::array<char, 1 << 16> buffer;
      const ssize_t got = read(workers[w].pipe, buffer.data(), buffer.size());
      if (got > 0) {
        workers[w].received.append(buffer.data(), static_cast<std::size_t>(got));
        take_answers(workers[w], answers, progress);
        continue;
      }
      close(workers[w].pipe);
      workers[w].pipe = -1;  // poll skips it
      --open;
    }
  }
  for (const Worker& worker : workers) waitpid(worker.process, nullptr, 0);
}

}  // namespace

std::vector<std::string> run_workers(std::size_t count, int jobs, const std::string& what,
                                     const std::function<std::string(std::size_t)>& work) {
  std::vector<Answer> answers(count);
  Progress progress(count, what);
  jobs = std::min<int>(jobs, static_cast<int>(std::max<std::size_t>(count, 1)));
  if (jobs == 1) {
    for (std::size_t i = 0; i < count; ++i) {
      answers[i] = answer_of(i, work);
      if (answers[i].failed) break;
      progress.step();
    }
  } else {
    std::vector<Worker> workers;
    for (int w = 0; w < jobs; ++w)
      workers.push_back(start_worker(static_cast<std::size_t>(w), count, jobs, work));
    listen(workers, answers, progress);
  }
  for (const Answer& answer : answers)
    if (answer.failed) throw Error(answer.text);
  std::vector<std::string> texts;
  for (Answer& answer : answers) {
    if (!answer.done) throw Error("a worker process died before it was done");
    texts.push_back(std::move(answer.text));
  }
  return texts;
}

}  // namespace trihedron::cli
