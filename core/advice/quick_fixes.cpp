// SPDX-License-Identifier: Apache-2.0
#include "advice/quick_fixes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "check/check_network.h"
#include "compile/incremental.h"
#include "config/sync0_cycle.h"
#include "findings/run_bus_words.h"
#include "findings/run_slaves_words.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

using settings::Place;
using settings::Setting;
using settings::Value;

constexpr std::size_t kMostTried = 24;

bool is_rule(std::string_view code) {
  const auto rules = check_rules();
  return std::ranges::find(rules, code, &FindingWords::code) != rules.end();
}

bool is_of_run(std::string_view code) {
  const auto is_it = [code](const FindingWords& row) { return row.code == code; };
  return std::ranges::any_of(words::kRunSlaves, is_it) || std::ranges::any_of(words::kRunBus, is_it);
}

/// What the figures of a run advise for a number: a whole value ("shift"), or so much more than it was ("more"), which
/// is known where it is left to the master: a number may have been set since, by this very advice.
std::optional<std::int64_t> advised_number(const Project& project, const Finding& finding, const Setting& setting,
                                           const Place& place) {
  const auto figure = [&finding](std::string_view name) {
    const auto found = std::ranges::find(finding.figures, name, &Figure::name);
    return found == finding.figures.end() ? std::nullopt : std::optional(found->value);
  };
  if (const auto whole = figure("shift")) {
    // The registers had the master's input shift in it, too, where that counts.
    const auto& slave = project.slaves[place.slave];
    const auto* mode = compiler::selected_op_mode(slave);
    return *whole - (mode != nullptr && compiler::is_input_based(*mode, slave.dc) ? project.master.dc.input_shift : 0);
  }
  const auto more = figure("more");
  if (setting.read(project, place) != Value{}) return std::nullopt;
  const auto now = settings::effective_value(setting, project, place);
  const auto* number = std::get_if<std::int64_t>(&now);
  return more && number != nullptr ? std::optional(*number + *more) : std::nullopt;
}

/// No compilation shows whether it is gone: the switch that its row names, where that is off, and the number that its
/// figures advise, where the setting takes it.
std::vector<QuickFix> fixes_of_run(const Project& project, const Finding& finding) {
  const auto found =
      settings::find(project, setting_at(find_finding_words(finding.code)->setting, finding.place.slave), false);
  if (!found) return {};
  const auto& [setting, place] = *found;
  const auto now = setting->read(project, place);
  if (now == Value{false}) return {{setting, {place}, true}};
  if (!std::holds_alternative<settings::Number>(setting->type)) return {};
  const auto wanted = advised_number(project, finding, *setting, place);
  if (!wanted || now == Value{*wanted} || !settings::working_range(*setting, project, place).contains(*wanted))
    return {};
  return {{setting, {place}, *wanted}};
}

/// What the compiler says, and for a finding of the checker what that says of the configuration, with its settings.
std::vector<Finding> findings_of(const CompileResult& compiled, bool with_rules) {
  auto findings = compiled.findings;
  if (!with_rules) return findings;
  for (auto& found : check_network(compiled.config)) {
    if (found.place.key.empty())
      found.place.key = setting_at(find_finding_words(found.code)->setting, found.place.slave);
    findings.push_back(std::move(found));
  }
  return findings;
}

bool same_thing(const Finding& a, const Finding& b) {
  return a.code == b.code && a.place.slave == b.place.slave && a.place.key == b.place.key;
}

bool contains(const std::vector<Finding>& findings, const Finding& wanted) {
  return std::ranges::any_of(findings, [&](const Finding& one) { return same_thing(one, wanted); });
}

/// The smallest number that no other slave has here.
std::optional<std::int64_t> free_number(const Setting& setting, const Project& project, const Place& place,
                                        const settings::Range& range) {
  std::vector<std::int64_t> used;
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    if (i == place.slave) continue;
    const auto value = setting.read(project, {i, place.item, place.sub});
    if (const auto* number = std::get_if<std::int64_t>(&value)) used.push_back(*number);
  }
  const auto largest = used.empty() ? range.low : std::max(range.low, *std::ranges::max_element(used) + 1);
  return range.contains(largest) ? std::optional(largest) : std::nullopt;
}

class Candidates {
 public:
  Candidates(const Setting& setting, const Project& project, const Place& place, const Finding& finding)
      : setting_(setting), project_(project), place_(place), now_(setting.read(project, place)) {
    if (std::holds_alternative<settings::Number>(setting.type)) add_told(finding);
    std::visit([this](const auto& type) { add_of(type); }, setting.type);
    if (!setting.unset.empty()) add(settings::Unset{});
  }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

