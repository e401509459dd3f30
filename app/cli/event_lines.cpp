// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "channels/event_text.h"

namespace syncline::cli {
namespace {

/// Slaves are led and looked at in groups of some cycles.
constexpr Nanoseconds kSameTime = 100 * kMillisecond;

/// Words that stand behind one slave and behind several.
constexpr std::pair<std::string_view, std::string_view> kPlurals[] = {{" does not answer", " do not answer"},
                                                                      {" answers again", " answer again"}};

std::string behind_several(const std::string& rest) {
  for (const auto& [one, many] : kPlurals) {
    if (rest.starts_with(one)) return std::string(many) + rest.substr(one.size());
  }
  return rest;
}

}  // namespace

std::string slaves_text(std::vector<int> slaves) {
  std::ranges::sort(slaves);
  // Not std::ranges::unique: clang 14 cannot compile what libstdc++ 12 makes of it.
  const auto first = std::unique(slaves.begin(), slaves.end()), last = slaves.end();
  slaves.erase(first, last);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < slaves.size();) {
    std::size_t end = i + 1;
    while (end < slaves.size() && slaves[end] == slaves[end - 1] + 1) ++end;
    // Two in a row are two.
    if (end - i > 2) {
      parts.push_back(fmt::format("{} to {}", slaves[i], slaves[end - 1]));
    } else {
      for (std::size_t k = i; k < end; ++k) parts.push_back(fmt::format("{}", slaves[k]));
    }
    i = end;
  }
  std::string text = slaves.size() == 1 ? "slave " : "slaves ";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

void EventLines::add(const Event& event) {
  const auto words = event_words(event);
  if (!started_) start_ = event.time;
  started_ = true;
  if (words.empty()) return;
  const auto subject = slaves_text({event.slave});
  const bool about_slave = event.slave >= 0 && words.starts_with(subject);
  Line line{event, about_slave ? words.substr(subject.size()) : words, {}, event.time};
  if (about_slave) line.slaves.push_back(event.slave);
  if (!folded_) return tell(line);
  const auto same = std::ranges::find_if(lines_, [&](const Line& other) {
    return about_slave && !other.slaves.empty() && other.first.kind() == event.kind() && other.rest == line.rest &&
           event.time - other.last <= kSameTime && std::ranges::find(other.slaves, event.slave) == other.slaves.end();
  });
  if (same == lines_.end()) {
    lines_.push_back(std::move(line));
  } else {
    same->slaves.push_back(event.slave);
    same->last = event.time;
  }
}

void EventLines::tell_until(Nanoseconds now) {
  sort();
  // In order: a line that still waits keeps those behind it.
  const auto waits = std::ranges::find_if(lines_, [&](const Line& l) { return now - l.last <= kSameTime; });
  std::for_each(lines_.begin(), waits, [this](const Line& line) { tell(line); });
  lines_.erase(lines_.begin(), waits);
}

void EventLines::sort() {
  std::ranges::stable_sort(lines_, {}, [](const Line& line) { return line.first.time; });
}

void EventLines::tell_all() {
  sort();
  for (const auto& line : lines_) tell(line);
  lines_.clear();
}

void EventLines::tell(const Line& line) {
  auto text = line.rest;
  if (line.slaves.size() > 1) text = behind_several(text);
  if (!line.slaves.empty()) text = slaves_text(line.slaves) + text;
  const bool afterwards = line.first.time < told_until_;
  told_until_ = std::max(told_until_, line.first.time);
  out_(fmt::format("{:>10.3f} s  {}{}", static_cast<double>(line.first.time - start_) / 1e9, text,
                   afterwards ? " (told afterwards)" : ""));
}

}  // namespace syncline::cli
