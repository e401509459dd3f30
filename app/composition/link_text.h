// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {

enum class LinkKind : std::uint8_t { kSimulated, kAdapter, kReplay };

/// A LINK as the user writes it: "sim:FILE[?virtual][&seed=N][&network=N]", "nic:NAME", "replay:FILE". FILE is a
/// scenario, or an ENI or a project whose bus is simulated.
struct LinkText {
  LinkKind kind = LinkKind::kSimulated;
  std::string target;                 // file or adapter
  bool virtual_clock = false;         // sim only
  std::optional<std::uint64_t> seed;  // sim only; overrides the scenario's
  unsigned network = 0;               // sim only; of a scenario with several networks
  bool operator==(const LinkText&) const = default;
};

/// kBadValue with the accepted forms when `text` is none of them.
[[nodiscard]] Result<LinkText> parse_link_text(std::string_view text);

}  // namespace syncline
