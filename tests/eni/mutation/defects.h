// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "config/network_config.h"
#include "support/random.h"

/// Random defects for good ENIs: what a slip in a tool, an editor or a hand makes of a configuration.
namespace syncline::test {

/// One value, command or order that is wrong.
struct DefectKind {
  const char* name;
  /// True: a master or a slave does something else with it than with the good file, or refuses it, so that it has to be
  /// found in the file alone. False: a file with it is right in itself, only another one.
  bool stumbles;
  /// Puts it at a random place; false where the configuration has none.
  bool (*apply)(NetworkConfig& config, Random& random);
};

[[nodiscard]] std::span<const DefectKind> slave_defects();    // addresses, identity, wiring, PDOs
[[nodiscard]] std::span<const DefectKind> command_defects();  // init commands and their bytes
[[nodiscard]] std::span<const DefectKind> cyclic_defects();   // cyclic commands, image, clocks
[[nodiscard]] std::span<const DefectKind> mailbox_defects();

/// 0 .. count - 1
[[nodiscard]] inline std::size_t pick(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.next() % count);
}

/// A random one of those that `wanted` takes, or null.
template <class Items, class Wanted>
auto* pick_if(Items& items, Random& random, Wanted wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (wanted(items[i])) found.push_back(i);
  }
  return found.empty() ? nullptr : &items[found[pick(random, found.size())]];
}

/// A random init command of any slave that `wanted` takes, with its slave.
struct FoundCommand {
  SlaveConfig* slave = nullptr;
  std::size_t index = 0;
  explicit operator bool() const { return slave != nullptr; }
  [[nodiscard]] InitCmd& operator*() const { return slave->init_cmds[index]; }
  [[nodiscard]] InitCmd* operator->() const { return &slave->init_cmds[index]; }
};
template <class Wanted>
FoundCommand pick_command(NetworkConfig& config, Random& random, Wanted wanted) {
  std::vector<FoundCommand> found;
  for (SlaveConfig& slave : config.slaves) {
    for (std::size_t i = 0; i < slave.init_cmds.size(); ++i) {
      if (wanted(slave.init_cmds[i])) found.push_back({&slave, i});
    }
  }
  return found.empty() ? FoundCommand{} : found[pick(random, found.size())];
}

[[nodiscard]] bool on(const InitCmd& cmd, Transition transition);
/// Writes of a transition into a block of registers, with data.
[[nodiscard]] bool writes_to(const InitCmd& cmd, Transition transition, std::uint16_t first, std::uint16_t size);

}  // namespace syncline::test
