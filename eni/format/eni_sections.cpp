// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_sections.h"

#include <algorithm>

namespace syncline::eni {
namespace {

constexpr std::pair<std::string_view, EniPart> kParts[] = {{"<Master>", EniPart::kMaster},
                                                           {"<Slave>", EniPart::kSlave},
                                                           {"<Cyclic>", EniPart::kCyclic},
                                                           {"<ProcessImage>", EniPart::kProcessImage}};

EniPart part_of(std::string_view element) {
  const auto* found = std::ranges::find_if(kParts, [&](const auto& part) { return element.starts_with(part.first); });
  return found == std::end(kParts) ? EniPart::kOther : found->second;
}

std::size_t depth_of(std::string_view line) { return std::min(line.find_first_not_of(" \t"), line.size()); }

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  lines.reserve(static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1);
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<EniSection> sections_of(std::span<const std::string_view> lines) {
  std::vector<EniSection> sections;
  const auto config = std::ranges::find_if(
      lines, [](std::string_view line) { return line.substr(depth_of(line)).starts_with("<Config>"); });
  if (config == lines.end() || config + 1 == lines.end()) return sections;
  const auto depth = depth_of(config[1]);
  int slaves = 0;
  for (auto i = static_cast<std::size_t>(config - lines.begin()) + 1; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (depth_of(line) < depth) break;
    if (depth_of(line) != depth || line.substr(depth).starts_with("</")) {
      if (!sections.empty()) sections.back().count = i + 1 - sections.back().first;
      continue;
    }
    const auto part = part_of(line.substr(depth));
    sections.push_back({part, part == EniPart::kSlave ? slaves++ : -1, i, 1});
  }
  return sections;
}

}  // namespace syncline::eni
