// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/settings/codecs.h"

namespace syncline::settings {
namespace {

constexpr std::uint32_t kLargestMultiple = 1000;

constexpr auto image = [](auto& project) -> auto& { return project.master.image; };

/// The list with item `number` replaced, removed (empty text) or appended. Names are unique in a list.
template <class T>
Status set_item(std::vector<T>& list, std::uint32_t number, Result<std::optional<T>> item) {
  if (!item) return tl::unexpected(item.error());
  const auto place = list.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(number, list.size()));
  if (!*item) {
    if (place != list.end()) list.erase(place);
    return {};
  }
  for (auto other = list.begin(); other != list.end(); ++other) {
    if (other != place && other->name == (*item)->name) {
      return bad_value(fmt::format("\"{}\" is the name of number {} already", other->name, other - list.begin()));
    }
  }
  if (place != list.end()) {
    *place = std::move(**item);
  } else {
    list.push_back(std::move(**item));
  }
  return {};
}

/// "Slow x4"
Result<std::optional<TaskSettings>> parse_task(std::string_view text) {
  if (text.empty()) return std::optional<TaskSettings>{};
  const auto mark = text.rfind(" x");
  const auto multiple = mark == std::string_view::npos ? std::nullopt : parse_integer(text.substr(mark + 2));
  if (!multiple || *multiple < 1 || *multiple > kLargestMultiple) {
    return bad_value(fmt::format("\"{}\" is no NAME xMULTIPLE like Slow x4, with 1..{} bus cycles", text, kLargestMultiple));
  }
  auto name = NameCodec{}.parse(text.substr(0, mark));
  if (!name) return tl::unexpected(name.error());
  return std::optional(TaskSettings{std::move(*name), static_cast<std::uint32_t>(*multiple)});
}

/// "Infeed", "Heating@Slow"
Result<std::optional<SyncUnit>> parse_unit(std::string_view text) {
  if (text.empty()) return std::optional<SyncUnit>{};
  const auto mark = text.rfind('@');
  auto name = NameCodec{}.parse(text.substr(0, mark));
  if (!name) return tl::unexpected(name.error());
  SyncUnit unit{std::move(*name), {}};
  if (mark != std::string_view::npos) {
    auto task = NameCodec{}.parse(text.substr(mark + 1));
    if (!task) return tl::unexpected(task.error());
    unit.task = std::move(*task);
  }
  return std::optional(std::move(unit));
}

Rule task_rule() {
  Rule rule{.key = "master.task.K",
            .type = "cyclic task",
            .range = "NAME xMULTIPLE, 1..1000 bus cycles; nothing removes it",
            .meaning = "A task beside the base task, whose frames are sent in every MULTIPLE-th cycle; K counts from 0, the "
                       "number behind the last adds one.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) -> std::string {
    const auto& tasks = project.master.tasks;
    return place.item < tasks.size() ? fmt::format("{} x{}", tasks[place.item].name, tasks[place.item].multiple) : "";
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_item(project.master.tasks, place.item, parse_task(text));
  };
  rule.items = [](const Project& project, std::size_t) { return numbered(0, project.master.tasks.size()); };
  rule.extendable = true;
  return rule;
}

Rule unit_rule() {
  Rule rule{.key = "master.sync_unit.K",
            .type = "Sync Unit",
            .range = "NAME, NAME@TASK; nothing removes it",
            .meaning = "Slaves that are exchanged together in datagrams of their own, in the base task or in TASK; K counts "
                       "from 0, the number behind the last adds one.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) -> std::string {
    const auto& units = project.master.sync_units;
    if (place.item >= units.size()) return "";
    const auto& [name, task] = units[place.item];
    return task.empty() ? name : fmt::format("{}@{}", name, task);
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_item(project.master.sync_units, place.item, parse_unit(text));
  };
  rule.items = [](const Project& project, std::size_t) { return numbered(0, project.master.sync_units.size()); };
  rule.extendable = true;
  return rule;
}

struct AlignmentCodec : IntegerCodec<std::uint8_t> {
  AlignmentCodec() : IntegerCodec<std::uint8_t>{1, 8, "bytes"} {}
  [[nodiscard]] static std::string range() { return "1, 2, 4, 8"; }
  [[nodiscard]] Result<std::uint8_t> parse(std::string_view text) const {
    const auto value = parse_integer(text);
    const bool power = value && (*value == 1 || *value == 2 || *value == 4 || *value == 8);
    if (!power) return bad_value(fmt::format("\"{}\" is none of {}", text, range()));
    return static_cast<std::uint8_t>(*value);
  }
};

struct AddressCodec : IntegerCodec<std::uint32_t> {
  AddressCodec() : IntegerCodec<std::uint32_t>{0, 0xF000'0000} {}
  [[nodiscard]] static std::string range() { return "0x00000000..0xf0000000"; }
  [[nodiscard]] static std::string format(std::uint32_t value) { return fmt::format("0x{:08x}", value); }
};

}  // namespace

std::vector<Rule> task_rules() {
  return {
      field_rule("network.name", "Name of this network, where a machine has several (--network).", TextCodec{},
                 [](auto& p, const Place&) -> auto& { return p.name; }),
      field_rule("master.image.logical_start", "Logical address of the first process data; auto as the dialect's tool.",
                 AutoCodec<AddressCodec>{}, [](auto& p, const Place&) -> auto& { return image(p).logical_start; }),
      field_rule("master.image.alignment", "The data of each slave begin at a multiple of so many bytes in the process image.",
                 AlignmentCodec{}, [](auto& p, const Place&) -> auto& { return image(p).alignment; }),
      field_rule("master.image.bit_packing",
                 "Digital terminals are mapped bit by bit and may share bytes; off gives each whole bytes.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return image(p).bit_packing; }),
      task_rule(),
      unit_rule(),
  };
}

}  // namespace syncline::settings
