// SPDX-License-Identifier: Apache-2.0
#include "fuzz/xml_damage.h"

#include "fuzz/damage.h"

namespace syncline::fuzz {
namespace {

struct Range {
  std::size_t from = 0, to = 0;
};

/// A text between tags or an attribute's value, near a random place.
Range some_xml_value(std::string_view text, Random& random) {
  const bool attribute = random.next() % 2 == 0;
  const char open = attribute ? '"' : '>', close = attribute ? '"' : '<';
  const auto from = text.find(open, pick(random, text.size()));
  if (from == std::string_view::npos) return {};
  const auto to = text.find(close, from + 1);
  return to == std::string_view::npos ? Range{} : Range{from + 1, to};
}

/// From a start tag to the end of its element, as far as names tell.
Range some_element(std::string_view text, Random& random) {
  const auto from = text.find('<', pick(random, text.size()));
  if (from == std::string_view::npos) return {};
  const auto name_end = text.find_first_of(" />\n", from + 1);
  if (name_end == std::string_view::npos) return {};
  const std::string end = "</" + std::string(text.substr(from + 1, name_end - from - 1)) + ">";
  const auto to = text.find(end, name_end);
  return to == std::string_view::npos ? Range{} : Range{from, to + end.size()};
}

void damage_once(std::string& text, Random& random) {
  const auto value = some_xml_value(text, random);
  const auto element = some_element(text, random);
  const std::string copy = text.substr(element.from, element.to - element.from);
  switch (random.next() % 8) {
    case 0:
    case 1:
    case 2:
      text.replace(value.from, value.to - value.from, nasty_value(random));
      break;
    case 3: {
      const auto other = some_xml_value(text, random);
      text.replace(value.from, value.to - value.from, std::string(text.substr(other.from, other.to - other.from)));
      break;
    }
    case 4:
      text.erase(element.from, copy.size());
      break;
    case 5:
      text.insert(element.from, copy);
      break;
    case 6: {
      const auto other = some_element(text, random);
      text.insert(other.from, copy);
      break;
    }
    default:
      if (!text.empty()) text[pick(random, text.size())] = static_cast<char>(random.next());
  }
}

}  // namespace

std::string damage_xml(std::string_view text, Random& random) {
  constexpr std::size_t kMost = 256 * 1024;
  std::string damaged(text);
  for (auto changes = random.next() % 4 + 1; changes > 0; --changes) damage_once(damaged, random);
  if (damaged.size() > kMost) damaged.resize(kMost);
  return damaged;
}

}  // namespace syncline::fuzz
