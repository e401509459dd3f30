// SPDX-License-Identifier: Apache-2.0
// fuzz_corpus FOLDER: writes the good inputs of every target to FOLDER/TARGET/, for libFuzzer to start from.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "fuzz/targets.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_corpus FOLDER\n";
    return 2;
  }
  for (const auto& target : syncline::fuzz::targets()) {
    const auto folder = std::filesystem::path(argv[1]) / target.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const auto& bytes : target.corpus()) {
      std::ofstream out(folder / std::to_string(number++), std::ios::binary);
      out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      if (!out) {
        std::cerr << "fuzz_corpus: cannot write to " << folder << '\n';
        return 3;
      }
    }
  }
}
