// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Sync Units: process data that are exchanged together.
namespace syncline {

/// Slaves that are exchanged together, in datagrams of their own: one that fails spoils no other's working counter.
struct SyncUnit {
  std::string name;
  std::string task;  // name of a TaskSettings; "" = the base task
  bool operator==(const SyncUnit&) const = default;
};

/// Su: process data of a device that may live in frames of its own.
struct SyncUnitDescription {
  std::string name{};
  bool separate_su = false;
  bool separate_frame = false;
  bool depend_on_input_state = false;
  bool frame_repeat_support = false;
  bool operator==(const SyncUnitDescription&) const = default;
};

}  // namespace syncline
