// SPDX-License-Identifier: Apache-2.0
#include "compare/compare_configs.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/difference_list.h"
#include "compare/slave_pairing.h"
#include "config/hot_connect.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "findings/finding.h"

namespace syncline {
namespace {

using comparison::DifferenceList;

std::vector<SlaveKey> keys(const NetworkConfig& config) {
  std::vector<SlaveKey> out;
  for (const auto& slave : config.slaves) out.push_back({slave.identity, slave.name});
  return out;
}

std::string previous_text(const std::vector<SlaveConfig>& slaves, const SlaveConfig& slave) {
  if (!slave.previous || slave.previous->position >= slaves.size()) return "not told";
  return fmt::format("port {} of slave {} ({})", static_cast<char>('A' + slave.previous->port),
                     slave.previous->position, slaves[slave.previous->position].name);
}

std::string group_text(const std::optional<HotConnectConfig>& group) {
  if (!group) return "none";
  const auto alias = group->alias();
  return fmt::format("\"{}\", {} members{}", group->group, group->member_count,
                     alias ? fmt::format(", alias {}", *alias) : "");
}

class Comparison {
 public:
  Comparison(const NetworkConfig& left, const NetworkConfig& right)
      : left_(left), right_(right), pairing_(pair_slaves(keys(left), keys(right))) {}

  std::vector<ConfigDifference> run() {
    DifferenceList network(out_);
    comparison::compare_master(left_, right_, network);
    comparison::compare_cyclic(left_, right_, pairing_, network);
    comparison::compare_image(left_, right_, pairing_, network);
    comparison::compare_places(left_, right_, pairing_, network);
    for (std::size_t l = 0, r = 0; l < left_.slaves.size() || r < right_.slaves.size();) {
      // Additions stand where they stand in the right configuration.
      if (r < right_.slaves.size() && !pairing_.left_of[r]) {
        DifferenceList(out_, std::nullopt, r, right_.slaves[r].name)
            .add(DifferenceGroup::kSlaves, "difference-added", "", to_string(right_.slaves[r].identity));
        ++r;
      } else if (l < left_.slaves.size()) {
        compare_left(l++);
        while (r < right_.slaves.size() && pairing_.left_of[r] && *pairing_.left_of[r] < l) ++r;
      } else {
        ++r;
      }
    }
    return std::move(out_);
  }

 private:
  void compare_left(std::size_t l) {
    const SlaveConfig& left = left_.slaves[l];
    if (!pairing_.right_of[l]) {
      DifferenceList(out_, l, std::nullopt, left.name)
          .add(DifferenceGroup::kSlaves, "difference-removed", to_string(left.identity), "");
      return;
    }
    const std::size_t r = *pairing_.right_of[l];
    const SlaveConfig& right = right_.slaves[r];
    DifferenceList out(out_, l, r, left.name);
    if (pairing_.moved[l]) {
      out.add(DifferenceGroup::kSlaves, "difference-place", fmt::format("{}", l), fmt::format("{}", r));
    }
    if (left == right && l == r && !wiring_differs(left, right)) return;
    compare_identity(left, right, l == r, out);
    compare_wiring(left, right, out);
    comparison::compare_process_data(left, right, out);
    comparison::compare_mailbox(left, right, out);
    comparison::compare_clocks(left, right, out);
    comparison::compare_commands(left, right, out);
  }

  static void compare_identity(const SlaveConfig& left, const SlaveConfig& right, bool same_place,
                               DifferenceList& out) {
    const auto product = [](const Identity& id) {
      return fmt::format("0x{:08x}:0x{:08x}", id.vendor_id, id.product_code);
    };
    out.field(DifferenceGroup::kSlaves, "difference-device", product(left.identity), product(right.identity));
    out.field(DifferenceGroup::kSlaves, "difference-revision", fmt::format("0x{:08x}", left.identity.revision_no),
              fmt::format("0x{:08x}", right.identity.revision_no));
    out.number(DifferenceGroup::kSlaves, "difference-serial-number", left.identity.serial_no, right.identity.serial_no);
    // With another place the address follows from it.
    if (!same_place) return;
    out.number(DifferenceGroup::kSlaves, "difference-station-address", left.station_address, right.station_address);
    out.number(DifferenceGroup::kSlaves, "difference-auto-increment-address", left.auto_increment_address,
               right.auto_increment_address);
  }

