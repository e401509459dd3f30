// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "eni/check/eni_schema.h"
#include "eni/check/eni_value_check.h"
#include "eni/format/eni_end_cap.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "findings/eni_structure_words.h"
#include "findings/finding_list.h"
#include "findings/sentence.h"
#include "protocol/station_address.h"

namespace syncline::eni {
namespace {

using Element = tinyxml2::XMLElement;

std::string text_of(const Element& element) {
  Reading ignored("");
  return Node(&element, ignored).text();
}

std::string shown(std::string_view text) {
  constexpr std::size_t kShown = 40;
  text = trim(text);
  return text.size() > kShown ? fmt::format("{}...", text.substr(0, kShown)) : std::string(text);
}

/// Way from the root to an element; words are made of it only for a finding.
struct Step {
  const Step* parent = nullptr;
  const Element* element = nullptr;
  std::size_t index = 0;  // among elements of that name, from 1; 0 = it stands alone
};

std::string path_text(const Step* step) {
  std::string path;
  for (; step != nullptr; step = step->parent) {
    const std::string index = step->index ? fmt::format("[{}]", step->index) : "";
    path = fmt::format("/{}{}{}", step->element->Name(), index, path);
  }
  return path;
}

template <FigureName... kNames>
using Sentence = std::type_identity_t<FindingSentence<words::kEniStructure, kNames...>>;

/// Previous ports name station addresses of the file.
class PreviousPorts {
 public:
  void add(const Element& slave);
  void check(std::string_view root, FindingList& out) const;

 private:
  struct Told {
    std::size_t slave = 0, index = 0;  // of the slaves that are no end caps, from 0; of its previous ports, from 1
    int line = 0;
    std::string address;
  };
  std::unordered_set<std::int64_t> addresses_;
  std::vector<Told> told_;
  std::size_t slaves_ = 0;
};

class StructureCheck {
 public:
  StructureCheck(XmlPieces& pieces, FindingList& out) : pieces_(pieces), out_(out) {}

  void run() {
    const Element& root = *pieces_.root();
    const Step step{nullptr, &root, 0};
    if (std::string_view(root.Name()) != "EtherCATConfig") {
      add("ENI-XML-09", step, element(root.Name()));
    }
    const EniChild* config = eni_schema().child("Config");
    slave_child_ = config != nullptr && config->type != nullptr ? config->type->child("Slave") : nullptr;
    check_type(step, eni_schema());
    report_unknown();
    ports_.check(root.Name(), out_);
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<kNames...> code, const Step& step, Named<kNames>... figures) {
    if (!out_.has_room(code.words().code)) return out_.leave_out(code.words());
    out_.add(make_finding<words::kEniStructure, kNames...>(code, place_of(step), std::move(figures)...));
  }
  static Place place_of(const Step& step) {
    Place place;
    place.line = line_of(*step.element);
    place.path = path_text(&step);
    for (const Step* s = &step; s != nullptr; s = s->parent) {
      if (s->index != 0 && std::string_view(s->element->Name()) == "Slave")
        place.slave = static_cast<int>(s->index) - 1;
    }
    return place;
  }

  void check_type(const Step& step, const EniType& type) {
    check_attributes(step, type);
    std::vector<std::size_t> counts(type.children.size(), 0);
    int reached = 0;
    bool said = false;
    for (const auto* e = step.element->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const EniChild* child = type.child(e->Name());
      if (child == nullptr) {
        unknown(step, e->Name(), false, *e);
        continue;
      }
      std::size_t& count = counts[static_cast<std::size_t>(child - type.children.data())];
      const Step inner{&step, e, child->at_most == 1 ? 0 : ++count};
      if (child->at_most == 1) ++count;
      if (child->at_most != 0 && count > child->at_most) {
        add("ENI-XML-07", inner, element(child->name), fig::count<"count">(count), parent(step),
            fig::count<"most">(child->at_most));
      }
      if (child->order < reached && !said) {
        said = true;
        add("ENI-XML-03", inner, element(child->name), parent(step));
      }
      reached = std::max<int>(reached, child->order);
      check_child(inner, *child);
    }
    check_counts(step, type, counts);
  }

  void check_child(const Step& stub, const EniChild& child) {
    const Element* whole = pieces_.whole(*stub.element);
    if (whole == nullptr) return;
    const Step step{stub.parent, whole, stub.index};
    if (&child == slave_child_) {
      if (is_end_cap(*whole)) return;  // nobody sets it up
      ports_.add(*whole);
    }
    if (child.type != nullptr) return check_type(step, *child.type);
    if (child.value == EniValue::kText || child.value == EniValue::kAnything) return;
    const std::string text = text_of(*step.element);
    const ValueVerdict verdict = check_value(child.value, text);
    if (verdict == ValueVerdict::kRight) return;
    const auto value = fig::text<"value">(shown(text));
    const auto wanted = fig::phrase<"wanted">(value_words(child.value));
    verdict == ValueVerdict::kWrong ? add("ENI-XML-05", step, element(child.name), value, wanted)
                                    : add("ENI-XML-06", step, element(child.name), value, wanted);
  }