 private:
  void add(Value value) {
    if (value != now_ && std::ranges::find(values_, value) == values_.end() && values_.size() < kMostTried)
      values_.push_back(std::move(value));
  }
  /// What the finding says itself: next to the number in force the multiples of a step, and a limit.
  void add_told(const Finding& finding) {
    const auto effective = settings::effective_value(setting_, project_, place_);
    const auto* number = std::get_if<std::int64_t>(&effective);
    for (const auto& figure : finding.figures) {
      if (figure.name == "limit") add(figure.value);
      if (figure.name != "step" || figure.value <= 0 || number == nullptr || *number <= 0) continue;
      const auto below = *number / figure.value * figure.value;
      if (below > 0) add(below);
      add(below + figure.value);
    }
  }
  void add_of(const settings::Switch&) {
    if (const auto* on = std::get_if<bool>(&now_)) add(!*on);
  }
  void add_of(const settings::Number&) {
    const auto range = settings::working_range(setting_, project_, place_);
    const auto effective = settings::effective_value(setting_, project_, place_);
    const auto* number = std::get_if<std::int64_t>(&effective);
    const bool high_first = number != nullptr && *number > range.high;
    const auto add_free = [&] {
      if (const auto free = free_number(setting_, project_, place_, range); setting_.of_slave() && free) add(*free);
    };
    // One that the setting takes is wrong beside those of others: no end of the range is nearer than what they leave.
    const bool beside_others = number != nullptr && range.contains(*number);
    if (beside_others) add_free();
    add(high_first ? range.high : range.low);
    if (!beside_others) add_free();
    add(high_first ? range.low : range.high);
  }
  void add_of(const settings::Choice& choice) {
    const auto options = setting_.options ? setting_.options(project_, place_) : choice.options;
    for (const auto& option : options) add(option.value);
  }
  /// A name that others have: the same with the smallest number behind it that nobody has.
  void add_of(const settings::Text&) {
    const auto* now = std::get_if<std::string>(&now_);
    if (now == nullptr || now->empty() || !setting_.of_slave()) return;
    std::vector<Value> used;
    for (std::size_t i = 0; i < project_.slaves.size(); ++i)
      used.push_back(setting_.read(project_, {i, place_.item, place_.sub}));
    if (std::ranges::count(used, now_) < 2) return;
    for (std::size_t number = 2; number <= used.size() + 1; ++number) {
      Value numbered = fmt::format("{} ({})", *now, number);
      if (std::ranges::find(used, numbered) == used.end()) return add(std::move(numbered));
    }
  }
  /// Without one of them.
  void add_of(const settings::Indices&) {
    const auto* all = std::get_if<std::vector<std::uint16_t>>(&now_);
    for (std::size_t i = 0; all != nullptr && i < all->size(); ++i) {
      auto fewer = *all;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      add(std::move(fewer));
    }
  }
  template <class Other>
  void add_of(const Other&) {}  // what is to be typed, nobody guesses

  const Setting& setting_;
  const Project& project_;
  Place place_;
  Value now_;
  std::vector<Value> values_;
};

/// What the places of a fix belong to.
void restore(Project& changed, const Project& project, const QuickFix& fix) {
  if (!fix.setting->of_slave()) {
    changed.name = project.name;
    changed.master = project.master;
    return;
  }
  for (const auto& place : fix.places) changed.slaves[place.slave] = project.slaves[place.slave];
}

}  // namespace

std::vector<QuickFix> quick_fixes(const Project& project, const Finding& finding, std::span<const int> slaves,
                                  std::size_t most) {
  if (is_of_run(finding.code)) return fixes_of_run(project, finding);
  const auto found = settings::find(project, finding.place.key, false);
  if (!found) return {};
  const bool with_rules = is_rule(finding.code);
  Project changed = project;
  IncrementalCompiler compiler;  // of a large machine only what a value touches is done again
  std::vector<Finding> before;
  if (const auto compiled = compiler.update(changed)) {
    before = findings_of(**compiled, with_rules);
  } else {
    return {};
  }
  QuickFix fix{found->setting, {found->place}, {}};
  for (const int slave : slaves) {
    const auto at = static_cast<std::size_t>(slave);
    if (found->setting->of_slave() && slave >= 0 && at < project.slaves.size() && at != found->place.slave)
      fix.places.push_back({at, found->place.item, found->place.sub});
  }
  const auto gone = [&](const std::vector<Finding>& after) {
    return std::ranges::none_of(after, [&](const Finding& one) {
      if (one.code == finding.code && one.place.key == finding.place.key) return true;
      const bool there = std::ranges::any_of(slaves, [&](int slave) { return slave == one.place.slave; });
      if (one.code == finding.code && there) return true;
      return one.severity >= std::min(finding.severity, Severity::kWarning) && !contains(before, one);
    });
  };
  std::vector<QuickFix> fixes;
  const Candidates candidates(*found->setting, project, found->place, finding);
  for (const auto& value : candidates.values()) {
    fix.value = value;
    // A value may bring others with it, like an operation mode its PDOs: each begins with the project as it is.
    restore(changed, project, fix);
    const bool taken = std::ranges::all_of(fix.places, [&](const settings::Place& place) {
      return settings::set_value(*fix.setting, changed, place, value).has_value();
    });
    if (!taken) continue;
    const auto after = compiler.update(changed);
    if (after && gone(findings_of(**after, with_rules))) fixes.push_back(fix);
    if (fixes.size() == most) break;
  }
  return fixes;
}

}  // namespace syncline
