// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/project.h"
#include "support/result.h"

/// One table drives list, get, set and the explanation of every setting.
namespace syncline::settings {

/// The numbers inside a key: "slave.3.startup.2" is slave 3, item 2; "slave.3.pdo.map.0x1607" is item 0x1607;
/// "slave.3.variable.0x1607.1" is item 0x1607, sub-item 1.
struct Place {
  std::size_t slave = 0;
  std::uint32_t item = 0, sub = 0;
  bool operator==(const Place&) const = default;
};

struct Rule {
  std::string key;  // "N" stands for a slave's position, "K" for an item's number, "0xIIII" for a PDO index
  std::string type;
  std::string range;
  std::string meaning;
  std::function<std::string(const Project&, const Place&)> get;
  /// Checks and applies; the error's subject is filled in by the caller. Leaves the project alone when it fails.
  std::function<Status(Project&, const Place&, std::string_view)> set;
  /// For keys with an item: those that exist. `slave` is 0 for keys of the master.
  std::function<std::vector<Place>(const Project&, std::size_t slave)> items{};
  /// A list that `set` may extend by one takes the number behind the last item.
  bool extendable = false;
};

[[nodiscard]] std::vector<Rule> master_rules();
[[nodiscard]] std::vector<Rule> slave_rules();
[[nodiscard]] std::vector<Rule> pdo_rules();
[[nodiscard]] std::vector<Rule> startup_rules();
[[nodiscard]] std::vector<Rule> task_rules();
[[nodiscard]] std::vector<Rule> slave_option_rules();
[[nodiscard]] std::vector<Rule> sync_rules();
[[nodiscard]] std::vector<Rule> module_rules();
[[nodiscard]] std::vector<Rule> variable_rules();

/// Places 0..count-1 of a slave.
[[nodiscard]] inline std::vector<Place> numbered(std::size_t slave, std::size_t count) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({slave, static_cast<std::uint32_t>(i), 0});
  return places;
}

inline tl::unexpected<Error> bad_value(std::string detail) { return fail(ErrorCode::kBadValue, {}, std::move(detail)); }

}  // namespace syncline::settings
