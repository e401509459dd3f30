// SPDX-License-Identifier: Apache-2.0
// fuzz_corpus FOLDER: writes the good inputs of every target to FOLDER/TARGET/, for libFuzzer to start from.
// fuzz_corpus --list: names the targets.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>

#include "fuzz/targets.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_corpus FOLDER | --list\n";
    return 2;
  }
  if (std::string_view(argv[1]) == "--list") {
    for (const auto& target : syncline::fuzz::targets()) std::cout << target.name << '\n';
    return 0;
  }
  for (const auto& target : syncline::fuzz::targets()) {
    const auto folder = std::filesystem::absolute(argv[1]) / target.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const auto& bytes : target.corpus()) {
      std::ofstream out(folder / ("own-" + std::to_string(number++)), std::ios::binary);
      out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      if (!out) {
        std::cerr << "fuzz_corpus: cannot write to " << folder << '\n';
        return 3;
      }
    }
  }
}
