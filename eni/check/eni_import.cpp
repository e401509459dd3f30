// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "eni/check/eni_structure.h"
#include "eni/format/eni_end_cap.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_reader.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_text.h"
#include "findings/finding_list.h"
#include "findings/recovered_words.h"
#include "findings/sentence.h"

namespace syncline::eni {
namespace {

using Element = tinyxml2::XMLElement;

/// Elements that the schema knows and the reader leaves out: makers' own, and texts for people.
constexpr std::string_view kLeftOut[] = {"Manufacturer", "VendorSpecific", "DisplayName"};

struct Count {
  std::size_t times = 0;
  int line = 0;
};

struct Part {
  std::string name, parent;
  auto operator<=>(const Part&) const = default;
};

/// Of so many kinds as are listed; the others are `unlisted`.
void count_left_out(const Element& parent, XmlPieces& pieces, std::map<Part, Count>& counts, std::size_t& unlisted) {
  for (const auto* e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const std::string_view name = e->Name();
    if (std::ranges::find(kLeftOut, name) == std::end(kLeftOut)) {
      if (const Element* whole = pieces.whole(*e)) count_left_out(*whole, pieces, counts, unlisted);
      continue;
    }
    Part part{std::string(name), parent.Name()};
    if (counts.size() == FindingList::kMostOfRule && !counts.contains(part)) {
      ++unlisted;
      continue;
    }
    Count& count = counts[std::move(part)];
    if (count.times++ == 0) count.line = line_of(*e);
  }
}

std::vector<Finding> unread_parts(XmlPieces& pieces) {
  const Element& root = *pieces.root();
  FindingList out;
  std::set<std::string> told;
  const auto add = [&](std::string what, int line) {
    Place place;
    place.line = line;
    out.add(make_finding<words::kRecovered, "line", "what">(
        "eni-part-unread", std::move(place), fig::number<"line">(line), fig::text<"what">(std::move(what))));
  };
  FindingList structure;
  check_structure(pieces, structure);
  for (const Finding& finding : structure.kept()) {
    if (finding.code == "ENI-XML-11") out.add(finding);  // names and comments may have come as others
    if (finding.code != "ENI-XML-04") continue;
    told.insert(finding.figures[0].text + '\n' + finding.figures[1].text);
    add(facts_text(finding), finding.place.line);
  }
  std::map<Part, Count> counts;
  std::size_t unlisted = 0;
  count_left_out(root, pieces, counts, unlisted);
  for (const auto& [part, count] : counts) {
    if (told.contains(part.name + '\n' + part.parent)) continue;
    const auto what = fmt::format("<{}> in <{}>", part.name, part.parent);
    add(count.times > 1 ? fmt::format("{}, {} times", what, count.times) : what, count.line);
  }
  const Element* config = root.FirstChildElement("Config");
  const Element* slave = config != nullptr ? config->FirstChildElement("Slave") : nullptr;
  for (; slave != nullptr; slave = slave->NextSiblingElement("Slave")) {
    const Element* whole = pieces.whole(*slave);
    if (whole == nullptr || !is_end_cap(*whole)) continue;
    const int line = line_of(*slave);
    Place place;
    place.line = line;
    out.add(make_finding<words::kRecovered, "line">("eni-part-unread/end-cap", std::move(place),
                                                    fig::number<"line">(line)));
  }
  // ENI-XML-04 is the one note among the rules of the structure.
  out.leave_out(*find_finding_words("eni-part-unread"), structure.left_out()[Severity::kNote] + unlisted);
  auto rest = out.rest();
  auto unread = out.take_kept();
  if (rest) unread.push_back(std::move(*rest));
  return unread;
}

}  // namespace

Result<EniImport> import_eni_text(std::string_view text, const std::string& file_name) {
  std::vector<Finding> unread;
  {  // gone before the configuration comes, which takes several times the file's size
    auto pieces = XmlPieces::parse(text, file_name, is_eni_piece);
    if (!pieces) return tl::unexpected(pieces.error());
    unread = unread_parts(*pieces);
  }
  auto config = parse_eni(text, file_name);
  if (!config) return tl::unexpected(config.error());
  return EniImport{std::move(*config), std::move(unread)};
}

Result<EniImport> import_eni(const std::string& path) {
  const auto text = read_file(path);
  return text ? import_eni_text(*text, path) : tl::unexpected(text.error());
}

}  // namespace syncline::eni
