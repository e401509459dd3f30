// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "compile/compile.h"
#include "config/project.h"
#include "eni/format/eni_file.h"

/// What changes in an ENI with a setting, measured by the text of its export.
namespace syncline::test {

/// Nothing where the project cannot be compiled.
inline std::string eni_text(const Project& project, EniDialect dialect) {
  const auto compiled = compile(project, {dialect});
  return compiled ? eni::write_eni(compiled->config, eni::style_of(dialect)) : std::string();
}

/// Each element's path and text, and which slave it is of, as often as it stands there.
using EniElements = std::multiset<std::string>;

inline void collect(const tinyxml2::XMLElement& element, const std::string& above, const std::string& slave,
                    EniElements& all) {
  const auto path = above + "/" + element.Name();
  std::string own = path + "=" + slave + (element.GetText() != nullptr ? element.GetText() : "");
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
    own += std::string(" ") + attribute->Name() + "=" + attribute->Value();
  all.insert(own);
  int slaves = 0;
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const bool begins = std::string_view(child->Name()) == "Slave";
    collect(*child, path, begins ? "of " + std::to_string(slaves++) + ": " : slave, all);
  }
}

inline EniElements elements_of(const std::string& text) {
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  EniElements all;
  if (document.RootElement() != nullptr) collect(*document.RootElement(), "", "", all);
  return all;
}

/// Paths of the elements that only one of them has, or with another text.
inline std::set<std::string> other_paths(const EniElements& before, const EniElements& after) {
  std::vector<std::string> differences;
  std::ranges::set_symmetric_difference(before, after, std::back_inserter(differences));
  std::set<std::string> paths;
  for (const auto& difference : differences) paths.insert(difference.substr(0, difference.find('=')));
  return paths;
}

/// "Slave/Mailbox" is meant by ".../Slave/Mailbox/Recv/PollTime": its steps follow each other there, perhaps with
/// others between.
inline bool is_meant(const std::string& path, std::string_view named) {
  std::size_t at = 0;
  while (!named.empty()) {
    const auto end = std::min(named.find('/'), named.size());
    const auto step = "/" + std::string(named.substr(0, end));
    at = (path + "/").find(step + "/", at);
    if (at == std::string::npos) return false;
    at += step.size();
    named.remove_prefix(std::min(end + 1, named.size()));
  }
  return true;
}

/// The elements that a column names: "ProcessData/RxPdo, ProcessData/TxPdo (32 bits)".
inline std::vector<std::string> named_in(std::string column) {
  for (auto open = column.find('('); open != std::string::npos; open = column.find('('))
    column.erase(open, column.find(')', open) + 1 - open);
  std::vector<std::string> names;
  std::istringstream parts(column);
  for (std::string part; std::getline(parts, part, ',');) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    if (!part.empty()) names.push_back(part);
  }
  return names;
}

/// What was seen to change with a setting.
struct EniEffect {
  int tried = 0, changed = 0;
  std::set<std::string> paths;
  [[nodiscard]] bool holds(const std::string& name) const {
    return std::ranges::any_of(paths, [&](const auto& path) { return is_meant(path, name); });
  }
  [[nodiscard]] std::string some_path() const { return paths.empty() ? "nothing" : *paths.begin(); }
};

}  // namespace syncline::test
