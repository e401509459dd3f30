// SPDX-License-Identifier: Apache-2.0
// Random buses: what must hold for every process image.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "compile/compile.h"
#include "protocol/fmmu.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

DeviceDescription random_device() {
  DeviceDescription device = sample::servo();
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return sample::coupler();
    case 1:
      device = sample::digital_input();
      break;
    case 2:
      device = sample::digital_output();
      break;
    default:
      for (auto& manager : device.sync_managers) manager.max_size.reset();
      for (auto* pdos : {&device.rx_pdos, &device.tx_pdos}) {
        pdos->front().entries[0].bit_length = static_cast<std::uint16_t>(*rc::gen::inRange(1, 400) * 8);
      }
      device.use_lrd_lwr = *rc::gen::inRange(0, 10) == 0;
      break;
  }
  // Channels of one to seven bits.
  if (!device.mailbox) {
    for (auto* pdos : {&device.rx_pdos, &device.tx_pdos}) {
      for (auto& pdo : *pdos) pdo.entries[0].bit_length = static_cast<std::uint16_t>(*rc::gen::inRange(1, 8));
    }
  }
  return device;
}

struct MappedBits {
  std::uint64_t first = 0, end = 0;  // logical address in bits
};

std::vector<MappedBits> mapped(const SlaveConfig& slave, bool write) {
  std::vector<MappedBits> out;
  for (const InitCmd& cmd : slave.init_cmds) {
    if (cmd.transitions == std::vector{Transition::kPS} && cmd.ado >= 0x0600 && cmd.ado < 0x0700) {
      const Fmmu fmmu = Fmmu::decode(std::span<const std::uint8_t, Fmmu::kSize>(cmd.data));
      if (fmmu.write == write) {
        const std::uint64_t first = std::uint64_t{fmmu.logical_start} * 8 + fmmu.logical_start_bit;
        out.push_back({first, first + fmmu.bit_length()});
      }
    }
  }
  return out;
}

bool touches(const MappedBits& bits, const CyclicCmd& cmd) {
  return bits.first < (std::uint64_t{cmd.logical_address} + cmd.length()) * 8 &&
         bits.end > std::uint64_t{cmd.logical_address} * 8;
}

void check_no_overlap(const NetworkConfig& config, bool write) {
  std::map<std::uint64_t, std::uint64_t> taken;
  for (const auto& slave : config.slaves) {
    for (const auto& bits : mapped(slave, write)) {
      RC_ASSERT(taken.emplace(bits.first, bits.end).second);
    }
  }
  std::uint64_t end = 0;
  for (const auto& [first, last] : taken) {
    RC_ASSERT(first >= end);
    end = last;
  }
}

/// The working counter as the slaves' FMMUs would count it.
void check_working_counters(const NetworkConfig& config) {
  for (const auto& frame : config.cyclic[0].frames) {
    std::size_t bytes = 0;
    for (const auto& cmd : frame.commands) {
      bytes += 12U + cmd.length();
      if (!is_logical(cmd.command) || cmd.logical_address == 0x0900'0000) continue;
      int expected = 0;
      for (const auto& slave : config.slaves) {
        const auto any = [&](bool write) {
          return std::ranges::any_of(mapped(slave, write), [&](const MappedBits& bits) { return touches(bits, cmd); });
        };
        expected += any(true) && cmd.command != Command::kLrd ? (cmd.command == Command::kLrw ? 2 : 1) : 0;
        expected += any(false) && cmd.command != Command::kLwr ? 1 : 0;
      }
      RC_ASSERT(cmd.expected_wkc == expected);
    }
    RC_ASSERT(bytes <= 1498U);
  }
}

/// Every slave's bits lie in the image where the command that carries them puts them, and inside the image.
void check_image(const NetworkConfig& config) {
  for (const auto& slave : config.slaves) {
    for (const bool write : {true, false}) {
      const auto& range = write ? slave.send : slave.receive;
      const auto bits = mapped(slave, write);
      RC_ASSERT(range.has_value() == !bits.empty());
      if (!range) continue;
      bool found = false;
      for (const auto& frame : config.cyclic[0].frames) {
        for (const auto& cmd : frame.commands) {
          const bool carries = write ? cmd.command != Command::kLrd : cmd.command != Command::kLwr;
          if (is_logical(cmd.command) && carries && touches(bits[0], cmd)) {
            found = true;
            const auto at = (std::uint64_t{cmd.output_offset} + config.image.command_data_offset) * 8 + bits[0].first -
                            std::uint64_t{cmd.logical_address} * 8;
            RC_ASSERT(range->bit_start == at);
          }
        }
      }
      RC_ASSERT(found);
      RC_ASSERT(range->bit_start + range->bit_length <= config.image.output_bytes * 8);
    }
  }
}

RC_GTEST_PROP(Compile, ProcessImageHoldsTogether, ()) {
  std::vector<DeviceDescription> devices;
  const int count = *rc::gen::inRange(1, 30);
  for (int i = 0; i < count; ++i) devices.push_back(random_device());
  const auto dialect = *rc::gen::element(EniDialect::kEcEngineer, EniDialect::kTwinCat);
  Project project = sample::project(std::move(devices));
  project.master.dc.sync_window.enabled = *rc::gen::arbitrary<bool>();
  const auto result = compile(project, {dialect});
  RC_ASSERT(result.has_value());
  check_no_overlap(result->config, true);
  check_no_overlap(result->config, false);
  check_working_counters(result->config);
  check_image(result->config);
  RC_ASSERT(result->config == compile(project, {dialect})->config);
}

}  // namespace
}  // namespace syncline
