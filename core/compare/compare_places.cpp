// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compare/difference_list.h"
#include "compare/slave_pairing.h"
#include "config/command_text.h"
#include "config/cyclic_frame.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"

/// Where data lie: in the logical address space and in the process image. What only follows from the places of the
/// slaves is no difference; one FMMU, command or variable that moves against the others is.
namespace syncline::comparison {
namespace {

using Group = DifferenceGroup;

constexpr std::size_t kTold = 3;  // so many are named one by one, more are counted

/// A thing with a place, in bits or bytes from whatever it should move with.
struct Placed {
  std::string what;
  std::int64_t at = 0;
  bool operator==(const Placed&) const = default;
};

/// Differences of the same kind: a few are named, many counted.
class Moves {
 public:
  /// What is said of many.
  using Counted = FindingSentence<words::kDifferences, counted(FigureName("count"))>;
  explicit Moves(Counted counted) : counted_(counted) {}
  void add(Finding what, std::int64_t left, std::int64_t right) {
    add(std::move(what), fmt::format("{}", left), fmt::format("{}", right));
  }
  void add(Finding what, std::string left, std::string right) {
    if (++count_ <= kTold) named_.push_back({std::move(what), std::move(left), std::move(right)});
  }
  void report(DifferenceList& out) const {
    if (count_ > kTold) return out.add(Group::kImage, what(counted_, fig::count<"count">(count_)), "", "");
    for (const auto& move : named_) out.add(Group::kImage, move.what, move.left, move.right);
  }

 private:
  struct Told {
    Finding what;
    std::string left, right;
  };
  Counted counted_;
  std::size_t count_ = 0;
  std::vector<Told> named_;
};

std::int64_t start(const std::optional<ImageRange>& range) { return range ? range->bit_start : 0; }

/// Logical bit of each FMMU that a slave writes active, against the slave's data in the image: equal in two files as
/// long as both say the same about one machine, wherever the tools put the data as a whole.
std::vector<Placed> fmmus(const SlaveConfig& slave, std::uint32_t mailbox_states) {
  std::vector<Placed> out;
  for (const InitCmd& cmd : slave.init_cmds) {
    if (!writes(cmd.command) || is_logical(cmd.command) || cmd.ado < reg::kFmmu || cmd.ado >= reg::kFmmu + 0x100 ||
        cmd.data.size() != Fmmu::kSize) {
      continue;
    }
    const Fmmu fmmu = Fmmu::decode(std::span<const std::uint8_t, Fmmu::kSize>(cmd.data.data(), Fmmu::kSize));
    if (!fmmu.active) continue;
    std::int64_t bit = std::int64_t{fmmu.logical_start} * 8 + fmmu.logical_start_bit;
    const bool state = slave.mailbox && slave.mailbox->status_bit_address && fmmu.physical_start >= reg::kSyncManager &&
                       fmmu.physical_start < reg::kSyncManager + 0x80;
    bit -= state ? std::int64_t{mailbox_states} * 8 + *slave.mailbox->status_bit_address
                 : start(fmmu.write ? slave.send : slave.receive);
    const std::string name = fmt::format("FMMU {}{}", (cmd.ado - reg::kFmmu) / Fmmu::kSize,
                                         std::ranges::find(cmd.transitions, Transition::kPS) != cmd.transitions.end()
                                             ? ""
                                             : fmt::format(" ({})", transitions_text(cmd.transitions)));
    out.push_back({name, bit});
  }
  return out;
}

/// A whole layout may lie elsewhere (another tool): what all, or nearly all, have moved by.
std::int64_t common_move(const std::vector<std::int64_t>& moves) {
  std::map<std::int64_t, std::size_t> counts;
  for (const std::int64_t move : moves) ++counts[move];
  const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  return most == counts.end() || most->second * 2 <= moves.size() ? 0 : most->first;
}

struct Move {
  Finding what;
  std::int64_t left = 0, right = 0;
};

/// Those that do not move as most do.
void report_moves(const std::vector<Move>& moves, bool may_shift, Moves::Counted counted, DifferenceList& out) {
  std::vector<std::int64_t> by;
  for (const Move& move : moves) by.push_back(move.right - move.left);
  const std::int64_t common = may_shift ? common_move(by) : 0;
  Moves told(counted);
  for (const Move& move : moves) {
    if (move.right - move.left != common) told.add(move.what, move.left, move.right - common);
  }
  told.report(out);
}

void compare_fmmus(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                   DifferenceList& out) {
  std::vector<Move> moves;
  for (std::size_t i = 0; i < left.slaves.size(); ++i) {
    if (!pairing.right_of[i]) continue;
    const auto one = fmmus(left.slaves[i], left.master.mailbox_state_start);
    const auto other = fmmus(right.slaves[*pairing.right_of[i]], right.master.mailbox_state_start);
    // Another number of FMMUs is told with the commands.
    for (std::size_t f = 0; f < one.size() && one.size() == other.size(); ++f) {
      moves.push_back(
          {what("difference-fmmu", fig::text<"fmmu">(one[f].what), fig::slave<"slave">(i, left.slaves[i].name)),
           one[f].at, other[f].at});
    }
  }
  // The address of the commands is told where a whole layout lies elsewhere.
  report_moves(moves, out.has(Group::kCyclic) || out.has(Group::kMaster), "difference-moved/fmmus", out);
}

/// Slaves' data in the image, to say whose a bit is.
class Owners {
 public:
  Owners(const NetworkConfig& config, bool inputs) {
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      const auto& range = inputs ? config.slaves[i].receive : config.slaves[i].send;
      if (range && range->bit_length > 0) ranges_.emplace(range->bit_start, std::pair(i, *range));
    }
  }
  /// Slave and bit within its data.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::uint32_t>> of(std::uint32_t bit) const {
    auto next = ranges_.upper_bound(bit);
    if (next == ranges_.begin()) return std::nullopt;
    const auto& [slave, range] = std::prev(next)->second;
    return bit - range.bit_start < range.bit_length ? std::optional(std::pair(slave, bit - range.bit_start))
                                                    : std::nullopt;
  }

