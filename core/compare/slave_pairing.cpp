// SPDX-License-Identifier: Apache-2.0
#include "compare/slave_pairing.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace syncline {
namespace {

bool same_product(const SlaveKey& a, const SlaveKey& b) {
  return a.identity.vendor_id == b.identity.vendor_id && a.identity.product_code == b.identity.product_code;
}
bool same_name(const SlaveKey& a, const SlaveKey& b) { return a.name == b.name && !a.name.empty(); }

std::uint32_t score(const SlaveKey& a, const SlaveKey& b) {
  if (!same_product(a, b)) return 0;
  return 4U + (same_name(a, b) ? 2U : 0U) + (a.identity.revision_no == b.identity.revision_no ? 1U : 0U);
}

class Pairing {
 public:
  Pairing(std::span<const SlaveKey> left, std::span<const SlaveKey> right) : left_(left), right_(right) {
    out_.right_of.resize(left.size());
    out_.left_of.resize(right.size());
    out_.moved.resize(left.size(), false);
  }

  SlavePairing run() {
    std::size_t begin = 0;
    std::size_t left_end = left_.size();
    std::size_t right_end = right_.size();
    const auto alike = [&](std::size_t l, std::size_t r) {
      return same_product(left_[l], right_[r]) &&
             (left_[l].name == right_[r].name || left_[l].name.empty() || right_[r].name.empty());
    };
    // From both ends as far as there is no doubt; only the rest is searched. Without names any slave of a row of equal
    // ones may be the missing one: the last is taken.
    while (begin < left_end && begin < right_end && alike(begin, begin)) {
      pair(begin, begin);
      ++begin;
    }
    while (left_end > begin && right_end > begin && alike(left_end - 1, right_end - 1)) {
      pair(--left_end, --right_end);
    }
    search(begin, left_end, right_end);
    pair_moved();
    pair_replaced();
    return std::move(out_);
  }

 private:
  void pair(std::size_t l, std::size_t r) {
    out_.right_of[l] = r;
    out_.left_of[r] = l;
  }

  /// Heaviest pairing in order of the slaves from `begin` on.
  void search(std::size_t begin, std::size_t left_end, std::size_t right_end) {
    const std::size_t rows = left_end - begin + 1;
    const std::size_t columns = right_end - begin + 1;
    if (rows == 1 || columns == 1 || rows > kMostCells / columns) return;
    std::vector<std::uint32_t> best(rows * columns, 0);
    const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return best[i * columns + j]; };
    for (std::size_t i = rows - 1; i-- > 0;) {
      for (std::size_t j = columns - 1; j-- > 0;) {
        const std::uint32_t together = score(left_[begin + i], right_[begin + j]);
        at(i, j) = std::max({at(i + 1, j), at(i, j + 1), together ? at(i + 1, j + 1) + together : 0});
      }
    }
    for (std::size_t i = 0, j = 0; i + 1 < rows && j + 1 < columns;) {
      const std::uint32_t together = score(left_[begin + i], right_[begin + j]);
      if (together && at(i, j) == at(i + 1, j + 1) + together) {
        pair(begin + i++, begin + j++);
      } else if (at(i, j) == at(i + 1, j)) {
        ++i;
      } else {
        ++j;
      }
    }
  }

  /// Slaves left over on both sides that are the same device, by name first.
  void pair_moved() {
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::string>;
    for (const bool by_name : {true, false}) {
      std::map<Key, std::vector<std::size_t>> open;
      const auto key = [&](const SlaveKey& slave) {
        return Key{slave.identity.vendor_id, slave.identity.product_code, by_name ? slave.name : ""};
      };
      for (std::size_t r = right_.size(); r-- > 0;) {
        if (!out_.left_of[r] && !(by_name && right_[r].name.empty())) open[key(right_[r])].push_back(r);
      }
      for (std::size_t l = 0; l < left_.size(); ++l) {
        if (out_.right_of[l]) continue;
        const auto found = open.find(key(left_[l]));
        if (found == open.end() || found->second.empty()) continue;
        pair(l, found->second.back());
        found->second.pop_back();
        out_.moved[l] = true;
      }
    }
  }

  /// Another device in the same place: gaps of equal size between slaves that are paired in order.
  void pair_replaced() {
    std::size_t l = 0;
    std::size_t r = 0;
    while (l < left_.size() && r < right_.size()) {
      std::size_t left_end = l;
      std::size_t right_end = r;
      while (left_end < left_.size() && !out_.right_of[left_end]) ++left_end;
      while (right_end < right_.size() && !out_.left_of[right_end]) ++right_end;
      if (left_end - l == right_end - r) {
        for (std::size_t i = 0; l + i < left_end; ++i) pair(l + i, r + i);
      }
      l = left_end + 1;
      r = right_end + 1;
      // Slaves that moved stand in no common order: step over them.
      while (l < left_.size() && out_.moved[l]) ++l;
      while (r < right_.size() && out_.left_of[r] && out_.moved[*out_.left_of[r]]) ++r;
    }
  }

  std::span<const SlaveKey> left_, right_;
  SlavePairing out_;
};

}  // namespace

SlavePairing pair_slaves(std::span<const SlaveKey> left, std::span<const SlaveKey> right) {
  return Pairing(left, right).run();
}

}  // namespace syncline