  void check_counts(const Step& step, const EniType& type, const std::vector<std::size_t>& counts) {
    const auto there = [&](const char* name) {
      const EniChild* child = type.child(name);
      return child != nullptr && counts[static_cast<std::size_t>(child - type.children.data())] > 0;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] < type.children[i].at_least) {
        add("ENI-XML-02", step, parent(step), element(type.children[i].name));
      }
    }
    for (const EniChoice& choice : type.choices) {
      const auto one_name = fig::text<"one">(choice.one);
      const auto other_name = fig::text<"other">(choice.other);
      const bool one = there(choice.one);
      const bool other = there(choice.other);
      if (one && other) {
        add("ENI-XML-08", step, parent(step), one_name, other_name);
      } else if (choice.required && !one && !other) {
        add("ENI-XML-02/choice", step, parent(step), one_name, other_name);
      }
    }
  }

  void check_attributes(const Step& step, const EniType& type) {
    for (const auto* a = step.element->FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      if (name.starts_with("xmlns") || name.starts_with("xsi:") || name.starts_with("xml:")) continue;
      const EniAttribute* known = type.attribute(name);
      if (known == nullptr) {
        unknown(step, a->Name(), true, *step.element);
      } else if (const auto verdict = check_value(known->value, a->Value()); verdict != ValueVerdict::kRight) {
        const auto value = fig::text<"value">(shown(a->Value()));
        const auto wanted = fig::phrase<"wanted">(value_words(known->value));
        verdict == ValueVerdict::kWrong ? add("ENI-XML-05/attribute", step, element(a->Name()), value, wanted)
                                        : add("ENI-XML-06/attribute", step, element(a->Name()), value, wanted);
      }
    }
    for (const EniAttribute& attribute : type.attributes) {
      if (attribute.required && step.element->Attribute(attribute.name) == nullptr) {
        add("ENI-XML-02/attribute", step, parent(step), fig::text<"attribute">(attribute.name));
      }
    }
  }

  /// Extensions come by the hundred: each kind is told once, where it comes first. Where no more kinds are listed, each
  /// of what comes counts as one.
  void unknown(const Step& step, const char* name, bool attribute, const Element& found) {
    Extension kind{name, step.element->Name(), attribute};
    if (const auto known = unknown_.find(kind); known != unknown_.end()) {
      ++known->second.count;
      return;
    }
    const bool listed = out_.has_room("ENI-XML-04");
    attribute ? add("ENI-XML-04/attribute", step, element(name), parent(step))
              : add("ENI-XML-04", step, element(name), parent(step));
    if (!listed) return;
    out_.last().place.line = line_of(found);
    unknown_.emplace(std::move(kind), Unknown{1, out_.kept().size() - 1});
  }

  void report_unknown() {
    for (const auto& [what, entry] : unknown_) {
      if (entry.count < 2) continue;
      Finding& first = out_[entry.finding];
      const auto name = element(what.name);
      const auto around = fig::text<"parent">(what.parent);
      const auto count = fig::count<"count">(entry.count);
      auto place = std::move(first.place);
      first =
          what.attribute
              ? make_finding<words::kEniStructure>("ENI-XML-04/attribute-often", std::move(place), name, around, count)
              : make_finding<words::kEniStructure>("ENI-XML-04/often", std::move(place), name, around, count);
    }
  }

  static Named<"element"> element(std::string name) { return fig::text<"element">(std::move(name)); }
  static Named<"parent"> parent(const Step& step) { return fig::text<"parent">(step.element->Name()); }

  struct Extension {
    std::string name, parent;
    bool attribute = false;
    auto operator<=>(const Extension&) const = default;
  };
  struct Unknown {
    std::size_t count = 0, finding = 0;
  };
  XmlPieces& pieces_;
  FindingList& out_;
  PreviousPorts ports_;
  const EniChild* slave_child_ = nullptr;
  std::map<Extension, Unknown> unknown_;
};

std::int64_t number_in(const Element* element) { return element ? parse_number(text_of(*element)).value_or(-1) : -1; }

void PreviousPorts::add(const Element& slave) {
  const Element* info = slave.FirstChildElement("Info");
  const Element* own = info ? info->FirstChildElement("PhysAddr") : nullptr;
  addresses_.insert(own ? number_in(own) : usual_station_address(slaves_));
  std::size_t index = 0;
  for (const auto* p = slave.FirstChildElement("PreviousPort"); p != nullptr;
       p = p->NextSiblingElement("PreviousPort")) {
    ++index;
    if (const Element* address = p->FirstChildElement("PhysAddr"))
      told_.push_back({slaves_, index, line_of(*address), text_of(*address)});
  }
  ++slaves_;
}

void PreviousPorts::check(std::string_view root, FindingList& out) const {
  for (const Told& told : told_) {
    if (addresses_.contains(parse_number(told.address).value_or(-1))) continue;
    Place place(static_cast<int>(told.slave));
    place.line = told.line;
    place.path = fmt::format("/{}/Config/Slave[{}]/PreviousPort[{}]", root, told.slave + 1, told.index);
    out.add(make_finding<words::kEniStructure, "address">("ENI-REF-01", std::move(place),
                                                          fig::text<"address">(shown(told.address))));
  }
}

Finding encoding_finding(const EncodingDoubt& doubt) {
  Place place;
  place.line = doubt.line;
  return make_finding<words::kEniStructure, "reason">("ENI-XML-11", std::move(place),
                                                      fig::reason<"reason">(doubt.reason));
}

}  // namespace

void check_structure(XmlPieces& pieces, FindingList& findings) {
  if (const auto& doubt = pieces.doubt()) findings.add(encoding_finding(*doubt));
  StructureCheck(pieces, findings).run();
}

}  // namespace syncline::eni
