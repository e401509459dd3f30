// SPDX-License-Identifier: Apache-2.0
#include "exports/formats.h"

#include <algorithm>
#include <array>

#include "config/network_config.h"
#include "exports/exports.h"

namespace syncline::exports {
namespace {

using Table = std::string (*)(const NetworkConfig&);

/// Those whose text does not depend on the name of the file.
template <Table kTable>
std::string text_of(const NetworkConfig& config, const std::string&) {
  return kTable(config);
}

constexpr std::array kFormats{
    Format{"c-header", ".h", "process image for C and C++", c_header},
    Format{"csv", ".csv", "process image", text_of<image_csv>},
    Format{"pdo-csv", ".pdo.csv", "PDOs and their entries", text_of<pdo_csv>},
    Format{"init-csv", ".init.csv", "init commands", text_of<init_commands_csv>},
    Format{"slaves-csv", ".slaves.csv", "slave list", text_of<slaves_csv>},
    Format{"svg", ".svg", "topology", text_of<topology_svg>},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* find_format(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &Format::name);
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace syncline::exports
