// SPDX-License-Identifier: Apache-2.0
// What is tolerated in ESI files, word by word: command line and JSON say it in English, programs may look for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "eni/catalogue/esi_cards.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_reader.h"
#include "reasons/reason_words.h"
#include "sqlite/sqlite_database.h"
#include "tests/support/sloppy_esi.h"
#include "tests/support/temporary_folder.h"

namespace syncline::eni {
namespace {

using testing::ElementsAreArray;

std::vector<std::string> lines_of(const FileWarnings& warnings, const std::string& folder = {}) {
  std::vector<std::string> lines;
  for (const auto& warning : warnings) {
    auto line = warning.file + "|" + std::to_string(warning.line) + "|" + warning.element + "|" + warning.reason.text();
    for (auto at = line.find(folder); !folder.empty() && at != std::string::npos; at = line.find(folder))
      line.erase(at, folder.size());
    lines.push_back(std::move(line));
  }
  return lines;
}

class EsiWarnings : public testing::Test {
 protected:
  EsiWarnings() {
    std::filesystem::create_directory(esi());
    for (const auto& [name, text] : sample::sloppy_esi_files()) std::ofstream(esi() + name) << text;
  }
  [[nodiscard]] std::string esi() const { return folder_.file("esi/"); }
  [[nodiscard]] std::string database() const { return folder_.file("esi-catalogue.sqlite"); }
  [[nodiscard]] FileWarnings read(const char* name) const {
    const auto file = read_esi(esi() + name);
    EXPECT_TRUE(file) << name;
    return file ? file->warnings : FileWarnings{};
  }