  /// The slave in front, by its counterpart: one more slave elsewhere changes no cable here.
  [[nodiscard]] bool wiring_differs(const SlaveConfig& left, const SlaveConfig& right) const {
    if (left.previous.has_value() != right.previous.has_value()) return true;
    if (!left.previous) return false;
    if (left.previous->port != right.previous->port) return true;
    const std::size_t position = left.previous->position;
    return position >= pairing_.right_of.size() ||
           pairing_.right_of[position] != std::optional<std::size_t>(right.previous->position);
  }

  void compare_wiring(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) const {
    if (wiring_differs(left, right)) {
      out.add(DifferenceGroup::kWiring, "difference-hangs-on", previous_text(left_.slaves, left),
              previous_text(right_.slaves, right));
    }
    out.number(DifferenceGroup::kWiring, "difference-alias", left.alias, right.alias);
    if (!(left.hot_connect == right.hot_connect)) {
      const std::string one = group_text(left.hot_connect);
      const std::string other = group_text(right.hot_connect);
      out.add(DifferenceGroup::kWiring,
              one == other ? comparison::what("difference-hot-connect-identification")
                           : comparison::what("difference-hot-connect-group"),
              one, other);
    }
    if (!(left.identification == right.identification)) {
      const auto words = [](const std::optional<Identification>& id) {
        return id ? fmt::format("{} in 0x{:04x}", id->value, id->ado) : std::string("none");
      };
      out.add(DifferenceGroup::kWiring, "difference-identification", words(left.identification),
              words(right.identification));
    }
  }

  const NetworkConfig& left_;
  const NetworkConfig& right_;
  SlavePairing pairing_;
  std::vector<ConfigDifference> out_;
};

}  // namespace

std::string_view group_name(DifferenceGroup group) {
  switch (group) {
    case DifferenceGroup::kSlaves:
      return "slaves";
    case DifferenceGroup::kWiring:
      return "wiring";
    case DifferenceGroup::kProcessData:
      return "process data";
    case DifferenceGroup::kMailbox:
      return "mailbox";
    case DifferenceGroup::kStartup:
      return "start-up";
    case DifferenceGroup::kClocks:
      return "clocks";
    case DifferenceGroup::kCommands:
      return "commands";
    case DifferenceGroup::kCyclic:
      return "cyclic";
    case DifferenceGroup::kImage:
      return "image";
    case DifferenceGroup::kMaster:
      return "master";
    case DifferenceGroup::kRunTime:
      return "run time";
  }
  return "master";
}

std::string place_text(const ConfigDifference& difference) {
  const auto& [left, right] = std::tie(difference.left_slave, difference.right_slave);
  if (!left && !right) return "network";
  const std::string position = !left                     ? fmt::format("{}", *right)
                               : !right || left == right ? fmt::format("{}", *left)
                                                         : fmt::format("{}, now {}", *left, *right);
  return difference.slave_name.empty() ? fmt::format("slave {}", position)
                                       : fmt::format("slave {} ({})", position, difference.slave_name);
}

std::string describe(const ConfigDifference& difference) {
  const std::string place = place_text(difference), what = facts_text(difference.what);
  if (difference.left.empty() && difference.right.empty()) return fmt::format("{}: {}", place, what);
  if (difference.left.empty()) return fmt::format("{}: {} only in the second: {}", place, what, difference.right);
  if (difference.right.empty()) return fmt::format("{}: {} only in the first: {}", place, what, difference.left);
  return fmt::format("{}: {} {} -> {}", place, what, difference.left, difference.right);
}

std::vector<ConfigDifference> compare_configs(const NetworkConfig& left, const NetworkConfig& right) {
  return Comparison(left, right).run();
}

}  // namespace syncline

namespace syncline::comparison {

void DifferenceList::add(DifferenceGroup group, Finding what, std::string left, std::string right) {
  if (const auto slave = left_ ? left_ : right_) what.place.slave = static_cast<int>(*slave);
  out_.push_back({group, left_, right_, name_, std::move(what), std::move(left), std::move(right)});
}

void DifferenceList::number(DifferenceGroup group, What what, std::int64_t left, std::int64_t right, const char* unit) {
  if (left != right) add(group, what, fmt::format("{}{}", left, unit), fmt::format("{}{}", right, unit));
}

void DifferenceList::time(DifferenceGroup group, What what, std::int64_t left_ns, std::int64_t right_ns) {
  if (left_ns != right_ns) add(group, what, exact_time_text(left_ns), exact_time_text(right_ns));
}

bool DifferenceList::has(DifferenceGroup group) const {
  return std::any_of(out_.begin() + static_cast<std::ptrdiff_t>(first_), out_.end(),
                     [&](const ConfigDifference& difference) { return difference.group == group; });
}

}  // namespace syncline::comparison
