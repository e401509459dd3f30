// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "app/cli/cli.h"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return syncline::cli::run(arguments, {std::cout, std::cerr});
}
