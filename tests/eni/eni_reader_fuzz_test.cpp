// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>

#include "compile/compile.h"
#include "config/sim_config.h"
#include "eni/format/eni_file.h"
#include "exports/export_report.h"
#include "exports/exports.h"
#include "recover/recover_project.h"
#include "recover/simulated_network.h"
#include "support/random_project.h"
#include "tests/support/sample_devices.h"

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
      case 0:
        text.erase(at, *rc::gen::inRange<std::size_t>(1, 40));
        break;
      case 1:
        text[at] = *rc::gen::arbitrary<char>();
        break;
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

/// Whatever a user sets, in whatever devices: what is read of the ENI is written as it was.
RC_GTEST_PROP(EniReader, ReadsTheEniOfAnyProject, (std::uint32_t seed, bool twincat)) {
  const auto dialect = twincat ? EniDialect::kTwinCat : EniDialect::kEcEngineer;
  const auto compiled = compile(test::RandomProject(seed).project(), {dialect});
  if (!compiled) return;
  const std::string text = write_eni(compiled->config, style_of(dialect));
  const auto again = parse_eni(text, "any.xml");
  RC_ASSERT(again.has_value());
  RC_ASSERT(write_eni(*again, style_of(dialect)) == text);
}

/// Begin and length of every number in the text of an element.
std::vector<std::pair<std::size_t, std::size_t>> numbers_of(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t at = text.find('>'); at != std::string::npos; at = text.find('>', at + 1)) {
    const auto end = text.find_first_not_of("0123456789", at + 1);
    if (end != std::string::npos && end > at + 1 && text[end] == '<') found.emplace_back(at + 1, end - at - 1);
  }
  return found;
}

/// Whatever numbers a file has: all that is made from it ends, and in a memory of the file's size.
RC_GTEST_PROP(EniReader, ExtremeNumbersHarmNothingThatIsMadeFromTheFile, ()) {
  static const std::string whole = write_eni(compile(sample::small_machine())->config);
  static const auto places = numbers_of(whole);
  std::string text = whole;
  auto chosen = *rc::gen::container<std::vector<std::size_t>>(3, rc::gen::inRange<std::size_t>(0, places.size()));
  std::ranges::sort(chosen, std::greater{});
  for (const std::size_t place : chosen) {
    const std::string number =
        *rc::gen::element<std::string>("0", "-1", "1", "255", "65535", "32768", "2147483647", "16");
    text.replace(places[place].first, places[place].second, number);
  }
  const auto config = parse_eni(text, "extreme.xml");
  if (!config) return;
  const auto recovered = recover_project(*config);
  RC_ASSERT(recovered.project.slaves.size() == config->slaves.size());
  RC_ASSERT(simulated_network(*config).slaves.size() == config->slaves.size());
  RC_ASSERT(simulated_network(recovered.project).slaves.size() == config->slaves.size());
  const std::size_t bytes = exports::c_header(*config, "x").size() + exports::image_csv(*config).size() +
                            exports::pdo_csv(*config).size() + exports::slaves_csv(*config).size() +
                            exports::topology_svg(*config).size();
  RC_ASSERT(bytes < 4 * text.size());
  RC_ASSERT(exports::export_report(*config, {}).ends_with("</html>\n"));
}

}  // namespace
}  // namespace syncline::eni
