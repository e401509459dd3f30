// SPDX-License-Identifier: Apache-2.0
// fuzz_corpus FOLDER: writes the good inputs of every target, and those that are kept beside the sources, to
// FOLDER/TARGET/, for libFuzzer to start from.
// fuzz_corpus --keep FOLDER TARGET: keeps what lies in FOLDER beside the sources, for that target.
// fuzz_corpus --list: names the targets.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>

#include "fuzz/kept_corpus.h"
#include "fuzz/targets.h"

namespace {

bool write(const std::filesystem::path& folder, const char* kind, const std::vector<syncline::fuzz::Bytes>& inputs) {
  int number = 0;
  for (const auto& bytes : inputs) {
    std::ofstream out(folder / (kind + std::to_string(number++)), std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (argc == 2 && first == "--list") {
    for (const auto& target : syncline::fuzz::targets()) std::cout << target.name << '\n';
    return 0;
  }
  if (argc == 4 && first == "--keep") {
    if (syncline::fuzz::keep_corpus(argv[3], argv[2])) return 0;
    std::cerr << "fuzz_corpus: cannot keep " << argv[2] << '\n';
    return 3;
  }
  if (argc != 2) {
    std::cerr << "usage: fuzz_corpus FOLDER | --keep FOLDER TARGET | --list\n";
    return 2;
  }
  for (const auto& target : syncline::fuzz::targets()) {
    const auto folder = std::filesystem::absolute(argv[1]) / target.name;
    std::filesystem::create_directories(folder);
    if (!write(folder, "own-", target.corpus()) || !write(folder, "kept-", syncline::fuzz::kept_corpus(target.name))) {
      std::cerr << "fuzz_corpus: cannot write to " << folder << '\n';
      return 3;
    }
  }
}
