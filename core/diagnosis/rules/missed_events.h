// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "trace/run_report.h"

namespace syncline {
struct Figure;
}  // namespace syncline

namespace syncline::diagnosis {

/// Which cause has most of the missed SM2 events.
[[nodiscard]] dc::MissCause main_cause(const Sm2MissedStatus& status);
/// What is told of that cause. Where nothing holds the frames at their place, one that is held up a little now and then
/// is not why they come behind SYNC0. What a host that stands still has under way goes when it goes on: that is its
/// doing, and not the wire's. Frames that come behind SYNC0 because they were held up are not the host's lateness.
[[nodiscard]] dc::MissCause told_cause(const RunReport& report, const RunReport::Slave& slave, dc::MissCause cause);
/// "frames were lost": goes behind a colon or "because".
[[nodiscard]] std::string_view miss_cause_words(const RunReport& report, const RunReport::Slave& slave,
                                                dc::MissCause cause);

/// Whether anything moves the frames to their place in the SYNC grid, or the reference clock to them.
[[nodiscard]] bool is_controlled(const RunReport& report);
/// Whether the schedule held its place in the SYNC grid all the time, whatever the host made of single frames. Nothing
/// holds it there where nobody controls it.
[[nodiscard]] bool was_locked(const RunReport& report);
/// The same of one moment (host clock), and of most of these events, which may have been read up to kReadLater behind.
[[nodiscard]] bool was_locked(const RunReport& report, Nanoseconds moment);
[[nodiscard]] bool was_locked(const RunReport& report, const Spells& events);
/// The same for this slave: in front of the reference clock, whose readings nobody takes, it had run away while that
/// was absent, and its clock needs seconds to find back.
[[nodiscard]] bool was_locked(const RunReport& report, const RunReport::Slave& slave, const Spells& events);
/// By how much frames were held up at each of these times (or up to kToldLater before, when a counter was read), where
/// this slave's outputs would have been early enough otherwise. Empty where one of them has no such frame.
[[nodiscard]] std::optional<Nanoseconds> held_up(const RunReport& report, const RunReport::Slave& slave,
                                                 const Spells& times);
/// What a later SYNC0 is worth to a slave: "margin" it has, "lateness" of one frame in a thousand, what it "need"s
/// itself, and by how much "more" the set value would do.
[[nodiscard]] std::vector<Figure> lateness_figures(const RunReport& report, const RunReport::Slave& slave);

}  // namespace syncline::diagnosis
