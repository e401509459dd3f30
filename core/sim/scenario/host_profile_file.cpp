// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario/host_profile_file.h"

#include <fmt/format.h>

#include <iterator>
#include <sstream>

#include "sim/scenario/scenario_table.h"
#include "support/jitter_profile.h"

namespace syncline::sim {
namespace {

constexpr double kLongest = 60e9;  // ns; later than that no host is called late
constexpr double kMostStalls = 1000;
constexpr std::string_view kQuantiles = "quantiles";

/// One [part, ns].
std::optional<QuantileCurve::Point> point(const toml::node& node) {
  const auto* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number()) return std::nullopt;
  return QuantileCurve::Point{*(*pair)[0].value<double>(), *(*pair)[1].value<double>()};
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  Result<JitterProfile> read() {
    const auto root = parse_toml(path_);
    if (!root) return tl::unexpected(root.error());
    Table table(*root, path_, error_);
    JitterProfile profile;
    profile.wake_up = section(table, "wake_up");
    profile.stamp_error = section(table, "stamp_error");
    if (const auto* stalls = table.table("stalls")) read_stalls(*stalls, profile);
    table.reject_unknown_keys("a host profile");
    // A host that is always there at once is none that anybody measured.
    if (profile.wake_up.empty() && profile.stamp_error.empty() && profile.stalls_per_second <= 0)
      table.fail_at("wake_up", "is missing, as stamp_error and stalls are: a host profile has times for one of them");
    if (error_) return tl::unexpected(*error_);
    return profile;
  }

 private:
  QuantileCurve section(Table& root, std::string_view name) {
    const auto* node = root.table(name);
    if (node == nullptr) return {};
    Table table(*node, path_, error_);
    auto result = curve(table);
    table.reject_unknown_keys("a host profile");
    return result;
  }

  QuantileCurve curve(Table& table) {
    const auto* list = table.array(kQuantiles);
    if (list == nullptr || list->empty()) {
      table.fail_at(kQuantiles, "must be a list of [part, ns], such as [[0, 50], [0.5, 500], [1, 40000]]");
      return {};
    }
    std::vector<QuantileCurve::Point> points;
    for (const auto& node : *list) {
      const auto next = point(node);
      if (!next || !(next->part >= 0 && next->part <= 1) || !(next->value >= 0 && next->value <= kLongest)) {
        fail_in(node, "must be pairs of a part from 0 to 1 and a time from 0 to 60000000000 ns");
        return {};
      }
      if (!points.empty() && next->part <= points.back().part) fail_in(node, "the parts must rise");
      if (!points.empty() && next->value < points.back().value) {
        fail_in(node, "{part} of all are not above {time} ns, so {other} of all cannot be below {least} ns",
                points.back().part, points.back().value, next->part, next->value);
      }
      points.push_back(*next);
    }
    return {std::move(points)};
  }

  void read_stalls(const toml::table& node, JitterProfile& profile) {
    Table table(node, path_, error_);
    profile.stalls_per_second = table.number("per_second", 0, 0, kMostStalls);
    if (table.has(kQuantiles) || profile.stalls_per_second > 0) profile.stall = curve(table);
    table.reject_unknown_keys("a host profile");
    // The median stands for all: a host that is never there has no master.
    if (profile.stalls_per_second * profile.stall.at(0.5) >= 1e9) {
      table.fail_at("per_second", "so many stalls of this length leave the host no time at all");
    }
  }

  template <class... Given>
  void fail_in(const toml::node& node, std::type_identity_t<ReasonRow<sizeof...(Given)>> row, const Given&... given) {
    if (error_) return;
    error_ = Error{ErrorCode::kScenarioKey, std::string(kQuantiles), because(row, given...), path_,
                   static_cast<int>(node.source().begin.line)};
  }

  const std::string& path_;
  std::optional<Error> error_;
};

void append(std::string& text, std::string_view section, const QuantileCurve& curve) {
  if (curve.empty()) return;
  if (!section.empty()) fmt::format_to(std::back_inserter(text), "\n[{}]\n", section);
  text += "quantiles = [\n";
  for (const auto& [part, value] : curve.points()) {
    fmt::format_to(std::back_inserter(text), "  [{}, {:.0f}],\n", part, value);
  }
  text += "]\n";
}

}  // namespace

Result<JitterProfile> read_host_profile(const std::string& path) { return Reader(path).read(); }

std::string host_profile_text(const JitterProfile& profile, const std::string& about) {
  std::string text;
  std::istringstream lines(about);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  text += "# Pairs of the part of all that is not above a time, and this time in ns.\n";
  append(text, "wake_up", profile.wake_up);
  append(text, "stamp_error", profile.stamp_error);
  if (profile.stalls_per_second > 0) {
    fmt::format_to(std::back_inserter(text), "\n[stalls]\nper_second = {:.6f}\n", profile.stalls_per_second);
    append(text, "", profile.stall);
  }
  return text;
}

}  // namespace syncline::sim
