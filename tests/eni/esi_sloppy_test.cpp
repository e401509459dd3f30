// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eni/esi/esi_reader.h"
#include "eni/xml/xml_number.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string sloppy(const std::string& devices, const std::string& outside = "") {
  return "<EtherCATInfo><Vendor><Id>2</Id><Name>M</Name></Vendor><Descriptions><Groups/><Devices>\n" + devices +
         "</Devices>" + outside + "</Descriptions></EtherCATInfo>";
}
std::string with_pdo(const std::string& pdo) {
  return sloppy("<Device><Type ProductCode=\"1\">A</Type>\n" + pdo + "</Device>");
}

TEST(SloppyNumbers, MeanOneNumberOrNone) {
  for (const char* text :
       {"x1A00", "#1A00", "1A00h", "16#1A00", "# x 1A00", "#x0x1A00", "&H1A00", "6656.0", " 0x1A00 "}) {
    EXPECT_EQ(parse_sloppy_number(text), 0x1A00) << text;
  }
  EXPECT_EQ(parse_sloppy_number("10 ms"), 10);
  for (const char* text : {"", "h", "#", "x", "1A00", "1.5", "10 apples", "--3", "#x", "x-1"}) {
    EXPECT_EQ(parse_sloppy_number(text), std::nullopt) << text;
  }
}

TEST(SloppyEsi, ClearMeaningIsTakenWithAWarningThatNamesElementAndLine) {
  const auto file =
      parse_esi(with_pdo("<RxPdo><Index>x1600</Index><Name>P</Name>\n<Entry><Index>#x0x7000</Index>"
                         "<SubIndex><!-- first -->1</SubIndex>\n<Name>E</Name><DataType>UINT</DataType></Entry></RxPdo>"
                         "\n<Mailbox><CoE><InitCmd><Index>#x8000</Index><Data>1</Data></InitCmd></CoE></Mailbox>"),
                "s.xml");
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1)) << file->warnings.front().reason.text();
  const auto& pdo = file->devices[0].rx_pdos[0];
  EXPECT_EQ(pdo.index, 0x1600);
  EXPECT_EQ(pdo.entries[0].index, 0x7000);
  EXPECT_EQ(pdo.entries[0].sub_index, 1) << "a comment inside a value is no part of it";
  EXPECT_EQ(pdo.entries[0].bit_length, 16) << "by the data type";
  EXPECT_EQ(file->devices[0].mailbox->coe->init_commands[0].data, std::vector<std::uint8_t>{0x01});
  ASSERT_THAT(file->warnings, SizeIs(5));
  EXPECT_EQ(file->warnings[0].line, 3);
  EXPECT_EQ(file->warnings[0].element, "Index");
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("\"x1600\" is read as 5632"));
  EXPECT_EQ(file->warnings[1].line, 4);
  EXPECT_THAT(file->warnings[2].reason.text(), HasSubstr("BitLen is missing"));
  EXPECT_THAT(file->warnings[3].reason.text(), HasSubstr("Transition is missing"));
  EXPECT_EQ(file->warnings[4].element, "Data");
}

TEST(SloppyEsi, OtherPrefixIsToldOnceAFile) {
  const auto file = parse_esi(sloppy("<Device><Type ProductCode=\"0x10\" RevisionNo=\"0x20\">A</Type></Device>\n"
                                     "<Device><Type ProductCode=\"0x11\">B</Type></Device>"),
                              "s.xml");
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(2));
  EXPECT_EQ(file->devices[0].identity.revision_no, 0x20U);
  ASSERT_THAT(file->warnings, SizeIs(1));
  EXPECT_EQ(file->warnings[0].line, 2);
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("0x instead of #x"));
}