 private:
  std::map<std::uint32_t, std::pair<std::size_t, ImageRange>> ranges_;
};

using VariablePairs = std::vector<std::pair<const Variable*, const Variable*>>;

/// Variables by name, or by order where the names are others.
VariablePairs paired(const std::vector<Variable>& left, const std::vector<Variable>& right) {
  VariablePairs out;
  const bool same_names = std::ranges::equal(left, right, {}, &Variable::name, &Variable::name);
  std::map<std::string_view, const Variable*> others;
  for (const Variable& variable : right) others.emplace(variable.name, &variable);
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto other = others.find(left[i].name);
    if (same_names || (other == others.end() && left.size() == right.size())) {
      out.emplace_back(&left[i], &right[i]);
    } else if (other != others.end()) {
      out.emplace_back(&left[i], other->second);
    }
  }
  return out;
}

/// The variables of one side of the image with their slaves.
struct Side {
  const NetworkConfig& config;
  const Owners& owners;

  /// Without the name of its slave, which is no difference.
  [[nodiscard]] std::string_view own_name(const Variable& variable) const {
    std::string_view name = variable.name;
    const auto owner = owners.of(variable.bit_offset);
    if (owner && name.starts_with(config.slaves[owner->first].name))
      name.remove_prefix(config.slaves[owner->first].name.size());
    return name;
  }
};

/// What an application finds a variable by, and what it takes it for. Tools name all in their own way, so that names
/// count only where most are the same.
void compare_meaning(const VariablePairs& pairs, const Side& left, const Side& right, DifferenceList& out) {
  const auto same_name = [&](const auto& pair) { return left.own_name(*pair.first) == right.own_name(*pair.second); };
  const auto same = static_cast<std::size_t>(std::ranges::count_if(pairs, same_name));
  Moves renamed("difference-variable-names"), retyped("difference-variable-types");
  for (const auto& pair : pairs) {
    const auto& [one, other] = pair;
    if (!same_name(pair) && 2 * same >= pairs.size())
      renamed.add(what("difference-variable/name", fig::number<"bit">(one->bit_offset)), one->name, other->name);
    if (one->data_type != other->data_type && !one->data_type.empty() && !other->data_type.empty()) {
      retyped.add(what("difference-variable/type", fig::text<"variable">(one->name)), one->data_type, other->data_type);
    }
  }
  renamed.report(out);
  retyped.report(out);
}

