// SPDX-License-Identifier: Apache-2.0
// The slaves of the report: what they are, and when their SYNC signals come.
#include <fmt/format.h>

#include "config/network_config.h"
#include "config/process_image.h"
#include "config/project.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"
#include "findings/finding.h"

namespace syncline::exports {
namespace {

/// "4", or "4 and 3 bits"
std::string bytes_of(const std::optional<ImageRange>& range) {
  const std::uint32_t bits = range ? range->bit_length : 0;
  if (bits % 8 == 0) return std::to_string(bits / 8);
  return bits < 8 ? fmt::format("{} bits", bits) : fmt::format("{} and {} bits", bits / 8, bits % 8);
}

std::string id_of(std::uint32_t number, const std::string& name) {
  return name.empty() ? fmt::format("0x{:08X}", number) : fmt::format("{} (0x{:08X})", name, number);
}

std::string mode_of(const SlaveConfig& slave, const SlaveSettings* settings) {
  if (!slave.dc) return "off";
  const auto activate = fmt::format("AssignActivate 0x{:04X}", slave.dc->assign_activate);
  const auto mode = settings != nullptr && !settings->dc.op_mode.empty()
                        ? fmt::format("{}, {}", settings->dc.op_mode, activate)
                        : activate;
  return slave.dc->reference_clock ? mode + ", reference clock" : mode;
}

std::string units_of(const SlaveSettings& settings) {
  const auto name = [](const std::string& unit) { return unit.empty() ? std::string("default") : unit; };
  if (settings.output_unit == settings.input_unit) return name(settings.output_unit);
  return fmt::format("outputs {}, inputs {}", name(settings.output_unit), name(settings.input_unit));
}

const SlaveSettings* settings_of(const Project* source, std::size_t position) {
  return source != nullptr && position < source->slaves.size() ? &source->slaves[position] : nullptr;
}

}  // namespace

std::string slaves_section(const NetworkConfig& config, const Project* source) {
  HtmlTable table({"Pos.", "Name", "Vendor", "Product", "Revision", "Address", "Alias", "Sync Unit", "Outputs, bytes",
                   "Inputs, bytes"});
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& slave = config.slaves[i];
    const auto* settings = settings_of(source, i);
    table.row({std::to_string(i), slave.name,
               id_of(slave.identity.vendor_id, settings != nullptr ? settings->device.vendor_name : std::string()),
               id_of(slave.identity.product_code, settings != nullptr ? settings->device.type : std::string()),
               fmt::format("0x{:08X}", slave.identity.revision_no), std::to_string(slave.station_address),
               slave.alias == 0 ? "none" : std::to_string(slave.alias),
               settings != nullptr ? units_of(*settings) : "not known", bytes_of(slave.send), bytes_of(slave.receive)});
  }
  return table.end();
}

std::string sync_section(const NetworkConfig& config, const Project* source) {
  HtmlTable table({"Pos.", "Name", "DC mode", "SYNC0 cycle", "SYNC0 to SYNC1 (0x09A4)", "SYNC0 shift"});
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& slave = config.slaves[i];
    std::vector<std::string> cells{std::to_string(i), slave.name, mode_of(slave, settings_of(source, i))};
    if (slave.dc && slave.dc->assign_activate != 0) {
      for (const auto time : {slave.dc->cycle_time0, slave.dc->cycle_time1, slave.dc->shift_time})
        cells.push_back(exact_time_text(time));
    } else {
      cells.insert(cells.end(), 3, "");
    }
    table.row(cells);
  }
  return table.end();
}

}  // namespace syncline::exports
