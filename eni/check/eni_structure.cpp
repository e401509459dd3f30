// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "eni/check/eni_schema.h"
#include "eni/check/eni_value_check.h"
#include "eni/format/eni_end_cap.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"

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

class StructureCheck {
 public:
  explicit StructureCheck(std::vector<EniFinding>& out) : out_(out) {}

  void run(const Element& root) {
    const Step step{nullptr, &root, 0};
    if (std::string_view(root.Name()) != "EtherCATConfig") {
      add("ENI-XML-09", step, fmt::format("the root element is {}", root.Name()));
    }
    const EniChild* config = eni_schema().child("Config");
    slave_child_ = config != nullptr && config->type != nullptr ? config->type->child("Slave") : nullptr;
    check_type(step, eni_schema());
    report_unknown();
  }

 private:
  void add(std::string_view code, const Step& step, std::string what, int line = 0) {
    EniFinding finding;
    finding.code = code;
    finding.line = line ? line : step.element->GetLineNum();
    finding.path = path_text(&step);
    finding.what = std::move(what);
    for (const Step* s = &step; s != nullptr; s = s->parent) {
      if (s->index != 0 && std::string_view(s->element->Name()) == "Slave")
        finding.slave = static_cast<int>(s->index) - 1;
    }
    out_.push_back(std::move(finding));
  }

  void check_type(const Step& step, const EniType& type) {
    check_attributes(step, type);
    std::vector<std::size_t> counts(type.children.size(), 0);
    int reached = 0;
    bool said = false;
    for (const auto* e = step.element->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const EniChild* child = type.child(e->Name());
      if (child == nullptr) {
        unknown(step, fmt::format("<{}> in <{}>", e->Name(), step.element->Name()), *e);
        continue;
      }
      std::size_t& count = counts[static_cast<std::size_t>(child - type.children.data())];
      const Step inner{&step, e, child->at_most == 1 ? 0 : ++count};
      if (child->at_most == 1) ++count;
      if (child->at_most != 0 && count > child->at_most) {
        add("ENI-XML-07", inner,
            fmt::format("<{}> stands {} times in <{}>, allowed are {}", child->name, count, step.element->Name(),
                        child->at_most));
      }
      if (child->order < reached && !said) {
        said = true;
        add("ENI-XML-03", inner,
            fmt::format("<{}> stands behind elements of <{}> that it has to precede", child->name,
                        step.element->Name()));
      }
      reached = std::max<int>(reached, child->order);
      check_child(inner, *child);
    }
    check_counts(step, type, counts);
  }

  void check_child(const Step& step, const EniChild& child) {
    if (&child == slave_child_ && is_end_cap(*step.element)) return;  // nobody sets it up
    if (child.type != nullptr) return check_type(step, *child.type);
    if (child.value == EniValue::kText || child.value == EniValue::kAnything) return;
    const std::string text = text_of(*step.element);
    const ValueVerdict verdict = check_value(child.value, text);
    if (verdict == ValueVerdict::kRight) return;
    add(verdict == ValueVerdict::kWrong ? "ENI-XML-05" : "ENI-XML-06", step,
        fmt::format("<{}> is \"{}\" instead of {}", child.name, shown(text), value_words(child.value)));
  }

