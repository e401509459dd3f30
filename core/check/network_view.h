// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "findings/eni_words.h"
#include "findings/finding_list.h"
#include "findings/sentence.h"
#include "protocol/al_state.h"
#include "protocol/command.h"
#include "protocol/fmmu.h"
#include "protocol/sync_manager.h"

namespace syncline {
struct InitCmd;
}  // namespace syncline

/// The rules of the checker and what they share; check_network() puts them together.
namespace syncline::checker {

/// Where the memory of an ESC begins that SyncManagers and FMMUs may use: the digital outputs
/// (ESC data sheet, section II); registers lie below.
inline constexpr std::uint16_t kFirstDataAddress = 0x0F00;
/// A read in 0x0502 (ESC data sheet, section II).
inline constexpr std::uint16_t kSiiRead = 0x0100;

struct FmmuWrite {
  std::size_t cmd = 0;  // index in SlaveConfig::init_cmds
  unsigned number = 0;
  Fmmu fmmu;
  bool reserved_bits = false;  // bits that ETG.1000.4 leaves 0 are set
};

struct SyncManagerWrite {
  std::size_t cmd = 0;
  unsigned number = 0;
  SyncManager manager;
};

/// What the init commands leave in a slave's registers once it is in OP: written on IP, PS or SO, the last one counts.
struct SlaveRegisters {
  std::vector<FmmuWrite> fmmus;            // active ones, by number
  std::vector<FmmuWrite> idle_fmmus;       // written with a mapping, and not active
  std::vector<SyncManagerWrite> managers;  // enabled ones, by number
  [[nodiscard]] const SyncManagerWrite* manager(unsigned number) const;
};

struct CyclicPlace {
  const CyclicCmd* cmd = nullptr;
  std::size_t task = 0, frame = 0, index = 0;
  [[nodiscard]] ConfigPlace place() const { return {PlaceKind::kCyclicCmd, task, frame, index}; }
};

/// A configuration with the look-ups that the rules need.
class NetworkView {
 public:
  explicit NetworkView(const NetworkConfig& network);

  const NetworkConfig& config;
  std::vector<SlaveRegisters> registers;  // one a slave
  std::vector<CyclicPlace> cyclic;        // all cyclic commands
  /// The command that distributes the reference clock's time (ARMW or FRMW of 0x0910), if any.
  std::optional<CyclicPlace> drift_compensation;

  /// First slave with that station address.
  [[nodiscard]] std::optional<std::size_t> with_address(std::uint16_t station_address) const;
  /// Slave that a command with one addressee goes to.
  [[nodiscard]] std::optional<std::size_t> addressee(Command command, std::uint16_t adp) const;
  /// "slave 3 (Drive)"
  template <FigureName kName>
  [[nodiscard]] Named<kName> slave(std::size_t position) const {
    return fig::slave<kName>(position, position < config.slaves.size() ? config.slaves[position].name : std::string());
  }
  /// What the slave's command on PS writes to 0x0980, 0 = nothing.
  [[nodiscard]] std::uint16_t assign_activate(std::size_t slave) const;

 private:
  std::unordered_map<std::uint16_t, std::size_t> by_address_;
};

template <FigureName... kNames>
using Sentence = std::type_identity_t<FindingSentence<words::kEni, kNames...>>;

class Findings {
 public:
  explicit Findings(FindingList& out) : out_(out) {}

  template <FigureName... kNames>
  void add(Sentence<kNames...> code, const ConfigPlace& part, Named<kNames>... figures) {
    if (!out_.has_room(code.words().code)) return out_.leave_out(code.words());
    Place place(part.slave());
    place.part = part;
    out_.add(make_finding<words::kEni, kNames...>(code, std::move(place), std::move(figures)...));
  }
  /// One that somebody else made.
  void take(Finding finding, const ConfigPlace& part) {
    finding.place.slave = part.slave();
    finding.place.part = part;
    finding.place.key = setting_at(find_finding_words(finding.code)->setting, part.slave());
    out_.add(std::move(finding));
  }

 private:
  FindingList& out_;
};

[[nodiscard]] bool has(const CyclicCmd& cmd, AlState state);
/// Writes to a register of the slave, and the datagram touches `ado`.
[[nodiscard]] bool writes_register(const InitCmd& cmd, std::uint16_t ado);
/// Little-endian number of up to 4 bytes that the command writes to `ado`, if it touches all of them.
[[nodiscard]] std::optional<std::uint32_t> written_number(const InitCmd& cmd, std::uint16_t ado, std::size_t bytes);

/// Half-open range of numbers, of bits or bytes.
struct Range {
  std::uint64_t begin = 0, end = 0;
  bool operator==(const Range&) const = default;
  [[nodiscard]] bool empty() const { return begin >= end; }
  [[nodiscard]] bool contains(const Range& inner) const { return begin <= inner.begin && inner.end <= end; }
  [[nodiscard]] bool overlaps(const Range& other) const { return begin < other.end && other.begin < end; }
};

/// A range with the number of whatever it belongs to.
struct OwnedRange {
  Range range;
  std::size_t owner = 0;
};
struct Overlap {
  std::size_t first = 0, second = 0;  // indexes into the list
};
/// For each range that overlaps one before it (by begin), one pair with the one that reaches farthest.
[[nodiscard]] std::vector<Overlap> overlaps(const std::vector<OwnedRange>& ranges);
/// The same set of numbers as disjoint ranges, sorted.
[[nodiscard]] std::vector<Range> merged(std::vector<Range> ranges);
/// True when one of the disjoint, sorted `pieces` contains `whole`.
[[nodiscard]] bool covered(const Range& whole, const std::vector<Range>& pieces);

[[nodiscard]] inline Range logical_bytes(const Fmmu& fmmu) {
  return {fmmu.logical_start, std::uint64_t{fmmu.logical_start} + fmmu.length};
}
[[nodiscard]] inline Range logical_bits(const Fmmu& fmmu) {
  const std::uint64_t begin = std::uint64_t{fmmu.logical_start} * 8 + fmmu.logical_start_bit;
  return {begin, begin + fmmu.bit_length()};
}
[[nodiscard]] inline Range logical_bytes(const CyclicCmd& cmd) {
  return {cmd.logical_address, std::uint64_t{cmd.logical_address} + cmd.length()};
}

void check_references(const NetworkView& view, Findings& findings);
void check_identities(const NetworkView& view, Findings& findings);
void check_hot_connect(const NetworkView& view, Findings& findings);
void check_pdo_assignment(const NetworkView& view, Findings& findings);
void check_image(const NetworkView& view, Findings& findings);
void check_image_places(const NetworkView& view, Findings& findings);
void check_fmmus(const NetworkView& view, Findings& findings);
void check_sync_managers(const NetworkView& view, Findings& findings);
void check_mailboxes(const NetworkView& view, Findings& findings);
void check_working_counters(const NetworkView& view, Findings& findings);
void check_dc_commands(const NetworkView& view, Findings& findings);
void check_dc_slaves(const NetworkView& view, Findings& findings);
void check_command_order(const NetworkView& view, Findings& findings);
void check_state_requests(const NetworkView& view, Findings& findings);
void check_times(const NetworkView& view, Findings& findings);
void check_frames(const NetworkView& view, Findings& findings);
void check_coe(const NetworkView& view, Findings& findings);
void check_coe_sizes(const NetworkView& view, Findings& findings);
void check_dialects(const NetworkView& view, Findings& findings);
void check_device_families(const NetworkView& view, Findings& findings);

}  // namespace syncline::checker