TEST(SloppyEsi, EncodingThatIsNotWhatTheFileSaysIsAWarning) {
  const std::string latin = sloppy(
      "<Device><Type ProductCode=\"1\">A</Type><Name>Gr\xF6\xDF"
      "e</Name></Device>");
  const auto undeclared = parse_esi(latin, "s.xml");
  ASSERT_TRUE(undeclared);
  EXPECT_EQ(undeclared->devices.at(0).name, "Größe");
  ASSERT_THAT(undeclared->warnings, SizeIs(1));
  EXPECT_THAT(undeclared->warnings[0].reason.text(), HasSubstr("ISO-8859-1"));
  EXPECT_THAT(parse_esi("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + latin, "s.xml")->warnings, IsEmpty());
  EXPECT_THAT(parse_esi("\xEF\xBB\xBF" + sloppy("<Device><Type>A</Type></Device>"), "s.xml")->warnings, IsEmpty());
}

TEST(SloppyEsi, WhatHasNoClearMeaningLeavesTheDeviceOutWithItsPlace) {
  struct Case {
    const char* pdo;
    const char* words;
    int line;
  };
  const Case cases[] = {
      {"<RxPdo><Index>#x1600</Index>\n<Entry><Index>1</Index><BitLen>-8</BitLen></Entry></RxPdo>", "out of range", 4},
      {"<RxPdo><Index>#x1600</Index>\n<Entry><Index>1</Index></Entry></RxPdo>", "BitLen", 4},
      {"<RxPdo><Index>#x1600</Index></RxPdo>\n<TxPdo><Index>#x1600</Index></TxPdo>", "used twice; first in line 3", 4},
      {"\n\n<Sm DefaultSize=\"-1\">Inputs</Sm>", "out of range", 5},
      {"<TxPdo Ref=\"None\"/>", "no Pdo with the RefName", 3},
      {"<Slots><Slot MinInstances=\"3\" MaxInstances=\"1\"/></Slots>", "more than MaxInstances", 3},
  };
  for (const auto& wrong : cases) {
    const auto file = parse_esi(with_pdo(wrong.pdo), "s.xml");
    ASSERT_TRUE(file);
    EXPECT_THAT(file->devices, IsEmpty()) << wrong.pdo;
    ASSERT_THAT(file->rejected, SizeIs(1)) << wrong.pdo;
    EXPECT_EQ(file->rejected[0].line, wrong.line) << wrong.pdo;
    EXPECT_EQ(file->rejected[0].file, "s.xml");
    ASSERT_FALSE(file->warnings.empty());
    EXPECT_THAT(file->warnings.back().reason.text(), HasSubstr("Device A is left out"));
    EXPECT_THAT(file->warnings.back().reason.text(), HasSubstr(wrong.words));
  }
}

TEST(SloppyEsi, TemplatesOfOlderFilesAreMovedByTheChannel) {
  const auto file = parse_esi(
      sloppy("<Device><Type>A</Type><TxPdo Ref=\"In\" Chn=\"2\" Sm=\"3\" Fixed=\"1\"/></Device>",
             "<Pdos><Pdo RefName=\"In\"><Name ChnFac=\"1\">Channel #1</Name><Index ChnFac=\"1\">#x1a00</Index>"
             "<Exclude ChnFac=\"1\">#x1a10</Exclude><Entry><Index ChnFac=\"16\">#x6000</Index><SubIndex>1</SubIndex>"
             "<BitLen>1</BitLen></Entry></Pdo></Pdos>"),
      "s.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  const auto& pdo = file->devices[0].tx_pdos.at(0);
  EXPECT_EQ(pdo.index, 0x1A02);
  EXPECT_EQ(pdo.name, "Channel #3");
  EXPECT_EQ(pdo.exclude, std::vector<std::uint16_t>{0x1A12});
  EXPECT_EQ(pdo.entries[0].index, 0x6020);
  EXPECT_EQ(pdo.entries[0].sub_index, 1);
  EXPECT_EQ(pdo.sync_manager, 3);
}

TEST(SloppyEsi, BoundsOfArraysMayBeAnything) {
  for (const char* bound : {"-9223372036854775808", "9223372036854775807", "255"}) {
    const auto file = parse_esi(
        sloppy(
            std::string("<Device><Type>A</Type><Profile><Dictionary><DataTypes><DataType><Name>ARR</"
                        "Name><BaseType>BYTE</BaseType>"
                        "<BitSize>16</BitSize><ArrayInfo><LBound>") +
            bound +
            "</LBound><Elements>9223372036854775807</Elements>"
            "</ArrayInfo></DataType><DataType><Name>T</Name><SubItem><Name>x</Name><Type>ARR</Type></SubItem></"
            "DataType></DataTypes>"
            "<Objects><Object><Index>#x2000</Index><Type>T</Type></Object></Objects></Dictionary></Profile></Device>"),
        "s.xml");
    ASSERT_TRUE(file && file->devices.size() == 1) << bound;
    ASSERT_THAT(file->devices[0].dictionary, SizeIs(1));
    EXPECT_LE(file->devices[0].dictionary[0].entries.size(), 256U);
  }
}

/// Data types multiply: without a bound 20 lines would stand for millions of entries.
TEST(SloppyEsi, DictionariesThatExplodeAreBounded) {
  std::string items, objects;
  for (int i = 0; i < 50; ++i) items += "<SubItem><Name>x</Name><Type>ARR</Type></SubItem>";
  for (int i = 0; i < 3000; ++i) objects += "<Object><Index>#x2000</Index><Type>BIG</Type></Object>";
  const auto file = parse_esi(
      sloppy("<Device><Type>A</Type><Profile><Dictionary><DataTypes><DataType><Name>ARR</Name>"
             "<BaseType>BYTE</BaseType><BitSize>2040</BitSize><ArrayInfo><LBound>1</LBound>"
             "<Elements>255</Elements></ArrayInfo></DataType><DataType><Name>BIG</Name>" +
             items + "</DataType></DataTypes><Objects>" + objects + "</Objects></Dictionary></Profile></Device>"),
      "s.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  EXPECT_THAT(file->devices[0].dictionary, IsEmpty());
  EXPECT_LE(file->warnings.size(), 1000U);
  EXPECT_THAT(file->warnings.front().reason.text(), HasSubstr("too many sub-indices"));
}

}  // namespace
}  // namespace syncline::eni