  void check_counts(const Step& step, const EniType& type, const std::vector<std::size_t>& counts) {
    const auto there = [&](const char* name) {
      const EniChild* child = type.child(name);
      return child != nullptr && counts[static_cast<std::size_t>(child - type.children.data())] > 0;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] < type.children[i].at_least) {
        add("ENI-XML-02", step, fmt::format("<{}> has no <{}>", step.element->Name(), type.children[i].name));
      }
    }
    for (const EniChoice& choice : type.choices) {
      const bool one = there(choice.one);
      const bool other = there(choice.other);
      if (one && other) {
        add("ENI-XML-08", step,
            fmt::format("<{}> has both <{}> and <{}>", step.element->Name(), choice.one, choice.other));
      } else if (choice.required && !one && !other) {
        add("ENI-XML-02", step,
            fmt::format("<{}> has neither <{}> nor <{}>", step.element->Name(), choice.one, choice.other));
      }
    }
  }

  void check_attributes(const Step& step, const EniType& type) {
    for (const auto* a = step.element->FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      if (name.starts_with("xmlns") || name.starts_with("xsi:") || name.starts_with("xml:")) continue;
      const EniAttribute* known = type.attribute(name);
      if (known == nullptr) {
        unknown(step, fmt::format("attribute {} of <{}>", name, step.element->Name()), *step.element);
      } else if (const auto verdict = check_value(known->value, a->Value()); verdict != ValueVerdict::kRight) {
        add(verdict == ValueVerdict::kWrong ? "ENI-XML-05" : "ENI-XML-06", step,
            fmt::format("attribute {} is \"{}\" instead of {}", name, shown(a->Value()), value_words(known->value)));
      }
    }
    for (const EniAttribute& attribute : type.attributes) {
      if (attribute.required && step.element->Attribute(attribute.name) == nullptr) {
        add("ENI-XML-02", step, fmt::format("<{}> has no attribute {}", step.element->Name(), attribute.name));
      }
    }
  }

  /// Extensions come by the hundred: each kind is told once, where it comes first.
  void unknown(const Step& step, const std::string& what, const Element& element) {
    Unknown& entry = unknown_[what];
    if (entry.count++ == 0) {
      add("ENI-XML-04", step, what, element.GetLineNum());
      entry.finding = out_.size() - 1;
    }
  }

  void report_unknown() {
    for (const auto& [what, entry] : unknown_) {
      if (entry.count > 1) out_[entry.finding].what = fmt::format("{}, {} times", what, entry.count);
    }
  }

  struct Unknown {
    std::size_t count = 0, finding = 0;
  };
  std::vector<EniFinding>& out_;
  const EniChild* slave_child_ = nullptr;
  std::map<std::string, Unknown> unknown_;
};

std::int64_t number_in(const Element* element) { return element ? parse_number(text_of(*element)).value_or(-1) : -1; }

/// Previous ports name station addresses of the file.
void check_previous_ports(const Element& config, std::vector<EniFinding>& out) {
  std::unordered_set<std::int64_t> addresses;
  std::size_t count = 0;
  for (const auto* s = first_slave(config); s != nullptr; s = next_slave(*s), ++count) {
    const Element* info = s->FirstChildElement("Info");
    const Element* address = info ? info->FirstChildElement("PhysAddr") : nullptr;
    // Without an address a slave gets the one that tools count from 1001 on.
    addresses.insert(address ? number_in(address) : 1001 + static_cast<std::int64_t>(count));
  }
  std::size_t position = 0;
  for (const auto* s = first_slave(config); s != nullptr; s = next_slave(*s), ++position) {
    std::size_t index = 0;
    for (const auto* p = s->FirstChildElement("PreviousPort"); p != nullptr;
         p = p->NextSiblingElement("PreviousPort")) {
      ++index;
      const Element* address = p->FirstChildElement("PhysAddr");
      if (address == nullptr || addresses.contains(number_in(address))) continue;
      EniFinding finding;
      finding.code = "ENI-REF-01";
      finding.line = address->GetLineNum();
      finding.path =
          fmt::format("/{}/Config/Slave[{}]/PreviousPort[{}]", config.Parent()->Value(), position + 1, index);
      finding.slave = static_cast<int>(position);
      finding.what = fmt::format("no slave has the station address {}", shown(text_of(*address)));
      out.push_back(std::move(finding));
    }
  }
}

}  // namespace

std::vector<EniFinding> check_structure(const Element& root) {
  std::vector<EniFinding> out;
  StructureCheck(out).run(root);
  if (const Element* config = root.FirstChildElement("Config")) {
    check_previous_ports(*config, out);
  }
  return out;
}

}  // namespace syncline::eni
