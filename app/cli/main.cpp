// SPDX-License-Identifier: Apache-2.0
#include <signal.h>

#include <cstdio>
#include <exception>
#include <iostream>

#include "support/memory_reserve.h"
#include "support/standard_streams.h"

#include "app/cli/cli.h"

int main(int argc, char** argv) {
  syncline::take_closed_streams();
  syncline::hold_memory_reserve();
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of that file
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return syncline::cli::run(arguments, {std::cout, std::cerr});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "synclinectl: this should not have happened: %s\n", error.what());
  } catch (...) {
    std::fputs("synclinectl: this should not have happened\n", stderr);
  }
  return syncline::cli::kFailed;
}
