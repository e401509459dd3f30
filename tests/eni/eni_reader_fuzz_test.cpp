// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "config/compile/compile.h"
#include "core/config/compile/sample_devices.h"
#include "eni/eni_file.h"

namespace syncline::eni {
namespace {

/// A damaged file is read or refused with its name; it never brings the reader down.
RC_GTEST_PROP(EniReader, SurvivesDamage, ()) {
  static const std::string whole = write_eni(compile(sample::small_machine())->config);
  std::string text = whole;
  const int damages = *rc::gen::inRange(1, 6);
  for (int i = 0; i < damages; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    switch (*rc::gen::inRange(0, 3)) {
      case 0: text.erase(at, *rc::gen::inRange<std::size_t>(1, 40)); break;
      case 1: text[at] = *rc::gen::arbitrary<char>(); break;
      default: {
        const auto from = *rc::gen::inRange<std::size_t>(0, text.size());
        text.insert(at, text.substr(from, *rc::gen::inRange<std::size_t>(1, 40)));
        break;
      }
    }
  }
  const auto config = parse_eni(text, "damaged.xml");
  if (config) {
    const auto again = parse_eni(write_eni(*config), "again.xml");
    RC_ASSERT(again.has_value());
  } else {
    RC_ASSERT(config.error().file == "damaged.xml");
  }
}

}  // namespace
}  // namespace syncline::eni
