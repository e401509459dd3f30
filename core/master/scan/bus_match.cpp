// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_match.h"

#include <algorithm>

namespace syncline {
namespace {

/// Indices that are still to be matched.
using Open = std::vector<std::uint16_t>;

Open all(std::size_t count) {
  Open open(count);
  for (std::size_t i = 0; i < count; ++i) open[i] = static_cast<std::uint16_t>(i);
  return open;
}

class Matcher {
 public:
  Matcher(std::span<const WantedDevice> wanted, std::span<const FoundDevice> found)
      : wanted_(wanted), found_(found), open_wanted_(all(wanted.size())), open_found_(all(found.size())) {
    match_.position.resize(wanted.size());
  }

  BusMatch run() {
    take_identified();
    take_where([](const WantedDevice& w, const FoundDevice& f) { return w.alias != 0 && w.alias == f.alias; });
    take_groups();
    find_swapped();
    take_in_order();
    find_wrong();
    match_.missing = open_wanted_;
    match_.extra = open_found_;
    return std::move(match_);
  }

 private:
  void take(std::size_t w, std::size_t f) {
    match_.position[open_wanted_[w]] = open_found_[f];
    open_wanted_.erase(open_wanted_.begin() + static_cast<std::ptrdiff_t>(w));
    open_found_.erase(open_found_.begin() + static_cast<std::ptrdiff_t>(f));
  }
  [[nodiscard]] bool fits(std::uint16_t w, std::uint16_t f) const { return is_same_device(wanted_[w], found_[f]); }

  /// Devices of hot-connect groups stand anywhere and take no part in what follows.
  void take_identified() {
    for (std::size_t w = open_wanted_.size(); w-- > 0;) {
      const auto f =
          std::ranges::find_if(open_found_, [&](auto i) { return found_[i].identified_as == open_wanted_[w]; });
      if (f != open_found_.end()) take(w, static_cast<std::size_t>(f - open_found_.begin()));
    }
  }
  void take_groups() {
    const Open candidates = open_wanted_;
    for (const auto w : candidates) {
      if (!wanted_[w].optional) continue;
      const auto& before = wanted_[w].follows;
      const auto place = before ? match_.position[*before] : std::nullopt;
      const auto behind = static_cast<std::uint16_t>(place.value_or(0) + 1);
      if (place && std::ranges::find(open_found_, behind) != open_found_.end() && fits(w, behind)) {
        this->place(w, behind);
      } else {
        match_.absent.push_back(w);
        std::erase(open_wanted_, w);
      }
    }
  }

  template <class Belongs>
  void take_where(Belongs belongs) {
    for (std::size_t w = 0; w < open_wanted_.size();) {
      const auto& device = wanted_[open_wanted_[w]];
      const auto f = std::ranges::find_if(
          open_found_, [&](auto i) { return belongs(device, found_[i]) && is_same_device(device, found_[i]); });
      if (f == open_found_.end()) {
        ++w;
      } else {
        take(w, static_cast<std::size_t>(f - open_found_.begin()));
      }
    }
  }

  /// Longest common subsequence; the usual case, a common beginning, costs nothing.
  void take_in_order() {
    while (!open_wanted_.empty() && !open_found_.empty() && fits(open_wanted_[0], open_found_[0])) take(0, 0);
    const std::size_t rows = open_wanted_.size() + 1, columns = open_found_.size() + 1;
    std::vector<std::uint16_t> longest(rows * columns);
    const auto at = [&](std::size_t w, std::size_t f) -> std::uint16_t& { return longest[w * columns + f]; };
    for (std::size_t w = rows - 1; w-- > 0;) {
      for (std::size_t f = columns - 1; f-- > 0;) {
        at(w, f) = fits(open_wanted_[w], open_found_[f]) ? static_cast<std::uint16_t>(at(w + 1, f + 1) + 1)
                                                         : std::max(at(w + 1, f), at(w, f + 1));
      }
    }
    Open wanted, found;
    std::size_t w = 0, f = 0;
    while (w < rows - 1 && f < columns - 1) {
      if (fits(open_wanted_[w], open_found_[f])) {
        match_.position[open_wanted_[w++]] = open_found_[f++];
      } else if (at(w + 1, f) >= at(w, f + 1)) {
        wanted.push_back(open_wanted_[w++]);
      } else {
        found.push_back(open_found_[f++]);
      }
    }
    wanted.insert(wanted.end(), open_wanted_.begin() + static_cast<std::ptrdiff_t>(w), open_wanted_.end());
    found.insert(found.end(), open_found_.begin() + static_cast<std::ptrdiff_t>(f), open_found_.end());
    open_wanted_ = std::move(wanted);
    open_found_ = std::move(found);
  }

  /// A device that is there, but in another's place, which is in its place.
  void find_swapped() {
    if (wanted_.size() != found_.size()) return;
    for (std::size_t n = 0; n < wanted_.size(); ++n) {
      const auto a = static_cast<std::uint16_t>(n);
      if (fits(a, a) || wanted_[n].optional) continue;
      for (std::size_t i = a + 1U; i < wanted_.size(); ++i) {
        const auto b = static_cast<std::uint16_t>(i);
        if (wanted_[i].optional || fits(b, b) || !fits(a, b) || !fits(b, a) || match_.position[a] || match_.position[b])
          continue;
        match_.swapped.emplace_back(a, b);
        place(a, b);
        place(b, a);
        break;
      }
    }
  }
  void place(std::uint16_t slave, std::uint16_t position) {
    match_.position[slave] = position;
    std::erase(open_wanted_, slave);
    std::erase(open_found_, position);
  }

  /// Same number of devices between the same neighbours: another device stands there.
  void find_wrong() {
    for (std::size_t w = 0; w < open_wanted_.size();) {
      const auto slave = open_wanted_[w];
      const auto f = std::ranges::find(open_found_, slave);
      if (f == open_found_.end() || wanted_.size() != found_.size()) {
        ++w;
        continue;
      }
      match_.wrong.push_back(slave);
      open_wanted_.erase(open_wanted_.begin() + static_cast<std::ptrdiff_t>(w));
      open_found_.erase(f);
    }
  }

  std::span<const WantedDevice> wanted_;
  std::span<const FoundDevice> found_;
  Open open_wanted_, open_found_;
  BusMatch match_;
};

}  // namespace

bool is_same_device(const WantedDevice& wanted, const FoundDevice& found) {
  const auto &a = wanted.identity, &b = found.identity;
  return a.vendor_id == b.vendor_id && a.product_code == b.product_code &&
         (!wanted.check_revision || a.revision_no == b.revision_no) && (a.serial_no == 0 || a.serial_no == b.serial_no);
}

BusMatch match_bus(std::span<const WantedDevice> wanted, std::span<const FoundDevice> found) {
  return Matcher(wanted, found).run();
}

}  // namespace syncline
