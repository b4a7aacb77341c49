// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.hpp"

#include <sys/mman.h>

#include <csignal>
#include <initializer_list>

#include "golden/error.hpp"

namespace trihedron::cli {
namespace {

// In memory that processes forked later share: who signals one of them stops the work of all.
volatile std::sig_atomic_t* received = nullptr;

void remember(int signal) { *received = signal; }

volatile std::sig_atomic_t* shared_flag() {
  void* page =
      mmap(nullptr, sizeof *received, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw Error("no memory to share with worker processes");
  return static_cast<volatile std::sig_atomic_t*>(page);
}

}  // namespace

Interruption::Interruption() {
  if (received == nullptr) received = shared_flag();
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // a second signal acts as ever
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // as nohup wants it
  }
}

bool Interruption::requested() { return received != nullptr && *received != 0; }
int Interruption::exit_code() { return 128 + *received; }

}  // namespace trihedron::cli
