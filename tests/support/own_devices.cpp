// SPDX-License-Identifier: Apache-2.0
#include "tests/support/own_devices.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace syncline::sample {
namespace {

constexpr std::uint32_t kRevision = 0x10000;
using Indices = std::vector<std::uint16_t>;

DeviceDescription device(std::uint32_t product, const std::string& type, const std::string& about) {
  DeviceDescription made;
  made.identity = {0x5C17, product, kRevision, 0};
  made.vendor_name = "Syncline Simulated Devices";
  made.type = type;
  made.name = type + " " + about;
  return made;
}

void group(DeviceDescription& device, const std::string& type, const std::string& name) {
  device.group_type = type;
  device.group_name = name;
}

/// `first`: of the 14 bytes of ConfigData; the others are 0.
std::vector<std::uint8_t> config_data(std::vector<std::uint8_t> first) {
  first.resize(14);
  return first;
}

PdoEntry entry(std::uint16_t index, std::uint8_t sub_index, std::uint16_t bits, std::string name, std::string type) {
  return {index, sub_index, bits, std::move(name), std::move(type)};
}
const PdoEntry kGap{0, 0, 8, "", ""};

Pdo pdo(std::uint16_t index, std::string name, std::optional<std::uint8_t> manager, std::vector<PdoEntry> entries) {
  Pdo made;
  made.index = index;
  made.name = std::move(name);
  made.sync_manager = manager;
  made.entries = std::move(entries);
  return made;
}

SyncManagerDescription manager(SyncManagerType type, std::uint16_t start, std::uint8_t control, std::uint16_t size) {
  SyncManagerDescription made;
  made.type = type;
  made.start_address = start;
  made.control_byte = control;
  made.enable = true;
  made.default_size = size;
  return made;
}

// ---- couplers and terminals

DeviceDescription coupler(std::uint32_t product, const std::string& type, const std::string& about) {
  auto made = device(product, type, about);
  made.physics = product == 0x1100 ? "YKY" : "YYYY";
  product == 0x1100 ? group(made, "SystemCouplers", "System couplers") : group(made, "Junctions", "Junctions");
  made.dc.emplace().time_loop_control_only = true;
  made.eeprom.config_data = config_data({0x00, 0x01});
  return made;
}

struct Terminal {
  std::uint32_t product;
  std::string type, about, group, group_name;
  bool outputs;
  std::uint16_t start;
  std::uint8_t control;
  std::uint16_t bits;  // a channel
  std::string entry, data_type;
};

DeviceDescription terminal(const Terminal& what) {
  auto made = device(what.product, what.type, "2-channel " + what.about);
  made.physics = "KK";
  group(made, what.group, what.group_name);
  const bool digital = what.bits == 1;
  made.fmmus = {what.outputs ? FmmuUse::kOutputs : FmmuUse::kInputs};
  made.sync_managers = {manager(what.outputs ? SyncManagerType::kOutputs : SyncManagerType::kInputs, what.start,
                                what.control, digital ? 1 : 4)};
  auto& pdos = what.outputs ? made.rx_pdos : made.tx_pdos;
  for (std::uint16_t channel = 0; channel < 2; ++channel) {
    const auto object = static_cast<std::uint16_t>((what.outputs ? 0x7000 : 0x6000) + 0x10 * channel);
    pdos.push_back(pdo(static_cast<std::uint16_t>((what.outputs ? 0x1600 : 0x1A00) + channel),
                       "Channel " + std::to_string(channel + 1), 0,
                       {entry(object, 1, what.bits, what.entry, what.data_type)}));
    pdos.back().fixed = pdos.back().mandatory = true;
  }
  made.eeprom.config_data = digital ? config_data({0x04, 0x01}) : config_data({0x05});
  return made;
}

// ---- devices with a mailbox

DcOpMode mode(const std::string& name, const std::string& description, std::uint16_t assign_activate) {
  DcOpMode made;
  made.name = name;
  made.description = description;
  made.assign_activate = assign_activate;
  if (assign_activate != 0) made.cycle_time_sync0.factor = 1;
  return made;
}

/// SYNC0 and SYNC1.
DcOpMode mode_of_both(const std::string& description) {
  auto made = mode("DC Sync01", description, 0x0700);
  made.cycle_time_sync1.factor = 1;
  return made;
}

struct MailboxAreas {
  std::uint16_t out, in, outputs, inputs;  // where they begin
  std::uint16_t most;                      // bytes of outputs, of inputs
  std::uint16_t outputs_size, inputs_size;
};

void add_mailbox(DeviceDescription& device, const MailboxAreas& areas) {
  device.fmmus = {FmmuUse::kOutputs, FmmuUse::kInputs, FmmuUse::kMailboxState};
  device.sync_managers = {manager(SyncManagerType::kMailboxOut, areas.out, 0x26, 128),
                          manager(SyncManagerType::kMailboxIn, areas.in, 0x22, 128),
                          manager(SyncManagerType::kOutputs, areas.outputs, 0x64, areas.outputs_size),
                          manager(SyncManagerType::kInputs, areas.inputs, 0x20, areas.inputs_size)};
  for (std::size_t i = 0; i < device.sync_managers.size(); ++i) {
    device.sync_managers[i].min_size = i < 2 ? 64 : 0;
    device.sync_managers[i].max_size = i < 2 ? 256 : areas.most;
  }
  auto& mailbox = device.mailbox.emplace();
  mailbox.data_link_layer = true;
  auto& coe = mailbox.coe.emplace();
  coe.sdo_info = coe.pdo_assign = coe.segmented_sdo = true;
  device.reg_0420 = 1000;
  device.eeprom.byte_size = 4096;
  device.eeprom.config_data = config_data({0x05, 0x0C, 0x03, 0x88, 0xE8, 0x03});
}

StartupCommand at_start(std::uint16_t index, std::uint8_t sub_index, std::uint8_t value, std::string comment) {
  StartupCommand made;
  made.index = index;
  made.sub_index = sub_index;
  made.data = {value};
  made.comment = std::move(comment);
  return made;
}

/// What both drives have in common.
void make_drive(DeviceDescription& drive) {
  group(drive, "Drives", "Servo drives");
  drive.physics = "YY";
  drive.profiles = {{402, 0}};
  drive.mailbox->foe = true;
  drive.mailbox->coe->init_commands = {at_start(0x6060, 0, 8, "Cyclic synchronous position mode"),
                                       at_start(0x60C2, 1, 1, "Interpolation time period")};
}

const PdoEntry kControlword = entry(0x6040, 0, 16, "Controlword", "UINT");
const PdoEntry kTargetPosition = entry(0x607A, 0, 32, "Target position", "DINT");
const PdoEntry kTargetVelocity = entry(0x60FF, 0, 32, "Target velocity", "DINT");
const PdoEntry kTargetTorque = entry(0x6071, 0, 16, "Target torque", "INT");
const PdoEntry kMode = entry(0x6060, 0, 8, "Modes of operation", "SINT");
const PdoEntry kStatusword = entry(0x6041, 0, 16, "Statusword", "UINT");
const PdoEntry kPosition = entry(0x6064, 0, 32, "Position actual value", "DINT");
const PdoEntry kTorque = entry(0x6077, 0, 16, "Torque actual value", "INT");
const PdoEntry kFollowingError = entry(0x60F4, 0, 32, "Following error actual value", "DINT");

/// One of them at a time.
void exclude_each_other(std::vector<Pdo>& pdos) {
  for (auto& one : pdos) {
    for (const auto& other : pdos) {
      if (other.index != one.index) one.exclude.push_back(other.index);
    }
  }
}

DeviceDescription servo_y() {
  auto made = device(0x7001, "SL-SV7", "servo drive");
  add_mailbox(made, {0x1000, 0x1080, 0x1100, 0x1400, 200, 16, 20});
  make_drive(made);
  made.mailbox->coe->pdo_config = true;
  const std::string all = "Position, velocity, torque, probe", position = "Cyclic synchronous position",
                    velocity = "Cyclic synchronous velocity", torque = "Cyclic synchronous torque";
  made.rx_pdos = {pdo(0x1600, all, 2,
                      {kControlword, kTargetPosition, kTargetVelocity, kTargetTorque, kMode, kGap,
                       entry(0x60B8, 0, 16, "Touch probe function", "UINT")}),
                  pdo(0x1601, position, {}, {kControlword, kTargetPosition}),
                  pdo(0x1602, velocity, {}, {kControlword, kTargetVelocity}),
                  pdo(0x1603, torque, {}, {kControlword, kTargetTorque})};
  made.tx_pdos = {
      pdo(0x1A00, all, 3,
          {kStatusword, kPosition, kTorque, kFollowingError, entry(0x6061, 0, 8, "Modes of operation display", "SINT"),
           kGap, entry(0x60B9, 0, 16, "Touch probe status", "UINT"),
           entry(0x60BA, 0, 32, "Touch probe 1 positive edge", "DINT")}),
      pdo(0x1A01, position, {}, {kStatusword, kPosition}), pdo(0x1A02, velocity, {}, {kStatusword, kPosition}),
      pdo(0x1A03, torque, {}, {kStatusword, kPosition, kTorque})};
  exclude_each_other(made.rx_pdos);
  exclude_each_other(made.tx_pdos);
  made.dc.emplace().op_modes = {mode("DC", "DC-Synchronous", 0x0300), mode("Off", "SM-Synchronous or free run", 0)};
  made.eeprom.boot_strap = {0x00, 0x10, 0x80, 0x00, 0x80, 0x10, 0x80, 0x00};
  return made;
}

DeviceDescription drive_c() {
  auto made = device(0x7002, "SL-XE2", "servo drive");
  add_mailbox(made, {0x1800, 0x1900, 0x1100, 0x1200, 64, 8, 14});
  make_drive(made);
  made.rx_pdos = {pdo(0x1600, "Control and target position", 2, {kControlword, kTargetPosition}),
                  pdo(0x1601, "Mode of operation", 2, {kMode, kGap}),
                  pdo(0x1602, "Target velocity", {}, {kTargetVelocity}),
                  pdo(0x1603, "Target torque", {}, {kTargetTorque}),
                  pdo(0x1604, "Interpolation point", {}, {entry(0x60C1, 1, 32, "Interpolation position", "DINT")})};
  made.tx_pdos = {pdo(0x1A00, "Status and position", 3, {kStatusword, kPosition}),
                  pdo(0x1A01, "Velocity and following error", 3,
                      {entry(0x606C, 0, 32, "Velocity actual value", "DINT"), kFollowingError}),
                  pdo(0x1A02, "Torque and error code", {}, {kTorque, entry(0x603F, 0, 16, "Error code", "UINT")}),
                  pdo(0x1A03, "Digital inputs", {}, {entry(0x60FD, 0, 32, "Digital inputs", "UDINT")})};
  for (auto* pdos : {&made.rx_pdos, &made.tx_pdos}) {
    for (auto& one : *pdos) one.fixed = true;
  }
  auto& modes = made.dc.emplace().op_modes;
  modes = {mode("DC Sync", "DC-Synchronous with SYNC0", 0x0300), mode_of_both("DC-Synchronous with SYNC0 and SYNC1"),
           mode("Free Run", "Not synchronised", 0)};
  for (std::size_t i = 0; i < 2; ++i) modes[i].sync_managers = {{2, 2, {}}, {3, 2, {}}};
  made.eeprom.boot_strap = {0x00, 0x18, 0x80, 0x00, 0x00, 0x19, 0x80, 0x00};
  return made;
}

DeviceDescription can_gateway() {
  auto made = device(0x6751, "SL-6751", "CAN gateway");
  add_mailbox(made, {0x1800, 0x1900, 0x1100, 0x1200, 64, 4, 6});
  group(made, "FieldbusGateways", "Fieldbus gateways");
  made.physics = "KK";
  made.rx_pdos = {pdo(0x1600, "Node 1 outputs", 2, {entry(0x7000, 1, 32, "Node 1 output data", "UDINT")})};
  made.tx_pdos = {
      pdo(0x1A00, "Node 1 inputs", 3, {entry(0x6000, 1, 32, "Node 1 input data", "UDINT")}),
      pdo(0x1A80, "CAN diagnosis", 3,
          {entry(0xA000, 1, 8, "Node 1 state", "USINT"), entry(0xA000, 2, 8, "SYNC message counter", "USINT")})};
  for (auto* pdos : {&made.rx_pdos, &made.tx_pdos}) {
    for (auto& one : *pdos) one.fixed = true;
  }
  auto& modes = made.dc.emplace().op_modes;
  modes = {mode("DC Sync", "CAN cycle and SYNC message with SYNC0", 0x0300),
           mode_of_both("CAN cycle with SYNC0, SYNC message with SYNC1"),
           mode("SM Sync", "CAN cycle with the outputs", 0)};
  modes[1].shift_time_sync1.value_ns = 100'000;
  return made;
}

}  // namespace

std::vector<DeviceDescription> own_devices() {
  return {coupler(0x1100, "SL-1100", "coupler with branch"),
          coupler(0x1122, "SL-1122", "4-port junction"),
          terminal({0x1002, "SL-1002", "digital input", "DigitalIn", "Digital input terminals", false, 0x1000, 0x00, 1,
                    "Input", "BOOL"}),
          terminal({0x2002, "SL-2002", "digital output", "DigitalOut", "Digital output terminals", true, 0x0F00, 0x44,
                    1, "Output", "BOOL"}),
          terminal({0x3002, "SL-3002", "analogue input", "AnaIn", "Analogue input terminals", false, 0x1000, 0x20, 16,
                    "Value", "INT"}),
          terminal({0x4002, "SL-4002", "analogue output", "AnaOut", "Analogue output terminals", true, 0x1000, 0x64, 16,
                    "Value", "INT"}),
          servo_y(),
          drive_c(),
          can_gateway()};
}

DeviceDescription own(const std::string& type) {
  auto devices = own_devices();
  const auto found = std::ranges::find(devices, type, &DeviceDescription::type);
  return found == devices.end() ? DeviceDescription{} : std::move(*found);
}

}  // namespace syncline::sample
