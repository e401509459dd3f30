// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <string>

#include "config/module_slots.h"
#include "config/project.h"
#include "config/startup_messages.h"

namespace syncline::test {

/// Projects that a user could have made, from a seed: every field leaves its default now and then.
class RandomProject {
 public:
  explicit RandomProject(std::uint32_t seed) : random_(seed) {}

  Project project() {
    Project p;
    p.master = master();
    const int slaves = number(0, 4);
    for (int i = 0; i < slaves; ++i) p.slaves.push_back(slave(static_cast<std::uint16_t>(i)));
    if (slaves > 0 && chance(2)) p.master.dc.reference_clock = number<std::uint16_t>(0, slaves - 1);
    if (chance(2)) p.name = name();
    for (int i = chance(2) ? number(1, 3) : 0; i > 0; --i) p.views.push_back(view());
    arrange_tasks(p);
    return p;
  }

  DeviceDescription device() {
    DeviceDescription d;
    d.identity = {number<std::uint32_t>(1, 0x7FFF'FFFF), number<std::uint32_t>(1, 0x7FFF'FFFF),
                  number<std::uint32_t>(0, 0x7FFF'FFFF), chance(4) ? number<std::uint32_t>(1, 999) : 0};
    d.vendor_name = text();
    d.group_type = trimmed_text();
    d.type = text();
    d.name = trimmed_text();
    d.physics = pick({"YY", "KK", "YKY", "KK Y", ""});
    if (chance(2)) d.check_revision = static_cast<RevisionCheck>(number(0, 4));
    d.use_lrd_lwr = chance(3);
    for (int i = number(0, 4); i > 0; --i) d.fmmus.push_back(static_cast<FmmuUse>(number(0, 3)));
    for (int i = 0; i < 4; ++i) d.sync_managers.push_back(sync_manager(static_cast<SyncManagerType>(i + 1)));
    d.rx_pdos = pdos(0x1600, 0x7000, 2);
    d.tx_pdos = pdos(0x1A00, 0x6000, 3);
    if (chance(2)) d.mailbox = mailbox();
    if (chance(2)) d.dc = dc();
    d.timeouts = {number<std::uint32_t>(1, 99999), number<std::uint32_t>(1, 99999), number<std::uint32_t>(1, 99999),
                  number<std::uint32_t>(1, 99999)};
    d.eeprom = {number<std::uint32_t>(0, 8192), bytes(14), chance(2) ? bytes(8) : std::vector<std::uint8_t>{}};
    if (chance(2)) d.reg_0400 = number<std::uint16_t>(0, 0xFFFF);
    if (chance(2)) d.reg_0420 = number<std::uint16_t>(0, 0xFFFF);
    for (int i = number(0, 2); i > 0; --i) {
      d.profiles.push_back({number<std::uint32_t>(1, 5001), number<std::uint32_t>(0, 9)});
    }
    for (int i = number(0, 3); i > 0; --i) d.dictionary.push_back(object(static_cast<std::uint16_t>(0x8000 + i)));
    d.source = text();
    return d;
  }

  /// Text that a careless writer or reader would spoil.
  std::string text() {
    return pick({"Drive", "Elmo Drive ", " spaces around ", "a < b & c > \"d\" 'e'", "Größe µs 速度", "]]>", "", " "});
  }

 private:
  template <class T = int>
  T number(std::int64_t from, std::int64_t to) {
    return static_cast<T>(std::uniform_int_distribution<std::int64_t>(from, to)(random_));
  }
  MonitorView view() {
    MonitorView v{text(), {}};
    for (int i = number(0, 3); i > 0; --i) {
      ViewPlot plot{text(), {},        static_cast<ValueScale>(number(0, 2)), {},
                    {},     chance(2), number<std::uint16_t>(1, 999)};
      if (chance(2)) plot.left = AxisLimits{number(-900, 0) / 7.0, number(1, 900) / 3.0};
      if (chance(2)) plot.right = AxisLimits{-1e-9, 1e12};
      for (int k = number(0, 3); k > 0; --k) {
        ViewSignal signal{static_cast<ViewSignal::Of>(number(0, 2)), text(), 0, chance(2), chance(2), chance(2)};
        if (signal.of == ViewSignal::Of::kSlave) signal.station_address = number<std::uint16_t>(0, 0xFFFF);
        plot.signals.push_back(std::move(signal));
      }
      v.plots.push_back(std::move(plot));
    }
    return v;
  }
  bool chance(int one_in) { return number(1, one_in) == 1; }
  std::string pick(std::initializer_list<const char*> words) {
    return *(words.begin() + number(0, static_cast<std::int64_t>(words.size()) - 1));
  }
  std::string trimmed_text() { return pick({"Drive", "two words", "a < b & c > \"d\"", "Größe µs", "]]>", ""}); }
  std::string name() { return pick({"Axis 1", "Slave_1001 [Elmo Drive ]", "<&>\"'", "Größe", " lead"}); }
  std::vector<std::uint8_t> bytes(int count) {
    std::vector<std::uint8_t> out;
    for (int i = 0; i < count; ++i) out.push_back(number<std::uint8_t>(0, 255));
    return out;
  }

  MasterSettings master() {
    MasterSettings m;
    m.name = name();
    m.cycle_time = number<Nanoseconds>(31'250, 100 * kMillisecond);
    for (auto& byte : m.destination_mac) byte = number<std::uint8_t>(0, 255);
    for (auto& byte : m.source_mac) byte = number<std::uint8_t>(0, 255);
    m.overlap_process_data = chance(2);
    m.recovery = {chance(2), number<std::uint32_t>(0, 1000), chance(2)};
    m.real_time.spin = number<Nanoseconds>(0, kMillisecond);
    if (chance(2)) m.real_time.cpu = number<std::uint16_t>(0, 1023);
    auto& dc = m.dc;
    dc.enabled = chance(2);
    dc.continuous_propagation_compensation = chance(2);
    dc.show_64bit_system_time = chance(2);
    dc.sync_window = {chance(2), number<std::uint8_t>(1, 30), number<std::uint32_t>(0, 60'000)};
    dc.dcm.mode = static_cast<DcmMode>(number(0, 6));
    dc.dcm.gain_ppt = number<std::uint32_t>(0, DcmSettings::kMaxGain);
    dc.dcm.drift_error_gain = number<std::uint32_t>(0, DcmSettings::kMaxDriftErrorGain);
    dc.dcm.max_valid_value = number<Nanoseconds>(0, 100'000);
    dc.dcm.control_off = chance(2);
    dc.dcm.standard_loop_values = chance(2);
    dc.dcm.log = chance(2);
    if (chance(2)) dc.dcm.set_value = number<Nanoseconds>(0, kMillisecond);
    dc.dcm.in_sync_limit = number<Nanoseconds>(1, 100'000);
    dc.dcm.in_sync_settle_time_ms = number<std::uint32_t>(0, 60'000);
    dc.dcm.start_delay_ms = number<std::uint32_t>(0, 60'000);
    dc.burst_total = number<std::uint32_t>(0, 20'000);
    dc.burst_bulk = number<std::uint32_t>(1, 100);
    dc.burst_ends_early = chance(2);
    dc.first_slave_is_reference_clock = chance(2);
    dc.all_slaves = chance(2);
    dc.delay_rounds = number<std::uint8_t>(1, 100);
    if (chance(2)) dc.delay_difference = number<std::uint32_t>(0, 1000);
    if (chance(2)) dc.loop.speed_counter_start = number<std::uint16_t>(0x80, 0x3FFF);
    if (chance(2)) dc.loop.filter_depth_difference = number<std::uint8_t>(0, 15);
    if (chance(2)) dc.loop.filter_depth_speed_counter = number<std::uint8_t>(0, 15);
    dc.notifications = {chance(2), chance(2), chance(2), chance(2)};
    dc.start_time_safety = number<Nanoseconds>(0, kSecond);
    dc.start_time_grid = number<Nanoseconds>(0, kMillisecond);
    return m;
  }

  SyncManagerDescription sync_manager(SyncManagerType type) {
    SyncManagerDescription m;
    m.type = type;
    m.start_address = number<std::uint16_t>(0, 0xFFFF);
    m.control_byte = number<std::uint8_t>(0, 255);
    if (chance(2)) m.min_size = number<std::uint16_t>(0, 2048);
    if (chance(2)) m.max_size = number<std::uint16_t>(0, 2048);
    if (chance(2)) m.default_size = number<std::uint16_t>(0, 2048);
    m.enable = chance(2);
    m.is_virtual = chance(5);
    m.op_only = chance(3);
    return m;
  }

  std::vector<Pdo> pdos(std::uint16_t first, std::uint16_t first_object, std::uint8_t manager) {
    std::vector<Pdo> out;
    const int count = number(0, 4);
    for (int i = 0; i < count; ++i) {
      Pdo pdo;
      pdo.index = static_cast<std::uint16_t>(first + i);
      pdo.name = trimmed_text();
      if (chance(2)) pdo.sync_manager = manager;
      pdo.fixed = chance(2);
      pdo.mandatory = chance(4);
      if (i > 0 && chance(3)) pdo.exclude.push_back(first);
      for (int k = number(0, 3); k > 0; --k) {
        pdo.entries.push_back({static_cast<std::uint16_t>(first_object + 16 * i), static_cast<std::uint8_t>(k),
                               number<std::uint16_t>(1, 64), trimmed_text(), pick({"UINT", "DINT", "BOOL", ""})});
      }
      if (chance(3)) pdo.entries.push_back({0, 0, number<std::uint16_t>(1, 8), "", ""});
      out.push_back(std::move(pdo));
    }
    return out;
  }

  StartupCommand startup() {
    StartupCommand c;
    if (chance(3)) c.transitions = {Transition::kSO, Transition::kIP};
    c.index = number<std::uint16_t>(1, 0xFFFF);
    c.sub_index = number<std::uint8_t>(0, 255);
    c.data = bytes(number(0, 6));
    c.complete_access = chance(4);
    c.fixed = chance(3);
    c.comment = pick({"", "mode of operation", "a # b", "<&>\"", "two\nlines"});
    return c;
  }

  MailboxDescription mailbox() {
    MailboxDescription m;
    m.data_link_layer = chance(2);
    m.aoe = chance(2), m.eoe = chance(2), m.foe = chance(2), m.soe = chance(2), m.voe = chance(2);
    m.request_timeout_ms = number<std::uint32_t>(1, 9999);
    m.response_timeout_ms = number<std::uint32_t>(1, 9999);
    if (!chance(3)) {
      m.coe.emplace();
      m.coe->sdo_info = chance(2), m.coe->pdo_assign = chance(2), m.coe->pdo_config = !chance(3);
      m.coe->pdo_upload = chance(2), m.coe->complete_access = chance(2), m.coe->segmented_sdo = chance(2);
      for (int i = number(0, 3); i > 0; --i) m.coe->init_commands.push_back(startup());
    }
    for (auto* commands : {&m.aoe_options.init_commands, &m.eoe_options.init_commands}) {
      const bool eoe = commands == &m.eoe_options.init_commands;
      if (!(eoe ? m.eoe : m.aoe) || chance(2)) continue;
      commands->push_back({{Transition::kIP}, eoe ? number(0, 9) : 0, bytes(number(1, 6)), pick({"", "from the ESI"})});
    }
    return m;
  }

  DcTime time() {
    DcTime t;
    if (chance(2)) t.value_ns = number<std::int64_t>(-1'000'000, 1'000'000);
    if (chance(2)) t.factor = number(-8, 8);
    t.input = chance(4);
    return t;
  }

  DcDescription dc() {
    DcDescription d;
    d.time_loop_control_only = chance(3), d.unknown_frmw = chance(3), d.unknown_64bit = chance(3);
    d.potential_reference_clock = chance(3);
    const int modes = number(0, 3);
    for (int i = 0; i < modes; ++i) {
      DcOpMode mode{"Mode " + std::to_string(i),
                    trimmed_text(),
                    number<std::uint16_t>(0, 0xFFFF),
                    time(),
                    time(),
                    time(),
                    time(),
                    {}};
      if (chance(2))
        mode.sync_managers.push_back(
            {2, std::nullopt, chance(2) ? std::vector<std::uint16_t>{0x1600} : std::vector<std::uint16_t>{}});
      if (chance(2)) mode.sync_managers.push_back({3, number<std::uint16_t>(0, 34), {}});
      d.op_modes.push_back(std::move(mode));
    }
    return d;
  }

  ObjectDescription object(std::uint16_t index) {
    ObjectDescription o{index, trimmed_text(), {}};
    const int entries = chance(3) ? 1 : number(1, 4);
    for (int i = 0; i < entries; ++i) {
      const bool writable = chance(2);
      if (entries > 1) o.code = ObjectCode::kRecord;
      o.entries.push_back({static_cast<std::uint8_t>(i), entries == 1 ? o.name : trimmed_text(),
                           pick({"UINT", "STRING(4)", ""}), number<std::uint16_t>(0, 64), !writable || chance(2),
                           writable, chance(2) ? bytes(number(1, 4)) : std::vector<std::uint8_t>{}});
    }
    return o;
  }

  std::vector<std::uint16_t> assignment(const std::vector<Pdo>& pdos) {
    std::vector<std::uint16_t> chosen;
    for (const Pdo& pdo : pdos) {
      const bool excluded = std::ranges::any_of(
          pdo.exclude, [&](auto other) { return std::ranges::find(chosen, other) != chosen.end(); });
      if (!excluded && chance(2)) chosen.push_back(pdo.index);
    }
    if (chance(2)) std::ranges::reverse(chosen);
    return chosen;
  }

  void change_mappings(SlaveSettings& s) {
    if (!s.device.mailbox || !s.device.mailbox->coe || !s.device.mailbox->coe->pdo_config) return;
    for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
      for (const Pdo& pdo : s.device.pdos(direction)) {
        if (pdo.fixed || pdo.entries.size() < 2 || chance(2)) continue;
        Pdo changed = pdo;
        changed.entries.erase(changed.entries.begin());
        std::ranges::reverse(changed.entries);
        if (changed.entries != pdo.entries) s.changed_pdos.push_back(std::move(changed));
      }
    }
  }

  void arrange_tasks(Project& p) {
    if (chance(2)) p.master.dc.input_shift = number<Nanoseconds>(-kMillisecond, kMillisecond);
    for (int i = number(0, 2); i > 0; --i) {
      p.master.register_commands.push_back(register_command());
      p.master.register_commands.back().after_slaves = chance(2);
    }
    auto& image = p.master.image;
    if (chance(3)) image.logical_start = number<std::uint32_t>(0, 0x7FFF'0000);
    image.alignment = static_cast<std::uint8_t>(1 << number(0, 3));
    image.bit_packing = chance(2);
    for (int i = number(0, 3); i > 0; --i) {
      p.master.tasks.push_back({"Task " + std::to_string(i), number<std::uint32_t>(1, 1000)});
    }
    for (int i = number(0, 3); i > 0; --i) {
      auto& unit = p.master.sync_units.emplace_back(SyncUnit{"Unit " + std::to_string(i), ""});
      if (!p.master.tasks.empty() && chance(2)) unit.task = p.master.tasks.front().name;
    }
    if (p.master.sync_units.empty()) return;
    for (auto& slave : p.slaves) {
      if (chance(2)) slave.output_unit = p.master.sync_units.front().name;
      if (chance(2)) slave.input_unit = p.master.sync_units.back().name;
    }
  }

  void set_options(SlaveSettings& s) {
    s.optional = chance(4);
    if (chance(2)) s.check.revision_rule = static_cast<RevisionCheck>(number(0, 4));
    s.check.alias = chance(3);
    if (chance(3)) s.check.device_id = number<std::uint16_t>(0, 0xFFFF);
    for (auto* value : {&s.watchdog.divider, &s.watchdog.pdi, &s.watchdog.process_data}) {
      if (chance(3)) *value = number<std::uint16_t>(0, 0xFFFF);
    }
    if (chance(3)) s.watchdog.outputs = chance(2);
    auto& t = s.timeouts;
    for (auto* value :
         {&t.preop, &t.safeop_op, &t.back_to_init, &t.back_to_safeop, &t.mailbox_request, &t.mailbox_response}) {
      if (chance(3)) *value = number<std::uint32_t>(1, 600'000);
    }
    if (chance(3)) s.mailbox.out_size = number<std::uint16_t>(24, 1486);
    if (chance(3)) s.mailbox.in_size = number<std::uint16_t>(24, 1486);
    s.mailbox.state_bit = !chance(3);
    if (chance(3)) s.mailbox.poll_time_ms = number<std::uint32_t>(1, 60'000);
    set_mailbox_protocols(s);
    for (const auto* pdos : {&s.device.rx_pdos, &s.device.tx_pdos}) {
      for (const Pdo& pdo : *pdos) {
        const auto changed = std::ranges::find(s.changed_pdos, pdo.index, &Pdo::index);
        const auto& entries = changed == s.changed_pdos.end() ? pdo.entries : changed->entries;
        if (!entries.empty() && entries.front().index != 0 && chance(4))
          s.variable_names.push_back({pdo.index, 0, name()});
      }
    }
    std::ranges::sort(s.variable_names, {}, &VariableName::pdo);
    // Not std::ranges::unique: clang 14 cannot compile what libstdc++ 12 makes of it.
    const auto same_pdo = [](const VariableName& a, const VariableName& b) { return a.pdo == b.pdo; };
    s.variable_names.erase(std::unique(s.variable_names.begin(), s.variable_names.end(), same_pdo),
                           s.variable_names.end());
  }

  void choose_samples(SlaveSettings& s) {
    for (auto* pdos : {&s.device.rx_pdos, &s.device.tx_pdos}) {
      for (Pdo& pdo : *pdos) {
        if (!chance(5) || pdo.os_max || std::ranges::count(s.oversampling, pdo.index, &PdoOversampling::pdo) > 0)
          continue;
        pdo.os_max = number<std::uint16_t>(2, 8);
        s.oversampling.push_back({pdo.index, number<std::uint16_t>(1, *pdo.os_max)});
      }
    }
    std::ranges::sort(s.oversampling, {}, &PdoOversampling::pdo);
  }

  MailboxInitCmd message() {
    MailboxInitCmd m;
    m.transitions = chance(2) ? std::vector{Transition::kIP, Transition::kSP} : std::vector{Transition::kPS};
    m.data = bytes(number(1, 12));
    m.fixed = chance(3);
    m.enabled = !chance(3);
    m.timeout_ms = chance(2) ? number<std::uint32_t>(1, 99999) : 0;
    m.comment = pick({"", "own", "a # b"});
    return m;
  }

  RegisterCommand register_command() {
    RegisterCommand c;
    if (chance(2)) c.transitions = {Transition::kIP, Transition::kOS};
    c.read = chance(2);
    c.address = number<std::uint16_t>(0, 0xFF00);
    c.data = bytes(number(1, 8));
    if (c.read) {
      if (chance(2)) c.expected = bytes(static_cast<int>(c.data.size()));
      if (!c.expected.empty() && chance(2)) c.mask = bytes(static_cast<int>(c.data.size()));
      std::ranges::fill(c.data, std::uint8_t{0});
    }
    if (chance(2)) c.timeout_ms = number<std::uint32_t>(0, 9999);
    c.enabled = !chance(3);
    c.comment = pick({"", "latch", "a # b"});
    return c;
  }

  void set_mailbox_protocols(SlaveSettings& s) {
    s.eoe.enabled = !chance(4);
    if (chance(3)) s.eoe.mac = std::array<std::uint8_t, 6>{2, 0, 0, number<std::uint8_t>(0, 255), 0, 1};
    if (chance(3)) s.eoe.ip = "192.168.1." + std::to_string(number(1, 254));
    if (chance(3)) s.eoe.subnet = "255.255.255.0";
    if (chance(3)) s.eoe.gateway = "192.168.1.1";
    if (chance(3)) s.eoe.dns = "8.8.4.4";
    if (chance(3)) s.eoe.host_name = "drive-" + std::to_string(number(1, 99));
    if (chance(3)) s.ams_net_id = "5.1.2.3.4." + std::to_string(number(0, 255));
    for (int i = number(0, 3); i > 0; --i) s.register_commands.push_back(register_command());
    if (!s.device.mailbox) return;
    for (const auto& protocol : kMessageProtocols) {
      auto& messages = s.*protocol.startup;
      messages = esi_messages(s.device, protocol.type);
      if (!speaks(s.device, protocol)) continue;
      if (!messages.empty() && chance(4)) messages.pop_back();
      for (int i = number(0, 2); i > 0; --i) messages.push_back(message());
    }
    if (!s.device.mailbox->soe) return;
    for (int i = number(0, 3); i > 0; --i) {
      SoeCommand command;
      command.transitions = {Transition::kPS, Transition::kSO};
      command.drive = number<std::uint8_t>(0, 7);
      command.idn = number<std::uint16_t>(0, 0xFFFF);
      command.data = bytes(number(1, 4));
      command.comment = chance(2) ? "limit" : "";
      command.fixed = chance(2);
      command.enabled = chance(2);
      command.timeout_ms = chance(2) ? number<std::uint32_t>(1, 99999) : 0;
      s.soe_startup.push_back(std::move(command));
    }
  }

  SyncUnitSettings sync_unit() {
    SyncUnitSettings u;
    if (chance(2)) u.cycle_factor = chance(2) ? number(1, 100) : number(-100, -1);
    if (chance(2)) u.user_cycle = number<Nanoseconds>(1, 100 * kMillisecond);
    if (chance(2)) u.shift = number<Nanoseconds>(-kMillisecond, kMillisecond);
    return u;
  }

  ModuleDescription module(std::uint32_t ident) {
    ModuleDescription m;
    m.ident = ident;
    m.type = "Module " + std::to_string(ident);
    m.name = m.type;
    Pdo pdo;
    pdo.index = static_cast<std::uint16_t>(0x1610 + ident);
    pdo.name = "Outputs";
    pdo.sync_manager = 2;
    pdo.depend_on_slot = true;
    pdo.entries = {
        {static_cast<std::uint16_t>(0x7100 + ident), 1, number<std::uint16_t>(1, 32), "Value", "UDINT", false, true}};
    m.rx_pdos = {pdo};
    return m;
  }

  void add_slots(DeviceDescription& d) {
    d.modules = {module(1), module(2)};
    SlotDescription slot;
    slot.name = "Terminals";
    slot.max_instances = number<std::uint16_t>(1, 3);
    slot.modules = {{1, false}, {2, chance(2)}};
    d.slots.emplace().slots = {slot};
    d.slots->increments.slot_pdo = 4;
    d.slots->increments.slot_index = 0x10;
  }

  void plug_modules(SlaveSettings& s) {
    for (const auto& place : slot_places(s.device)) {
      if (!chance(3)) static_cast<void>(plug_module(s, place.number, number<std::uint32_t>(1, 2)));
    }
  }

  SlaveSettings slave(std::uint16_t position) {
    SlaveSettings s;
    s.device = device();
    if (chance(4)) add_slots(s.device);
    s.name = name();
    s.station_address = number<std::uint16_t>(1, 0xFFFF);
    s.alias = number<std::uint16_t>(0, 0xFFFF);
    if (s.alias % 4 == 1) s.hot_connect = name();
    if (position > 0 && !chance(4))
      s.previous = PreviousPort{number<std::uint16_t>(0, position - 1), number<std::uint8_t>(0, 3)};
    s.check = {.vendor = chance(2), .product = chance(2), .revision = chance(2), .serial = chance(2)};
    s.assigned_rx_pdos = assignment(s.device.rx_pdos);
    s.assigned_tx_pdos = assignment(s.device.tx_pdos);
    plug_modules(s);
    choose_samples(s);
    change_mappings(s);
    set_options(s);
    if (s.device.dc && !s.device.dc->op_modes.empty() && !chance(3)) {
      s.dc.op_mode =
          s.device.dc->op_modes[number<std::size_t>(0, static_cast<std::int64_t>(s.device.dc->op_modes.size()) - 1)]
              .name;
    }
    s.dc.sync0 = sync_unit();
    s.dc.sync1 = sync_unit();
    if (s.device.dc && chance(2)) s.dc.input_reference = chance(2);
    s.dc.potential_reference_clock = chance(2);
    if (s.device.mailbox && s.device.mailbox->coe) {
      for (int i = number(0, 4); i > 0; --i) {
        auto command = startup();
        command.enabled = !chance(3);
        command.timeout_ms = chance(2) ? number<std::uint32_t>(1, 99999) : 0;
        s.startup.push_back(std::move(command));
      }
      if (chance(4)) s.sync.error_limit = number<std::uint16_t>(0, 15);
      if (chance(4)) s.sync.type = static_cast<SyncTypeChoice>(number(0, 3));
      if (chance(4)) s.sync.input_shift = number(0, 1'000'000);
    }
    return s;
  }

  std::mt19937 random_;
};

}  // namespace syncline::test
