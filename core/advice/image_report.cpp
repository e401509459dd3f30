// SPDX-License-Identifier: Apache-2.0
#include "advice/image_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/cyclic_frame.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "config/project.h"
#include "config/slave_config.h"
#include "protocol/frame.h"

namespace syncline {
namespace {

bool is_process_data(const CyclicCmd& cmd) { return is_logical(cmd.command) && cmd.expected_wkc.has_value(); }

std::uint32_t bytes_of(std::uint32_t bits) { return (bits + 7) / 8; }

/// The frame that carries a place of the image, and how often it is sent.
struct Carrier {
  const CyclicFrame* frame = nullptr;
  std::uint32_t multiple = 1;
};

class Reporter {
 public:
  Reporter(const Project& project, const NetworkConfig& config) : project_(project), config_(config) {
    report_.cycle = config.cycle_time();
  }

  ImageReport build() {
    add_frames();
    for (std::size_t i = 0; i < config_.slaves.size(); ++i) {
      add_slave(i);
      add_movable(i);
    }
    std::ranges::stable_sort(report_.slaves, std::greater{}, &SlaveLoad::wire_time);
    std::ranges::stable_sort(report_.movable, [](const MovableObject& a, const MovableObject& b) {
      return a.saved_wire_time != b.saved_wire_time ? a.saved_wire_time > b.saved_wire_time
                                                    : a.saved_bytes > b.saved_bytes;
    });
    return std::move(report_);
  }

 private:
  [[nodiscard]] std::uint32_t multiple(const CyclicTask& task) const {
    return static_cast<std::uint32_t>(
        std::max<Nanoseconds>(task.cycle_time / std::max<Nanoseconds>(report_.cycle, 1), 1));
  }

  void add_frames() {
    double wire_time = 0;
    for (std::size_t t = 0; t < config_.cyclic.size(); ++t) {
      const CyclicTask& task = config_.cyclic[t];
      for (const CyclicFrame& frame : task.frames) {
        FrameLoad load{t, task.cycle_time, frame.commands.size(), 0, 0, syncline::wire_time(frame)};
        load.bytes = static_cast<std::uint32_t>(bytes_sent(frame));
        for (const auto& cmd : frame.commands) load.process_data_bytes += is_process_data(cmd) ? cmd.length() : 0U;
        report_.frames_per_cycle += 1.0 / multiple(task);
        wire_time += static_cast<double>(load.wire_time) / multiple(task);
        report_.busiest_wire_time += load.wire_time;
        report_.frames.push_back(load);
      }
    }
    report_.wire_time = std::llround(wire_time);
    report_.bandwidth = report_.cycle > 0 ? wire_time / static_cast<double>(report_.cycle) : 0;
  }

  /// Of the bit of the image at which a slave's data start.
  [[nodiscard]] Carrier carrier(const ImageRange& range, bool output) const {
    const std::uint32_t byte = range.bit_start / 8;
    for (const auto& task : config_.cyclic) {
      for (const auto& frame : task.frames) {
        for (const auto& cmd : frame.commands) {
          if (!is_process_data(cmd) || cmd.command == (output ? Command::kLrd : Command::kLwr)) continue;
          const std::uint32_t begin =
              (output ? cmd.output_offset : cmd.input_offset) + config_.image.command_data_offset;
          if (byte >= begin && byte < begin + cmd.length()) return {&frame, multiple(task)};
        }
      }
    }
    return {};
  }

  [[nodiscard]] static bool shares_addresses(const SlaveConfig& slave) {
    return slave.send && slave.receive && slave.send->bit_start == slave.receive->bit_start;
  }

  void add_slave(std::size_t i) {
    const SlaveConfig& slave = config_.slaves[i];
    SlaveLoad load{i, slave.name, 0, 0, 0, 0};
    if (slave.send) load.output_bytes = bytes_of(slave.send->bit_length);
    if (slave.receive) load.input_bytes = bytes_of(slave.receive->bit_length);
    const auto cost = [&](const std::optional<ImageRange>& range, bool output, std::uint32_t bytes) {
      load.wire_time += range ? bytes * kWireByteTime / carrier(*range, output).multiple : 0;
    };
    if (shares_addresses(slave)) {
      load.bytes = std::max(load.output_bytes, load.input_bytes);
      cost(slave.send, true, load.bytes);
    } else {
      load.bytes = load.output_bytes + load.input_bytes;
      cost(slave.send, true, load.output_bytes);
      cost(slave.receive, false, load.input_bytes);
    }
    report_.output_bytes += load.output_bytes;
    report_.input_bytes += load.input_bytes;
    report_.slaves.push_back(std::move(load));
  }

  /// Bytes of a slave's datagrams without `bits` of one PDO.
  [[nodiscard]] static std::uint32_t saved_bytes(const SlaveConfig& slave, const ConfiguredPdo& pdo,
                                                 std::uint32_t bits) {
    const bool output = pdo.direction == PdoDirection::kRx;
    std::uint32_t channel_bits = 0;
    for (const auto& other : slave.pdos) {
      if (other.pdo.sync_manager == pdo.pdo.sync_manager && other.direction == pdo.direction)
        channel_bits += other.pdo.bit_length();
    }
    const std::uint32_t fewer = bytes_of(channel_bits) - bytes_of(channel_bits - std::min(bits, channel_bits));
    if (!shares_addresses(slave)) return fewer;
    const std::uint32_t own = bytes_of((output ? slave.send : slave.receive)->bit_length);
    const std::uint32_t other = bytes_of((output ? slave.receive : slave.send)->bit_length);
    return own > other ? std::min(fewer, own - other) : 0;
  }

  void add_movable(std::size_t i) {
    const SlaveConfig& slave = config_.slaves[i];
    const auto& mailbox = project_.slaves[i].device.mailbox;
    if (!mailbox || !mailbox->coe || !mailbox->coe->pdo_config) return;
    for (const ConfiguredPdo& pdo : slave.pdos) {
      if (!pdo.pdo.sync_manager || pdo.pdo.fixed) continue;
      const bool output = pdo.direction == PdoDirection::kRx;
      const auto& range = output ? slave.send : slave.receive;
      if (!range) continue;
      const Carrier at = carrier(*range, output);
      if (at.frame == nullptr) continue;
      const auto full = static_cast<std::uint32_t>(frame_bytes(*at.frame));
      for (const PdoEntry& entry : pdo.pdo.entries) {
        if (entry.index == 0 || entry.fixed) continue;
        MovableObject object{i, slave.name, pdo.pdo.index, entry.index, entry.sub_index, entry.name, entry.bit_length,
                             0, 0};
        object.saved_bytes = saved_bytes(slave, pdo, entry.bit_length);
        constexpr std::uint32_t kLeast = kMinEthernetFrame;
        const std::uint32_t less = std::max(full, kLeast) - std::max(full - object.saved_bytes, kLeast);
        object.saved_wire_time = less * kWireByteTime / at.multiple;
        report_.movable.push_back(std::move(object));
      }
    }
  }

  const Project& project_;
  const NetworkConfig& config_;
  ImageReport report_;
};

}  // namespace

ImageReport image_report(const Project& project, const NetworkConfig& config) {
  auto report = Reporter(project, config).build();
  const auto need = cycle_need(config, true);
  report.travel_time = need.travel;
  report.busiest_cycle = need.all();
  return report;
}

}  // namespace syncline
