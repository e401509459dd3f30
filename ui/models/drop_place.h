// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

/// Where in the network something is dropped.
struct DropPlace {
  int slave = -1;       // -1: at the master, before all others
  bool before = false;  // in front of that slave and nowhere else; else behind it, where it fits
  bool operator==(const DropPlace&) const = default;
};

}  // namespace syncline::ui
