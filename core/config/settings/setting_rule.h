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

/// The numbers inside a key: "slave.3.startup.2" is slave 3, item 2; "slave.3.pdo.map.0x1607" is item 0x1607.
struct Place {
  std::size_t slave = 0;
  std::uint32_t item = 0;
};

struct Rule {
  std::string key;  // "N" stands for a slave's position, "K" for an item's number, "0xIIII" for a PDO index
  std::string type;
  std::string range;
  std::string meaning;
  std::function<std::string(const Project&, const Place&)> get;
  /// Checks and applies; the error's subject is filled in by the caller. Leaves the project alone when it fails.
  std::function<Status(Project&, const Place&, std::string_view)> set;
  /// For keys with an item: those that exist.
  std::function<std::vector<std::uint32_t>(const SlaveSettings&)> items{};
  /// A list that `set` may extend by one takes the number behind the last item.
  bool extendable = false;
};

[[nodiscard]] std::vector<Rule> master_rules();
[[nodiscard]] std::vector<Rule> slave_rules();
[[nodiscard]] std::vector<Rule> pdo_rules();
[[nodiscard]] std::vector<Rule> startup_rules();

inline tl::unexpected<Error> bad_value(std::string detail) { return fail(ErrorCode::kBadValue, {}, std::move(detail)); }

}  // namespace syncline::settings
