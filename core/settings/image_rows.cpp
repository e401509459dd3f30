// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/not_in_eni.h"
#include "settings/number_text.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr auto image = [](auto& project) -> auto& { return project.master.image; };

Result<std::string> parse_name(std::string_view text) {
  auto value = parse_value(Text{}, text);
  if (!value) return tl::unexpected(value.error());
  return std::get<std::string>(std::move(*value));
}

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
      return bad_value(because("\"{name}\" is the name of number {number} already", other->name, other - list.begin()));
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
  if (!multiple || *multiple < 1 || *multiple > limits::kLargestMultiple) {
    return bad_value(because("\"{text}\" is no NAME xMULTIPLE like Slow x4, with 1..{most} bus cycles", text,
                             limits::kLargestMultiple));
  }
  auto name = parse_name(text.substr(0, mark));
  if (!name) return tl::unexpected(name.error());
  return std::optional(TaskSettings{std::move(*name), static_cast<std::uint32_t>(*multiple)});
}

/// "Infeed", "Heating@Slow"
Result<std::optional<SyncUnit>> parse_unit(std::string_view text) {
  if (text.empty()) return std::optional<SyncUnit>{};
  const auto mark = text.rfind('@');
  auto name = parse_name(text.substr(0, mark));
  if (!name) return tl::unexpected(name.error());
  SyncUnit unit{std::move(*name), {}};
  if (mark != std::string_view::npos) {
    auto task = parse_name(text.substr(mark + 1));
    if (!task) return tl::unexpected(task.error());
    unit.task = std::move(*task);
  }
  return std::optional(std::move(unit));
}

Setting task_row() {
  Setting row{
      .key = "master.task.K",
      .type = Record{"cyclic task", "NAME xMULTIPLE, 1..1000 bus cycles; nothing removes it"},
      .words = {.label = "Task",
                .help = "A task beside the base task, whose frames are sent in every MULTIPLE-th cycle; K counts from "
                        "0, the number behind the last adds one.",
                .eni = "Cyclic",
                .expert = true},
      .read = {},
      .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& tasks = project.master.tasks;
    return place.item < tasks.size() ? fmt::format("{} x{}", tasks[place.item].name, tasks[place.item].multiple) : "";
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_item(project.master.tasks, place.item, parse_task(std::get<std::string>(value)));
  };
  row.items = [](const Project& project, std::size_t) { return numbered(0, project.master.tasks.size()); };
  row.extendable = true;
  return row;
}

Setting unit_row() {
  Setting row{
      .key = "master.sync_unit.K",
      .type = Record{"Sync Unit", "NAME, NAME@TASK; nothing removes it"},
      .words = {.label = "Sync Unit",
                .help = "Slaves that are exchanged together in datagrams of their own, in the base task or in TASK; K "
                        "counts from 0, the number behind the last adds one.",
                .eni = "Cyclic/Frame/Cmd",
                .expert = true},
      .read = {},
      .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& units = project.master.sync_units;
    if (place.item >= units.size()) return std::string();
    const auto& [name, task] = units[place.item];
    return task.empty() ? name : fmt::format("{}@{}", name, task);
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_item(project.master.sync_units, place.item, parse_unit(std::get<std::string>(value)));
  };
  row.items = [](const Project& project, std::size_t) { return numbered(0, project.master.sync_units.size()); };
  row.extendable = true;
  return row;
}

Choice alignments() {
  Choice choice{.options = {}, .unit = "bytes"};
  for (const std::int64_t bytes : {1, 2, 4, 8}) choice.options.push_back({bytes, std::to_string(bytes), {}});
  return choice;
}

}  // namespace

std::vector<Setting> image_rows() {
  constexpr Number kAddress{.range = {0, 0xF000'0000}, .hex_digits = 8};
  return {
      field_setting(
          "network.name", Text{.kind = "text", .may_be_empty = true},
          {.label = "Network",
           .help = "Name of this network, where a machine has several (--network).",
           .no_eni = not_in_eni::kProject},
          [](auto& p, const Place&) -> auto& { return p.name; }),
      field_setting(
          "master.image.logical_start", kAddress,
          {.label = "Logical start address",
           .help = "Logical address of the first process data; auto as the dialect's tool.",
           .object = "FMMU 0x0600",
           .eni = "Cyclic/Frame/Cmd/Addr",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return image(p).logical_start; }),
      field_setting(
          "master.image.alignment", alignments(),
          {.label = "Alignment",
           .help = "The data of each slave begin at a multiple of so many bytes in the process image.",
           .eni = "ProcessImage",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return image(p).alignment; }),
      field_setting(
          "master.image.bit_packing", Switch{},
          {.label = "Bit packing",
           .help = "Digital terminals are mapped bit by bit and may share bytes; off gives each whole bytes.",
           .object = "FMMU 0x0600",
           .eni = "ProcessImage",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return image(p).bit_packing; }),
      task_row(),
      unit_row(),
  };
}

}  // namespace syncline::settings
