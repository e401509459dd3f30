// SPDX-License-Identifier: Apache-2.0
// The rules of the structure against the schema itself: both refuse the same of a thousand damaged files.
#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include "eni/check/eni_check.h"
#include "eni/everything.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_style.h"
#include "eni/schema_check.h"

namespace syncline::eni {
namespace {

namespace fs = std::filesystem;
using Element = tinyxml2::XMLElement;

/// By the names that lead there, without those that are there several times.
std::string path_of(const Element& element) {
  const auto* parent = element.Parent() != nullptr ? element.Parent()->ToElement() : nullptr;
  return (parent != nullptr ? path_of(*parent) + "/" : "") + element.Name();
}

/// The first element of each path, below the root.
std::vector<Element*> first_of_each(tinyxml2::XMLDocument& document) {
  std::vector<Element*> found;
  std::set<std::string> paths;
  const std::function<void(Element&)> visit = [&](Element& element) {
    if (&element != document.RootElement() && paths.insert(path_of(element)).second) found.push_back(&element);
    for (auto* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) visit(*e);
  };
  visit(*document.RootElement());
  return found;
}

struct Damage {
  const char* name;
  /// False: there is nothing to damage so.
  bool (*apply)(Element& element);
};

constexpr Damage kDamages[] = {
    {"twice",
     [](Element& element) {
       element.Parent()->InsertAfterChild(&element, element.DeepClone(element.GetDocument()));
       return true;
     }},
    {"missing",
     [](Element& element) {
       element.Parent()->DeleteChild(&element);
       return true;
     }},
    {"first",
     [](Element& element) {
       if (element.PreviousSiblingElement() == nullptr) return false;
       element.Parent()->InsertFirstChild(&element);
       return true;
     }},
    {"last",
     [](Element& element) {
       if (element.NextSiblingElement() == nullptr) return false;
       element.Parent()->InsertEndChild(&element);
       return true;
     }},
    {"another value",
     [](Element& element) {
       if (element.FirstChildElement() != nullptr) return false;
       element.SetText("-70000.5e");
       return true;
     }},
    {"without value",
     [](Element& element) {
       if (element.FirstChildElement() != nullptr) return false;
       element.DeleteChildren();
       return true;
     }},
    {"without its attributes",
     [](Element& element) {
       if (element.FirstAttribute() == nullptr) return false;
       while (const auto* attribute = element.FirstAttribute()) element.DeleteAttribute(attribute->Name());
       return true;
     }},
    {"with other attributes",
     [](Element& element) {
       const auto* attribute = element.FirstAttribute();
       if (attribute == nullptr) return false;
       for (; attribute != nullptr; attribute = attribute->Next()) element.SetAttribute(attribute->Name(), "-70000.5e");
       return true;
     }},
};

struct Damaged {
  std::string what, text;
};

std::vector<Damaged> damaged(const std::string& text) {
  std::vector<Damaged> all;
  const auto count = [&] {
    tinyxml2::XMLDocument document;
    document.Parse(text.data(), text.size());
    return first_of_each(document).size();
  }();
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& damage : kDamages) {
      tinyxml2::XMLDocument document;
      document.Parse(text.data(), text.size());
      auto& element = *first_of_each(document)[i];
      const auto what = path_of(element) + " " + damage.name;
      if (!damage.apply(element)) continue;
      tinyxml2::XMLPrinter printer;
      document.Print(&printer);
      all.push_back({what, printer.CStr()});
    }
  }
  return all;
}

/// Of each file, whether it is valid, from one run of xmllint.
std::vector<bool> schema_accepts(const std::vector<Damaged>& files, const std::string& schema) {
  const auto folder = fs::temp_directory_path() / ("syncline-structure-" + std::to_string(::getpid()));
  fs::create_directory(folder);
  std::string command = "cd '" + folder.string() + "' && xmllint --noout --nonet --schema '" + schema + "'";
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::ofstream(folder / std::to_string(i), std::ios::binary) << files[i].text;
    command += " " + std::to_string(i);
  }
  std::vector<bool> valid(files.size());
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string said;
  for (int c; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) {
    if (c != '\n') {
      said += static_cast<char>(c);
      continue;
    }
    if (said.ends_with(" validates")) valid[std::stoul(said)] = true;
    said.clear();
  }
  if (pipe != nullptr) ::pclose(pipe);
  fs::remove_all(folder);
  return valid;
}

/// What the schema does not know is a note, and no error of the structure.
bool check_accepts(const std::string& text) {
  const auto check = check_eni_text(text, "damaged.xml");
  if (!check) return false;
  return std::ranges::none_of(check->findings, [](const Finding& finding) {
    return finding.code.starts_with("ENI-XML-") && finding.code != "ENI-XML-04";
  });
}

bool is_one_of(std::string_view what, std::initializer_list<std::string_view> ends) {
  return std::ranges::any_of(ends, [&](std::string_view end) { return what.ends_with(end); });
}

/// Where the check and the published schema differ, and why. The schema takes any text for all of these.
bool is_stricter_on_purpose(std::string_view what) {
  return is_one_of(what, {"/Master/Info/Destination without value", "/Master/Info/Source without value",  // six bytes
                          "/BitLength another value", "/BitLength without value",                         // numbers
                          "/ProfileNo another value", "/ProfileNo without value",                         //
                          "/AddInfo another value", "/AddInfo without value",                             //
                          "/PreviousPort with other attributes", "/EoE with other attributes"});          // booleans
}
bool is_milder_on_purpose(std::string_view what) {
  // Others leave out the first three; what is in a profile is not used.
  return is_one_of(what, {"/Slave/Info/PhysAddr missing", "/Slave/Info/AutoIncAddr missing",
                          "/Slave/Info/Physics missing", "/Profile/ChannelInfo missing"}) ||
         (what.find("/Profile/ChannelInfo/") != std::string_view::npos &&
          is_one_of(what, {" twice", " missing", " first", " last"}));
}

class Structure : public testing::TestWithParam<Schema> {};
INSTANTIATE_TEST_SUITE_P(Schemas, Structure, testing::Values(eni_schemas().back()), SchemaName());

/// Ours, of what we write, refuses what the published one lets others write; it serves where that is not here.
TEST_P(Structure, RefusesWhatTheSchemaRefuses) {
  if (!have_xmllint()) GTEST_SKIP() << "xmllint is not installed";
  const auto files = damaged(write_eni(everything(), style_of(EniDialect::kEcEngineer)));
  EXPECT_GT(files.size(), 1'000U);
  const auto valid = schema_accepts(files, GetParam().path);
  EXPECT_GT(std::ranges::count(valid, true), 100);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool accepted = check_accepts(files[i].text);
    const bool stricter = !accepted && valid[i], milder = accepted && !valid[i] && !GetParam().own;
    EXPECT_TRUE(!stricter || is_stricter_on_purpose(files[i].what)) << "refused is " << files[i].what;
    EXPECT_TRUE(!milder || is_milder_on_purpose(files[i].what)) << "accepted is " << files[i].what;
  }
}

}  // namespace
}  // namespace syncline::eni
