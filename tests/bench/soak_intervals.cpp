// SPDX-License-Identifier: Apache-2.0
// soak_intervals [RUNS [SEED [SECONDS]]]: so many simulated machines (1000) of other quartzes, jitter and stamps each,
// for so long in OP (30), and how often the truth is inside the 95 % intervals that they state. Exit code 1 when they
// are too narrow (in less than 93 %) or too wide (in more than 97 %).
#include <fmt/format.h>

#include <cstdlib>
#include <span>

#include "support/types.h"
#include "tests/scenario/interval_machine.h"

int main(int argc, char** argv) {
  using namespace syncline;
  const std::span arguments(argv, static_cast<std::size_t>(argc));
  const auto number = [&](std::size_t place, std::uint64_t usual) {
    return place < arguments.size() ? std::strtoull(arguments[place], nullptr, 10) : usual;
  };
  const auto seconds = static_cast<Nanoseconds>(number(3, 30));
  bool kept = true;
  for (const auto& found : test::interval_coverage(number(1, 1'000), seconds * kSecond, number(2, 1))) {
    const bool good = found.stated == found.runs && found.held >= 0.93 && found.held <= 0.97;
    kept = kept && good;
    fmt::print("{:<28} stated in {} of {} runs, true inside in {:.1f} % (promised: 93 to 97), mean width {:.4g}{}\n",
               found.what, found.stated, found.runs, found.held * 100, found.mean_width, good ? "" : "  MISSED");
  }
  return kept ? 0 : 1;
}
