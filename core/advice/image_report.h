// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/types.h"

/// What the cyclic exchange costs on the wire, who makes the cost, and what could be left out of it.
namespace syncline {

struct NetworkConfig;
struct Project;

struct FrameLoad {
  std::size_t task = 0;   // index in NetworkConfig::cyclic
  Nanoseconds cycle = 0;  // of the task
  std::size_t datagrams = 0;
  std::uint32_t bytes = 0;  // Ethernet frame with header, padding and FCS
  std::uint32_t process_data_bytes = 0;
  Nanoseconds wire_time = 0;  // with preamble and gap, at 100 Mbit/s
  bool operator==(const FrameLoad&) const = default;
};

struct SlaveLoad {
  std::size_t slave = 0;
  std::string name;
  std::uint32_t output_bytes = 0, input_bytes = 0;
  /// Bytes that it takes in datagrams; less than the sum where both directions share addresses.
  std::uint32_t bytes = 0;
  Nanoseconds wire_time = 0;  // of these bytes, average of a bus cycle
  bool operator==(const SlaveLoad&) const = default;
};

/// An object that could be exchanged by SDO instead.
struct MovableObject {
  std::size_t slave = 0;
  std::string name;  // of the slave
  std::uint16_t pdo = 0, index = 0;
  std::uint8_t sub_index = 0;
  std::string object;  // its name
  std::uint16_t bits = 0;
  std::uint32_t saved_bytes = 0;    // of the datagrams
  Nanoseconds saved_wire_time = 0;  // average of a bus cycle; 0 where the frame is at its minimum or the other
                                    // direction is as long
  bool operator==(const MovableObject&) const = default;
};

struct ImageReport {
  Nanoseconds cycle = 0;
  std::uint32_t input_bytes = 0, output_bytes = 0;  // process data of all slaves
  std::vector<FrameLoad> frames;
  double frames_per_cycle = 0;         // average; a slower task counts by its share
  Nanoseconds wire_time = 0;           // of all frames, average of a bus cycle
  Nanoseconds busiest_wire_time = 0;   // in a cycle in which all tasks are due
  Nanoseconds travel_time = 0;         // through all slaves, estimated: until a frame is back
  Nanoseconds busiest_cycle = 0;       // until the last frame of such a cycle is back
  double bandwidth = 0;                // wire_time of the cycle, 0..1
  std::vector<SlaveLoad> slaves;       // the costliest first; equal ones in bus order
  std::vector<MovableObject> movable;  // the largest saving first
};

/// `config` is compiled from `project`.
[[nodiscard]] ImageReport image_report(const Project& project, const NetworkConfig& config);

}  // namespace syncline
