// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "findings/finding.h"

namespace syncline {
struct DamagedPort;
struct RunReport;
struct Spell;
struct SyncLoss;
}  // namespace syncline

/// The rules of the diagnosis, a family of causes a file. Each looks at the report alone and adds what it finds; what
/// one disturbance causes elsewhere is told as its consequence, by the spells that lie within kTogether of it.
namespace syncline::diagnosis {

/// Disturbances so near to each other have one cause.
inline constexpr Nanoseconds kTogether = 10 * kMillisecond;
/// A counter that is read in turn tells of an error up to so much later.
inline constexpr Nanoseconds kReadLater = kSecond;
/// And one that it keeps in an object.
inline constexpr Nanoseconds kToldLater = 10 * kSecond;

using Findings = std::vector<Finding>;

void find_link_outages(const RunReport& report, Findings& findings);
void find_absent_slaves(const RunReport& report, Findings& findings);
void find_states(const RunReport& report, Findings& findings);
void find_clocks(const RunReport& report, Findings& findings);
void find_delays(const RunReport& report, Findings& findings);
void find_late_writes(const RunReport& report, Findings& findings);
void find_master_sync(const RunReport& report, Findings& findings);
void find_misplaced_sync0(const RunReport& report, Findings& findings);
void find_missed_outputs(const RunReport& report, Findings& findings);
void find_tight_sync0(const RunReport& report, Findings& findings);
void find_firmware(const RunReport& report, Findings& findings);
void find_port_errors(const RunReport& report, Findings& findings);
void find_foreign_frames(const RunReport& report, Findings& findings);
void find_lost_frames(const RunReport& report, Findings& findings);
void find_host(const RunReport& report, Findings& findings);
void find_clock_jitter(const RunReport& report, Findings& findings);
void find_working_counters(const RunReport& report, Findings& findings);
/// The last one: takes its consequences out of what the others found.
void find_short_cycle(const RunReport& report, Findings& findings);

/// Somebody else led a slave down: another master, whose clocks these are from then on.
[[nodiscard]] bool has_other_master(const RunReport& report);

// ---- what the rules share -------------------------------------------------------------------------

[[nodiscard]] Figure slave_figure(const RunReport& report, int slave, int last = -1);
[[nodiscard]] Figure count_figure(std::string_view name, std::uint64_t count, bool at_least = false);
/// "once", "3 times".
[[nodiscard]] Figure times_figure(std::string_view name, std::uint64_t count, bool at_least = false);
[[nodiscard]] Figure time_figure(std::string_view name, Nanoseconds length);
/// A host time, told from RunReport::told_from on.
[[nodiscard]] Figure moment_figure(const RunReport& report, std::string_view name, Nanoseconds time);
/// Somebody's own text, and one of finding_phrases().
[[nodiscard]] Figure text_figure(std::string_view name, std::string text);
[[nodiscard]] Figure phrase_figure(std::string_view name, std::string_view text);

/// How late one frame in a thousand is against its nominal place, or the latest of fewer frames; ns.
[[nodiscard]] Nanoseconds usual_worst_lateness(const RunReport& report);
/// How late the latest was, up to half a cycle: what an advice must cover; ns.
[[nodiscard]] Nanoseconds worst_lateness(const RunReport& report);
/// Rounded up to 10 us: nobody sets SYNC0 finer by hand.
[[nodiscard]] Nanoseconds advised(Nanoseconds amount);
/// Adapter and slaves are told apart by when: what is away together with the master's own adapter is its doing.
[[nodiscard]] bool adapter_was_away(const RunReport& report, const Spell& spell);
/// Who left a sync window at `loss` did so behind a reference clock that a frame which had been held up on its way had
/// brought an old time.
[[nodiscard]] bool was_written_late(const RunReport& report, Nanoseconds loss);
/// The same of a loss that has ended, also where the frame came back within its cycle. `who`: whose it is.
enum class Left : std::uint8_t { kSlaves, kMaster };
[[nodiscard]] bool was_written_late(const RunReport& report, const SyncLoss& loss, Left who);
/// Where frames were damaged first in the spell, as far as the readings of the ports tell; nobody: slave -1.
[[nodiscard]] DamagedPort noisy_port(const RunReport& report, const Spell& spell);
/// All slaves were silent at once in the spell, and the first one did not lose its link.
[[nodiscard]] bool was_silence_of_all(const RunReport& report, const Spell& spell);
/// The same, and every frame that nobody waited for any more came back after all: they were held up on their way, which
/// is told as late frames, and nobody was away.
[[nodiscard]] bool were_held_up(const RunReport& report, const Spell& spell);
/// The same, and nobody was without power: frames were lost on their way, which is told as lost frames. Nothing of it
/// where the counters of the first slave were not read since.
[[nodiscard]] bool was_lost_on_the_way(const RunReport& report, const Spell& silence);
/// One of these two: nobody was away in such an absence.
[[nodiscard]] bool was_seeming(const RunReport& report, const Spell& absence);
/// The slave was away in the spell, and not only as it seemed.
[[nodiscard]] bool was_absent(const RunReport& report, int slave, const Spell& spell);
/// Who lost the link over which frames came to it, shortly after the spell; -1: nobody. Its counters are read in turn.
[[nodiscard]] int lost_link_after(const RunReport& report, const Spell& spell);
/// The slave was away, fell, or lost its link near that time: what is seen then on the bus is its doing; -1: nobody.
[[nodiscard]] int slave_in_trouble(const RunReport& report, const Spell& spell);

}  // namespace syncline::diagnosis
