// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/compare_configs.h"
#include "findings/difference_words.h"
#include "findings/sentence.h"

namespace syncline {
struct NetworkConfig;
struct SlaveConfig;
struct SlavePairing;
}  // namespace syncline

namespace syncline::comparison {

/// What differs, by its code; one without words does not compile.
using What = FindingSentence<words::kDifferences>;
/// What differs, with figures in it.
template <FigureName... kNames>
[[nodiscard]] Finding what(std::type_identity_t<FindingSentence<words::kDifferences, kNames...>> sentence,
                           Named<kNames>... figures) {
  return make_finding<words::kDifferences>(sentence, {}, std::move(figures)...);
}

/// Collects the differences of one pair of slaves, or of the network.
class DifferenceList {
 public:
  explicit DifferenceList(std::vector<ConfigDifference>& out) : out_(out) {}
  DifferenceList(std::vector<ConfigDifference>& out, std::optional<std::size_t> left, std::optional<std::size_t> right,
                 std::string name)
      : out_(out), first_(out.size()), left_(left), right_(right), name_(std::move(name)) {}

  void add(DifferenceGroup group, Finding what, std::string left, std::string right);
  void add(DifferenceGroup group, What what, std::string left, std::string right) {
    add(group, make_finding<words::kDifferences>(what, {}), std::move(left), std::move(right));
  }
  void field(DifferenceGroup group, What what, const std::string& left, const std::string& right) {
    if (left != right) add(group, what, left, right);
  }
  void number(DifferenceGroup group, What what, std::int64_t left, std::int64_t right, const char* unit = "");
  void time(DifferenceGroup group, What what, std::int64_t left_ns, std::int64_t right_ns);
  void flag(DifferenceGroup group, What what, bool left, bool right) {
    field(group, what, left ? "yes" : "no", right ? "yes" : "no");
  }
  /// True when this pair has a difference of the group already.
  [[nodiscard]] bool has(DifferenceGroup group) const;

 private:
  std::vector<ConfigDifference>& out_;
  std::size_t first_ = 0;
  std::optional<std::size_t> left_, right_;
  std::string name_;
};

void compare_process_data(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out);
void compare_mailbox(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out);
void compare_clocks(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out);
/// Init commands, after the groups that explain most of them.
void compare_commands(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out);
void compare_cyclic(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                    DifferenceList& out);
void compare_master(const NetworkConfig& left, const NetworkConfig& right, DifferenceList& out);
void compare_image(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                   DifferenceList& out);
/// FMMUs, variables and commands that moved against the rest; after the cyclic commands.
void compare_places(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                    DifferenceList& out);

}  // namespace syncline::comparison