 private:
  test::TemporaryFolder folder_;
};

constexpr const char* kOfDevice[] = {
    R"(sloppy.xml|1|?xml|the text is not UTF-8, though it should be; read as ISO-8859-1 (windows-1252))",
    R"(sloppy.xml|2|InfoReference|the file is left out: The file nowhere.xml does not exist. Check its name and folder.)",
    R"(sloppy.xml|4|Type|the rule "YY" for CheckProductCode is not known)",
    R"(sloppy.xml|4|Type|the rule "XX" for CheckRevisionNo is not known)",
    R"(sloppy.xml|5|HideType|ProductCode "#x1FFFFFFFF" is no number of 32 bits and is left out)",
    R"(sloppy.xml|15|ImageData16x14|the picture is no hexadecimal data and is left out)",
    R"(sloppy.xml|6|Fmmu|the use "ZZ1" is not known; the FMMU counts as free)",
    R"(sloppy.xml|7|Sm|hexadecimal numbers of this file begin with 0x instead of #x)",
    R"(sloppy.xml|7|Sm|the use "ZZ2" is not known; taken from the control byte 0x24)",
    R"(sloppy.xml|8|Index|"x1600" is read as 5632)",
    R"(sloppy.xml|9|Entry|BitLen is missing; 16 bits by the data type UINT)",
    R"(sloppy.xml|8|RxPdo|the PDO 0x1600 excludes itself; that is left out)",
    R"(sloppy.xml|11|Transition|"ps" is read as PS)",
    R"(sloppy.xml|12|InitCmd|Transition is missing; taken for PS)",
    R"(sloppy.xml|12|Data|"1" has an odd number of digits; a zero is put in front)",
    R"(sloppy.xml|13|OpMode|Name is missing; taken from Desc)",
    R"(sloppy.xml|16|DictionaryFile|the dictionary is left out: The file absent.xml does not exist. Check its name and )"
    R"(folder.)",
    R"(sloppy.xml|17|DictionaryFile|"modules.xml" is no dictionary file: its root is <EtherCATModule>, not )"
    R"(<EtherCATDict>)",
    R"(sloppy.xml|19|Enum|the data type is left out: sloppy.xml:19: the element <Enum> is missing: in <EnumInfo>.)",
    R"(sloppy.xml|21|Index|the object is left out: sloppy.xml:21: the value of <Index> cannot be used: "9z" is no )"
    R"(number.)",
    R"(sloppy.xml|20|BitSize|sloppy.xml:20: the value of <BitSize> cannot be used: "9b" is no number.)",
    R"(sloppy.xml|14|Slot|MaxInstances is missing; taken for 1)",
    R"(sloppy.xml|14|Slots|no file describes the module 0x00000055 of the slot "S1")",
};
constexpr const char* kOfBroken[] = {
    R"(broken.xml|6|Type|the module is left out: broken.xml:6: the value of <Type> cannot be used: the attribute )"
    R"(ModuleIdent is missing.)",
    R"(broken.xml|3|Type@ProductCode|Device GAMMA is left out: broken.xml:3: the value of <Type@ProductCode> cannot be )"
    R"(used: "1k" is no number.)",
    R"(broken.xml|4|Type|Device is left out: broken.xml:4: the element <Type> is missing: in <Device>.)",
    R"(broken.xml|5|Sm@DefaultSize|Device DELTA is left out: broken.xml:5: the value of <Sm@DefaultSize> cannot be used: )"
    R"("-1" is out of range.)",
};
constexpr const char* kOfIndex[] = {
    R"(broken.xml|3|Type@ProductCode|Device GAMMA is left out: broken.xml:3: the value of <Type@ProductCode> cannot be )"
    R"(used: "1k" is no number.)",
    R"(broken.xml|4|Type|Device  is left out: broken.xml:4: the element <Type> is missing: in <Device>.)",
    R"(cut.xml|2|Vendor|cut.xml:2: this is not well-formed XML: an end tag does not match its start tag (<Vendor>).)",
    R"(other.xml|1|EtherCATConfig|other.xml:1: this is another kind of file; expected: an ESI file with the root )"
    R"(<EtherCATInfo>, not <EtherCATConfig>.)",
    R"(sloppy.xml|1|?xml|the text is not UTF-8, though it should be; read as ISO-8859-1 (windows-1252))",
};

TEST_F(EsiWarnings, SayTheirEnglishWordByWord) {
  EXPECT_THAT(lines_of(read("sloppy.xml"), esi()), ElementsAreArray(kOfDevice));
  EXPECT_THAT(lines_of(read("broken.xml"), esi()), ElementsAreArray(kOfBroken));
  EXPECT_EQ(lines_of(read("endless.xml"), esi()),
            std::vector<std::string>{"endless.xml|5|Object|the dictionary has too many entries; the rest is left out"});
  const auto alone = parse_esi(sample::sloppy_device(), "text.xml");
  ASSERT_TRUE(alone);
  EXPECT_EQ(lines_of(alone->warnings).at(1),
            R"(text.xml|2|InfoReference|"nowhere.xml" is another file, which is not read here)");
  EXPECT_EQ(lines_of(alone->warnings).at(16),
            R"(text.xml|16|DictionaryFile|the dictionary "absent.xml" is in another file, which is not read here)");
}

void collect_rows(const Reason& reason, std::vector<std::string_view>& rows) {
  if (std::ranges::find(words::kEsiReasons, reason.words()) != std::end(words::kEsiReasons))
    rows.push_back(*std::ranges::find(words::kEsiReasons, reason.words()));
  for (const Reason& one : reason.given()) collect_rows(one, rows);
}

/// So that a new kind gets a line above.
TEST_F(EsiWarnings, AreOfEachKindInTheseFiles) {
  std::vector<std::string_view> rows;
  const auto add = [&](const FileWarnings& warnings) {
    for (const auto& warning : warnings) collect_rows(warning.reason, rows);
  };
  for (const char* name : {"sloppy.xml", "broken.xml", "endless.xml"}) add(read(name));
  add(parse_esi(sample::sloppy_device(), "text.xml")->warnings);
  // What a text says of its encoding that is not so; see text_encoding_test.cpp.
  for (const char* text : {"gb2312\"?><!-- f\xFCr -->", "iso-8859-1\"?><!-- \xCB\xC5\xB7\xFE\xC7\xFD\xB6\xAF -->",
                           "iso-8859-1\"?><!-- \x81 -->"}) {
    const auto esi = std::string("<?xml version=\"1.0\" encoding=\"") + text +
                     "<EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions/></EtherCATInfo>";
    const auto file = parse_esi(esi, "text.xml");
    ASSERT_TRUE(file) << describe(file.error());
    add(file->warnings);
    const auto cards = read_cards(esi, "text.xml");
    ASSERT_TRUE(cards) << describe(cards.error());
    ASSERT_FALSE(cards->warnings.empty()) << "the catalogue tells it, too";
    EXPECT_EQ(cards->warnings.front(), file->warnings.front());
  }
  constexpr std::size_t kOfTheIndex = 4;  // those of the database itself, which other tests have
  for (std::size_t i = 0; i + kOfTheIndex < std::size(words::kEsiReasons); ++i)
    EXPECT_NE(std::ranges::find(rows, words::kEsiReasons[i]), rows.end()) << words::kEsiReasons[i];
}

TEST_F(EsiWarnings, OfTheIndexAreKeptWithTheirWords) {
  FileWarnings first;
  {
    auto catalogue = EsiCatalogue::open(database());
    ASSERT_TRUE(catalogue);
    ASSERT_TRUE(catalogue->add_folder(esi()));
    first = catalogue->warnings();
  }
  const auto folder = std::filesystem::canonical(esi()).string() + "/";
  EXPECT_THAT(lines_of(first, folder), ElementsAreArray(kOfIndex));
  EXPECT_EQ(first[0].reason.words(), "Device {device} is left out: {error}");
  ASSERT_EQ(first[0].reason.given().size(), 2U);
  EXPECT_EQ(first[0].reason.given()[1].words(), "{where}: the value of <{subject}> cannot be used{because}.");
  auto again = EsiCatalogue::open(database());
  ASSERT_TRUE(again);
  const auto report = again->add_folder(esi());
  ASSERT_TRUE(report);
  EXPECT_EQ(report->read, 0U) << "from the database";
  EXPECT_EQ(again->warnings(), first);
}

TEST_F(EsiWarnings, OfADatabaseOfTheVersionBeforeComeBackWithTheFoldersThatItRemembered) {
  {
    auto catalogue = EsiCatalogue::open(database());
    ASSERT_TRUE(catalogue && catalogue->add_folder(esi()) && catalogue->remember_folder(esi()));
  }
  ASSERT_TRUE(SqlDatabase::open(database())
                  ->execute("ALTER TABLE problems DROP COLUMN words; UPDATE problems SET text = 'of before'; "
                            "PRAGMA user_version=4"));
  auto catalogue = EsiCatalogue::open(database());
  ASSERT_TRUE(catalogue);
  const auto folders = catalogue->known_folders();
  ASSERT_TRUE(folders);
  ASSERT_EQ(folders->size(), 1U);
  ASSERT_TRUE(catalogue->add_folder(folders->front()));
  auto warnings = catalogue->warnings();
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.front().reason.text(),
            "the device catalogue is made again: it is of version 4, this program uses version 5");
  warnings.erase(warnings.begin());
  EXPECT_THAT(lines_of(warnings, std::filesystem::canonical(esi()).string() + "/"), ElementsAreArray(kOfIndex));
}

}  // namespace
}  // namespace syncline::eni
