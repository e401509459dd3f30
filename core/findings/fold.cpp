// SPDX-License-Identifier: Apache-2.0
#include "findings/fold.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace syncline {
namespace {

constexpr std::size_t kFewest = 3;

bool names_its_slave(const Figure& figure, int slave) {
  return figure.unit == Figure::Unit::kSlave && figure.value == slave && figure.other == slave;
}

/// The sentences that people read say it. Others are evidence, which differs from slave to slave.
bool is_said(const Finding& finding, std::string_view figure) {
  const FindingWords* words = find_finding_words(finding.code);
  const auto names = [figure](std::string_view text) {
    for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
      const auto end = text.find_first_of("}:", open);
      if (text.substr(open + 1, end - open - 1) == figure) return true;
    }
    return false;
  };
  return names(facts_template(finding)) || (words != nullptr && names(words->mend));
}

/// All that is equal in findings that fold into one. Times differ from slave to slave and do not count.
std::string likeness(const Finding& finding) {
  std::string text = fmt::format("{}|{}|{}", finding.code, static_cast<int>(finding.severity), facts_template(finding));
  for (const Figure& figure : finding.figures) {
    if (!is_said(finding, figure.name)) continue;
    const bool own = names_its_slave(figure, finding.place.slave);
    text += fmt::format("|{}={}", figure.name, own ? std::string("its") : figure_text(figure));
  }
  return text;
}

FoldedFinding fold(std::span<const Finding> findings, const std::vector<std::size_t>& alike) {
  FoldedFinding all{findings[alike.front()], {}};
  for (const std::size_t i : alike) all.slaves.push_back(findings[i].place.slave);
  std::ranges::sort(all.slaves);
  if (all.slaves.size() == 1) return all;
  for (Figure& figure : all.finding.figures) {
    if (!names_its_slave(figure, all.finding.place.slave)) continue;
    figure.unit = Figure::Unit::kSlaves;
    figure.text = ranges_text(all.slaves);
  }
  return all;
}

}  // namespace

std::string ranges_text(std::span<const int> positions) {
  std::string text;
  for (std::size_t i = 0; i < positions.size();) {
    std::size_t last = i;
    while (last + 1 < positions.size() && positions[last + 1] <= positions[last] + 1) ++last;
    const auto* const between = text.empty() ? "" : ", ";
    text += positions[last] == positions[i] ? fmt::format("{}{}", between, positions[i])
                                            : fmt::format("{}{} to {}", between, positions[i], positions[last]);
    i = last + 1;
  }
  return text;
}

std::vector<FoldedFinding> folded(std::span<const Finding> findings) {
  std::map<std::string, std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].place.slave >= 0) alike[likeness(findings[i])].push_back(i);
  }
  std::vector<FoldedFinding> out;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].place.slave < 0) {
      out.push_back({findings[i], {}});
      continue;
    }
    const auto& group = alike[likeness(findings[i])];
    if (group.size() < kFewest) {
      out.push_back(fold(findings, {i}));
    } else if (group.front() == i) {
      out.push_back(fold(findings, group));
    }
  }
  return out;
}

}  // namespace syncline
