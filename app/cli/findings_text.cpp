// SPDX-License-Identifier: Apache-2.0
#include "app/cli/findings_text.h"

#include <fmt/format.h>

#include "app/cli/milliseconds.h"
#include "findings/fold.h"

namespace syncline::cli {
namespace {

Json figure_json(const Figure& figure) {
  using Unit = Figure::Unit;
  switch (figure.unit) {
    case Unit::kCount:
    case Unit::kTimes:
    case Unit::kNanoseconds:
    case Unit::kTime:
    case Unit::kSlave:
    case Unit::kNumber:
      return figure.value;
    case Unit::kMoment:
      return milliseconds(figure.value);
    case Unit::kPpm:
      return static_cast<double>(figure.value) / 1000;
    case Unit::kPort:
    case Unit::kHex16:
    case Unit::kHex32:
    case Unit::kHex:
    case Unit::kSlaves:
    case Unit::kAlStatus:
    case Unit::kAlCode:
    case Unit::kText:
    case Unit::kPhrase:
    case Unit::kAside:
      return figure_text(figure);
  }
  return nullptr;
}

/// The name says the unit.
std::string figure_key(const Figure& figure) {
  switch (figure.unit) {
    case Figure::Unit::kNanoseconds:
    case Figure::Unit::kTime:
      return std::string(figure.name) + "_ns";
    case Figure::Unit::kMoment:
      return std::string(figure.name) + "_ms";
    case Figure::Unit::kPpm:
      return std::string(figure.name) + "_ppm";
    default:
      return std::string(figure.name);
  }
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

}  // namespace

Json figures_json(const Finding& finding) {
  Json figures = Json::object();
  for (const auto& figure : finding.figures) figures[figure_key(figure)] = figure_json(figure);
  return figures;
}

Json place_json(const Place& place) {
  return {{"slave", place.slave < 0 ? Json(nullptr) : Json(place.slave)},
          {"key", text_or_null(place.key)},
          {"line", place.line > 0 ? Json(place.line) : Json(nullptr)},
          {"path", text_or_null(place.path)}};
}

Json to_json(const Finding& finding) {
  return {{"severity", severity_name(finding.severity)},
          {"slave", finding.place.slave},
          {"key", finding.place.key},
          {"text", describe(finding)},
          {"code", finding.code},
          {"place", place_json(finding.place)},
          {"evidence", figures_json(finding)}};
}

Json to_json(const std::vector<Finding>& findings) {
  Json rows = Json::array();
  for (const auto& finding : findings) rows.push_back(to_json(finding));
  return rows;
}

void print(std::ostream& out, const std::vector<Finding>& findings) {
  for (const auto& [finding, slaves] : folded(findings)) {
    const auto& place = finding.place;
    const auto where = place.slave < 0     ? std::string("master")
                       : slaves.size() > 1 ? "slaves " + ranges_text(slaves)
                                           : fmt::format("slave {}", place.slave);
    auto key = place.key;
    const auto own = fmt::format("slave.{}.", place.slave);
    if (slaves.size() > 1 && key.starts_with(own)) key = "slave.N." + key.substr(own.size());
    out << fmt::format("{}: {}: {}{}\n", severity_name(finding.severity), where, describe(finding),
                       key.empty() ? "" : " [" + key + "]");
  }
}

}  // namespace syncline::cli
