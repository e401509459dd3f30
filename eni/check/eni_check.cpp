// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/check_network.h"
#include "eni/check/eni_locations.h"
#include "eni/check/eni_structure.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_reader.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "protocol/error_text.h"

namespace syncline::eni {
namespace {

EniFinding unreadable(const Error& error) {
  EniFinding finding;
  finding.code = "ENI-XML-01";
  finding.line = error.line;
  finding.what = describe(error);
  return finding;
}

/// What the reader refuses and the structure does not explain.
void add_reader_error(EniCheck& check, const Error& error) {
  check.understood = false;
  const bool explained = std::ranges::any_of(check.findings, [](const EniFinding& finding) {
    return find_check_rule(finding.code)->severity == CheckSeverity::kError;
  });
  if (!explained) check.findings.push_back(unreadable(error));
}

void add_semantic_findings(EniCheck& check, const NetworkConfig& config, const EniLocations& locations) {
  for (CheckFinding& found : check_network(config)) {
    EniLocation location = locations.locate(found.place);
    EniFinding finding;
    finding.code = found.code;
    finding.line = location.line;
    finding.path = std::move(location.path);
    finding.slave = found.place.slave();
    finding.what = std::move(found.what);
    check.findings.push_back(std::move(finding));
  }
}

/// Names, severities and the order by line.
void finish(EniCheck& check, const NetworkConfig* config) {
  for (EniFinding& finding : check.findings) {
    finding.severity = find_check_rule(finding.code)->severity;
    if (config != nullptr && finding.slave >= 0 && static_cast<std::size_t>(finding.slave) < config->slaves.size()) {
      finding.slave_name = config->slaves[static_cast<std::size_t>(finding.slave)].name;
    }
  }
  std::ranges::stable_sort(check.findings, {}, &EniFinding::line);
}

}  // namespace

Result<EniCheck> check_eni_text(std::string_view text, const std::string& file_name) {
  EniCheck check;
  const auto document = parse_xml(text, file_name);
  if (!document) {
    if (document.error().code != ErrorCode::kXmlMalformed) return fail(document.error());
    check.understood = false;
    check.findings.push_back(unreadable(document.error()));
    finish(check, nullptr);
    return check;
  }
  const tinyxml2::XMLElement& root = *(*document)->RootElement();
  const auto config = read_eni_document(&root, file_name);
  if (!config && config.error().code != ErrorCode::kXmlBadValue &&
      config.error().code != ErrorCode::kXmlMissingElement) {
    return fail(config.error());
  }
  check.findings = check_structure(root);
  if (config) {
    check.slaves = config->slaves.size();
    add_semantic_findings(check, *config, EniLocations(root));
  } else {
    add_reader_error(check, config.error());
  }
  finish(check, config ? &*config : nullptr);
  return check;
}

Result<EniCheck> check_eni(const std::string& path) {
  const auto text = read_file(path);
  return text ? check_eni_text(*text, path) : fail(text.error());
}

}  // namespace syncline::eni
