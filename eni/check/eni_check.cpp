// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_check.h"

#include <algorithm>

#include "check/check_network.h"
#include "eni/check/eni_locations.h"
#include "eni/check/eni_structure.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_reader.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_text.h"
#include "findings/eni_structure_words.h"
#include "findings/error_text.h"
#include "findings/sentence.h"

namespace syncline::eni {
namespace {

Finding unreadable(const Error& error) {
  Place place;
  place.line = error.line;
  return make_finding<words::kEniStructure, "error">("ENI-XML-01", std::move(place),
                                                     fig::text<"error">(describe(error)));
}

/// What the reader refuses and the structure does not explain.
void add_reader_error(EniCheck& check, FindingList& found, const Error& error) {
  check.understood = false;
  if (!has_errors(found.kept())) found.add(unreadable(error));
}

void add_semantic_findings(FindingList& found, const NetworkConfig& config, const EniLocations& locations) {
  const std::size_t first = found.kept().size();
  check_network(config, found);
  for (std::size_t i = first; i < found.kept().size(); ++i) {
    Place& place = found[i].place;
    EniLocation location = locations.locate(place.part);
    place.line = location.line;
    place.path = std::move(location.path);
  }
}

void put_by_line(EniCheck& check, FindingList& found) {
  check.findings = found.take_kept();
  std::ranges::stable_sort(check.findings, {}, [](const Finding& finding) { return finding.place.line; });
  check.not_listed = found.left_out();
  if (auto rest = found.rest()) check.findings.push_back(std::move(*rest));
}

/// Before the file is read into a configuration, which takes several times its size.
Result<EniLocations> check_text(std::string_view text, const std::string& file_name, FindingList& findings) {
  auto pieces = XmlPieces::parse(text, file_name, is_eni_piece);
  if (!pieces) return fail(pieces.error());
  check_structure(*pieces, findings);
  EniLocations locations(*pieces);
  if (!pieces->error()) return locations;
  findings = {};
  return fail(*pieces->error());
}

}  // namespace

std::string EniCheck::slave_name(const Finding& finding) const {
  const auto at = static_cast<std::size_t>(finding.place.slave);
  return finding.place.slave >= 0 && at < slaves.size() ? slaves[at] : std::string();
}

std::size_t EniCheck::count(Severity severity) const {
  const auto listed = std::ranges::count_if(findings, [severity](const Finding& finding) {
    return finding.severity == severity && finding.code != FindingList::kRest;
  });
  return static_cast<std::size_t>(listed) + not_listed[severity];
}

Result<EniCheck> check_eni_text(std::string_view text, const std::string& file_name) {
  EniCheck check;
  FindingList found;
  const auto locations = check_text(text, file_name, found);
  if (!locations) {
    if (locations.error().code != ErrorCode::kXmlMalformed) return fail(locations.error());
    check.understood = false;
    check.findings.push_back(unreadable(locations.error()));
    return check;
  }
  const auto config = parse_eni(text, file_name);
  if (!config && config.error().code != ErrorCode::kXmlBadValue &&
      config.error().code != ErrorCode::kXmlMissingElement) {
    return fail(config.error());
  }
  if (config) {
    for (const SlaveConfig& slave : config->slaves) check.slaves.push_back(slave.name);
    add_semantic_findings(found, *config, *locations);
  } else {
    add_reader_error(check, found, config.error());
  }
  put_by_line(check, found);
  return check;
}

std::vector<Finding> findings_of_export(const EniCheck& check) {
  auto findings = check.findings;
  for (Finding& finding : findings) {
    if (finding.place.key.empty())
      finding.place.key = setting_at(find_finding_words(finding.code)->setting, finding.place.slave);
  }
  return findings;
}

std::vector<Finding> errors_of_export(const EniCheck& check) {
  auto findings = findings_of_export(check);
  std::erase_if(findings, [](const Finding& finding) { return finding.severity != Severity::kError; });
  return findings;
}

std::vector<Finding> errors_of_export(std::string_view text) {
  const auto check = check_eni_text(text, "ENI");
  return check ? errors_of_export(*check) : std::vector{finding_of(check.error())};
}

Result<EniCheck> check_eni(const std::string& path) {
  const auto text = read_file(path);
  return text ? check_eni_text(*text, path) : fail(text.error());
}

}  // namespace syncline::eni
