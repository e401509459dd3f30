// SPDX-License-Identifier: Apache-2.0
#include "compare/network_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "compare/slave_pairing.h"
#include "config/command_text.h"
#include "config/cyclic_frame.h"
#include "config/init_cmd.h"
#include "config/mailbox_config.h"
#include "config/network_config.h"

namespace syncline {
namespace {

using Differences = std::vector<NetworkDifference>;

template <class T>
std::string optional_text(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "none";
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Longest common subsequence of what lies between equal beginnings and ends.
void align_middle(Pairs& pairs, const std::vector<std::string>& left, const std::vector<std::string>& right,
                  std::size_t begin, std::size_t left_end, std::size_t right_end) {
  const std::size_t rows = left_end - begin + 1;
  const std::size_t columns = right_end - begin + 1;
  if (rows > kMostCells / columns) {
    for (std::size_t i = begin; i < std::min(left_end, right_end); ++i) {
      if (left[i] == right[i]) pairs.emplace_back(i, i);
    }
    return;
  }
  std::vector<std::uint32_t> longest(rows * columns, 0);
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& {
    return longest[(i - begin) * columns + j - begin];
  };
  for (std::size_t i = left_end; i-- > begin;) {
    for (std::size_t j = right_end; j-- > begin;) {
      at(i, j) = left[i] == right[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
  }
  for (std::size_t i = begin, j = begin; i < left_end && j < right_end;) {
    if (left[i] == right[j]) {
      pairs.emplace_back(i++, j++);
    } else if (at(i + 1, j) >= at(i, j + 1)) {
      ++i;
    } else {
      ++j;
    }
  }
}

/// Pairs of equal keys in both lists, as many as possible in order.
Pairs align(const std::vector<std::string>& left, const std::vector<std::string>& right) {
  std::size_t begin = 0;
  std::size_t left_end = left.size();
  std::size_t right_end = right.size();
  Pairs pairs;
  for (; begin < left_end && begin < right_end && left[begin] == right[begin]; ++begin)
    pairs.emplace_back(begin, begin);
  while (left_end > begin && right_end > begin && left[left_end - 1] == right[right_end - 1]) {
    --left_end;
    --right_end;
  }
  align_middle(pairs, left, right, begin, left_end, right_end);
  for (; left_end < left.size(); ++left_end, ++right_end) pairs.emplace_back(left_end, right_end);
  return pairs;
}

/// Compares two lists: aligned by `key`, pairs by `compare`, the rest reported as missing or additional.
template <class Item>
void compare_lists(Differences& out, const std::string& where, const std::vector<Item>& left,
                   const std::vector<Item>& right, const std::function<std::string(const Item&)>& key,
                   const std::function<void(const std::string&, const Item&, const Item&)>& compare) {
  if (left == right) return;
  std::vector<std::string> left_keys, right_keys;
  std::ranges::transform(left, std::back_inserter(left_keys), key);
  std::ranges::transform(right, std::back_inserter(right_keys), key);
  std::size_t i = 0;
  std::size_t j = 0;
  const auto report_until = [&](std::size_t left_end, std::size_t right_end) {
    for (; i < left_end; ++i) {
      out.push_back({fmt::format("{} {}", where, i + 1), "missing", left_keys[i], ""});
    }
    for (; j < right_end; ++j) {
      out.push_back({fmt::format("{} {}", where, j + 1), "additional", "", right_keys[j]});
    }
  };
  for (const auto& [l, r] : align(left_keys, right_keys)) {
    report_until(l, r);
    compare(fmt::format("{} {} ({})", where, l + 1, left_keys[l]), left[l], right[r]);
    i = l + 1;
    j = r + 1;
  }
  report_until(left.size(), right.size());
}

class FieldComparison {
 public:
  FieldComparison(Differences& out, std::string where) : out_(out), where_(std::move(where)) {}
  void field(const char* name, const std::string& left, const std::string& right) {
    if (left != right) {
      out_.push_back({where_, name, left, right});
    }
  }

 private:
  Differences& out_;
  std::string where_;
};

std::string comparison_text(const InitCmdValidate& validate) {
  constexpr const char* kNames[] = {"equal", "not equal", "greater or equal", "less or equal", "greater",
                                    "less",  "any"};
  return fmt::format("{}{}", kNames[static_cast<std::size_t>(validate.type)], validate.is_signed ? ", signed" : "");
}

void compare_init_cmds(Differences& out, const std::string& where, const std::vector<InitCmd>& left,
                       const std::vector<InitCmd>& right) {
  compare_lists<InitCmd>(
      out, where, left, right,
      [](const InitCmd& cmd) { return fmt::format("{}, {}", address_text(cmd), transitions_text(cmd.transitions)); },
      [&](const std::string& place, const InitCmd& l, const InitCmd& r) {
        FieldComparison compare(out, place);
        compare.field("data", hex_text(payload(l)), hex_text(payload(r)));
        compare.field("before slave", l.before_slave ? "yes" : "no", r.before_slave ? "yes" : "no");
        compare.field("own cycle", l.requires_cycle ? "yes" : "no", r.requires_cycle ? "yes" : "no");
        compare.field("own frame", l.requires_frame ? "yes" : "no", r.requires_frame ? "yes" : "no");
        compare.field("working counter", optional_text(l.expected_wkc), optional_text(r.expected_wkc));
        compare.field("retries", std::to_string(l.retries), std::to_string(r.retries));
        compare.field("time-out", optional_text(l.timeout_ms), optional_text(r.timeout_ms));
        const InitCmdValidate none;
        const InitCmdValidate& lv = l.validate ? *l.validate : none;
        const InitCmdValidate& rv = r.validate ? *r.validate : none;
        compare.field("expected bytes", hex_text(lv.data), hex_text(rv.data));
        compare.field("expected mask", hex_text(lv.mask), hex_text(rv.mask));
        compare.field("comparison", comparison_text(lv), comparison_text(rv));
        compare.field("check time-out", std::to_string(lv.timeout_ms), std::to_string(rv.timeout_ms));
      });
}

void compare_coe(Differences& out, const std::string& where, const std::vector<CoeInitCmd>& left,
                 const std::vector<CoeInitCmd>& right) {
  compare_lists<CoeInitCmd>(
      out, where, left, right,
      [](const CoeInitCmd& cmd) {
        return fmt::format("0x{:04x}:{}{}, {}", cmd.command.index, cmd.command.sub_index,
                           cmd.command.complete_access ? " complete" : "", transitions_text(cmd.command.transitions));
      },
      [&](const std::string& place, const CoeInitCmd& l, const CoeInitCmd& r) {
        FieldComparison compare(out, place);
        compare.field("data", hex_text(l.command.data), hex_text(r.command.data));
        compare.field("command specifier", std::to_string(l.ccs), std::to_string(r.ccs));
        compare.field("time-out", std::to_string(l.command.timeout_ms), std::to_string(r.command.timeout_ms));
        compare.field("enabled", l.command.enabled ? "yes" : "no", r.command.enabled ? "yes" : "no");
        compare.field("fixed", l.command.fixed ? "yes" : "no", r.command.fixed ? "yes" : "no");
      });
}

void compare_frames(Differences& out, const std::string& where, const CyclicFrame& left, const CyclicFrame& right,
                    const CompareOptions& options) {
  compare_lists<CyclicCmd>(
      out, where + ", command", left.commands, right.commands,
      [](const CyclicCmd& cmd) { return fmt::format("{}, {}", address_text(cmd), states_text(cmd.states)); },
      [&](const std::string& place, const CyclicCmd& l, const CyclicCmd& r) {
        FieldComparison compare(out, place);
        compare.field("length", std::to_string(l.length()), std::to_string(r.length()));
        compare.field("data", hex_text(payload(l)), hex_text(payload(r)));
        compare.field("working counter", optional_text(l.expected_wkc), optional_text(r.expected_wkc));
        if (options.image_offsets) {
          compare.field("input offset", std::to_string(l.input_offset), std::to_string(r.input_offset));
          compare.field("output offset", std::to_string(l.output_offset), std::to_string(r.output_offset));
        }
      });
}

void compare_tasks(Differences& out, const NetworkConfig& left, const NetworkConfig& right,
                   const CompareOptions& options) {
  const std::size_t tasks = std::max(left.cyclic.size(), right.cyclic.size());
  for (std::size_t t = 0; t < tasks; ++t) {
    const CyclicTask none;
    const CyclicTask& l = t < left.cyclic.size() ? left.cyclic[t] : none;
    const CyclicTask& r = t < right.cyclic.size() ? right.cyclic[t] : none;
    const std::string where = fmt::format("cyclic task {}", t + 1);
    FieldComparison(out, where)
        .field("cycle time", fmt::format("{} ns", l.cycle_time), fmt::format("{} ns", r.cycle_time));
    for (std::size_t f = 0; f < std::max(l.frames.size(), r.frames.size()); ++f) {
      const CyclicFrame empty;
      compare_frames(out, fmt::format("{}, frame {}", where, f + 1), f < l.frames.size() ? l.frames[f] : empty,
                     f < r.frames.size() ? r.frames[f] : empty, options);
    }
  }
}

}  // namespace

std::string describe(const NetworkDifference& difference) {
  if (difference.field == "missing") {
    return fmt::format("{}: only in the first file: {}", difference.where, difference.left);
  }
  if (difference.field == "additional") {
    return fmt::format("{}: only in the second file: {}", difference.where, difference.right);
  }
  return fmt::format("{}: {} is {} in the first file, {} in the second", difference.where, difference.field,
                     difference.left, difference.right);
}

std::vector<NetworkDifference> compare_slaves(const SlaveConfig& left, const SlaveConfig& right,
                                              const std::string& name) {
  Differences out;
  compare_init_cmds(out, name + ", init command", left.init_cmds, right.init_cmds);
  const std::vector<CoeInitCmd> none;
  compare_coe(out, name + ", CoE command", left.mailbox ? left.mailbox->coe_commands : none,
              right.mailbox ? right.mailbox->coe_commands : none);
  return out;
}

std::vector<NetworkDifference> compare_networks(const NetworkConfig& left, const NetworkConfig& right,
                                                const CompareOptions& options) {
  Differences out;
  compare_init_cmds(out, "master, init command", left.master.init_cmds, right.master.init_cmds);
  FieldComparison(out, "network")
      .field("slaves", std::to_string(left.slaves.size()), std::to_string(right.slaves.size()));
  for (std::size_t i = 0; i < std::min(left.slaves.size(), right.slaves.size()); ++i) {
    const auto of_slave = compare_slaves(left.slaves[i], right.slaves[i], fmt::format("slave {}", i));
    out.insert(out.end(), of_slave.begin(), of_slave.end());
  }
  compare_tasks(out, left, right, options);
  return out;
}

}  // namespace syncline
