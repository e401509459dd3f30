// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/revision_rule.h"

#include <algorithm>
#include <array>

namespace syncline::eni {
namespace {

struct Words {
  std::uint32_t low, high;
  explicit Words(std::uint32_t revision) : low(revision & 0xFFFF), high(revision >> 16) {}
};

struct Rule {
  std::string_view name;
  bool (*fits)(std::uint32_t esi, std::uint32_t scanned);
  const char* words;
};

constexpr std::array<Rule, 7> kRules{{
    {"NONE", [](std::uint32_t, std::uint32_t) { return true; }, "any revision"},
    {"EQ", [](std::uint32_t esi, std::uint32_t scanned) { return esi == scanned; }, "this revision only"},
    {"EQ_OR_G", [](std::uint32_t esi, std::uint32_t scanned) { return scanned >= esi; },
     "this revision or a newer one"},
    {"LW_EQ", [](std::uint32_t esi, std::uint32_t scanned) { return Words(esi).low == Words(scanned).low; },
     "revisions with the same low word"},
    {"LW_EQ_HW_EQ_OR_G",
     [](std::uint32_t esi, std::uint32_t scanned) {
       return Words(esi).low == Words(scanned).low && Words(scanned).high >= Words(esi).high;
     },
     "revisions with the same low word and the same or a newer high word"},
    {"HW_EQ", [](std::uint32_t esi, std::uint32_t scanned) { return Words(esi).high == Words(scanned).high; },
     "revisions with the same high word"},
    {"HW_EQ_LW_EQ_OR_G",
     [](std::uint32_t esi, std::uint32_t scanned) {
       return Words(esi).high == Words(scanned).high && Words(scanned).low >= Words(esi).low;
     },
     "revisions with the same high word and the same or a newer low word"},
}};

const Rule* find_rule(std::string_view name) {
  const auto found = std::ranges::find(kRules, name, &Rule::name);
  return found == kRules.end() ? nullptr : &*found;
}

}  // namespace

bool revision_fits(std::string_view rule, std::uint32_t esi_revision, std::uint32_t scanned_revision) {
  const auto* const known = find_rule(rule);
  return known != nullptr && known->fits(esi_revision, scanned_revision);
}

std::string revision_rule_words(std::string_view rule) {
  const auto* const known = find_rule(rule);
  return known ? known->words : "";
}

}  // namespace syncline::eni