void compare_variables(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing, bool inputs,
                       DifferenceList& out) {
  const auto& ours = inputs ? left.image.inputs : left.image.outputs;
  const auto& theirs = inputs ? right.image.inputs : right.image.outputs;
  if (ours == theirs && left.slaves.size() == right.slaves.size()) return;
  const bool same_slaves = left.slaves.size() == right.slaves.size();
  if (same_slaves && !out.has(Group::kCyclic)) {
    out.number(Group::kImage, inputs ? What("difference-variables") : What("difference-variables/outputs"),
               static_cast<std::int64_t>(ours.size()), static_cast<std::int64_t>(theirs.size()));
  }
  const Owners left_owners(left, inputs), right_owners(right, inputs);
  Moves moved(inputs ? Moves::Counted("difference-moved") : Moves::Counted("difference-moved/outputs"));
  const auto pairs = paired(ours, theirs);
  for (const auto& [one, other] : pairs) {
    const auto owner = left_owners.of(one->bit_offset);
    const auto new_owner = right_owners.of(other->bit_offset);
    // What belongs to no slave on both sides is the tool's own diagnosis: its place follows from the frames.
    const bool same_place =
        owner && new_owner
            ? pairing.right_of[owner->first] == std::optional(new_owner->first) && owner->second == new_owner->second
            : !owner && !new_owner && (!same_slaves || one->bit_offset == other->bit_offset);
    if (!same_place)
      moved.add(what("difference-variable", fig::text<"variable">(one->name)), one->bit_offset, other->bit_offset);
    if (one->bit_size != other->bit_size) {
      out.add(Group::kImage, what("difference-variable/bits", fig::text<"variable">(one->name)),
              fmt::format("{}", one->bit_size), fmt::format("{}", other->bit_size));
    }
  }
  moved.report(out);
  compare_meaning(pairs, {left, left_owners}, {right, right_owners}, out);
}

/// Where commands put their data in the image, from the start that each tool counts from.
void compare_offsets(const NetworkConfig& left, const NetworkConfig& right, DifferenceList& out) {
  std::vector<Move> inputs, outputs;
  for (std::size_t t = 0; t < std::min(left.cyclic.size(), right.cyclic.size()); ++t) {
    const auto flat = [](const CyclicTask& task) {
      std::vector<const CyclicCmd*> all;
      for (const auto& frame : task.frames) {
        for (const auto& cmd : frame.commands) all.push_back(&cmd);
      }
      return all;
    };
    const auto one = flat(left.cyclic[t]);
    const auto other = flat(right.cyclic[t]);
    if (one.size() != other.size()) return;
    for (std::size_t c = 0; c < one.size(); ++c) {
      const auto command = address_text(*one[c]);
      inputs.push_back({what("difference-command-data", fig::text<"command">(command)),
                        std::int64_t{one[c]->input_offset} + left.image.command_data_offset,
                        std::int64_t{other[c]->input_offset} + right.image.command_data_offset});
      outputs.push_back({what("difference-command-data/outputs", fig::text<"command">(command)),
                         std::int64_t{one[c]->output_offset} + left.image.command_data_offset,
                         std::int64_t{other[c]->output_offset} + right.image.command_data_offset});
    }
  }
  report_moves(inputs, false, "difference-moved/command-inputs", out);
  report_moves(outputs, false, "difference-moved/command-outputs", out);
}

}  // namespace

void compare_places(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                    DifferenceList& out) {
  compare_fmmus(left, right, pairing, out);
  compare_variables(left, right, pairing, true, out);
  compare_variables(left, right, pairing, false, out);
  // Other commands or slaves need other places.
  if (out.has(Group::kCyclic) || out.has(Group::kClocks) || left.slaves.size() != right.slaves.size()) return;
  compare_offsets(left, right, out);
}

}  // namespace syncline::comparison
