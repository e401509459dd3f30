// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kFile = R"(<EtherCATInfo><Vendor><Id>2</Id><Name>M</Name></Vendor><Descriptions><Groups/><Devices>
<Device Physics="YY"><Type ProductCode="1">A</Type><Profile><ProfileNo>5001</ProfileNo><Dictionary><DataTypes>
  <DataType><Name>MODE</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>
    <EnumInfo><Text>Off</Text><Enum>0</Enum></EnumInfo><EnumInfo><Text>On</Text><Enum>-1</Enum></EnumInfo></DataType>
  <DataType><Name>ARRAY [0..3] OF BYTE</Name><BaseType>BYTE</BaseType><BitSize>32</BitSize>
    <ArrayInfo><LBound>0</LBound><Elements>4</Elements></ArrayInfo></DataType>
  <DataType><Name>DT2000</Name><BitSize>64</BitSize>
    <SubItem><SubIdx>0</SubIdx><Name>Count</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs>
      <Flags><Access>ro</Access></Flags></SubItem>
    <SubItem><SubIdx>1</SubIdx><Name>Message</Name><Type>ARRAY [0..3] OF BYTE</Type><BitSize>32</BitSize><BitOffs>16</BitOffs></SubItem>
    <SubItem><SubIdx>2</SubIdx><Name>Gain</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>48</BitOffs><DefaultValue>7</DefaultValue>
      <Flags><Access WriteRestrictions="PreOP">rw</Access><Category>m</Category><PdoMapping>R</PdoMapping><Backup>1</Backup>
        <Setting>1</Setting></Flags></SubItem></DataType>
  </DataTypes><Objects>
  <Object><Index DependOnSlot="1" OverwrittenByModule="1">#x2000</Index><Name>Record</Name><Type>DT2000</Type><BitSize>64</BitSize>
    <Flags><Access>rw</Access><PdoMapping>T</PdoMapping></Flags></Object>
  <Object><Index>#x2001</Index><Name>Mode</Name><Type>MODE</Type><BitSize>8</BitSize>
    <Info><MinValue>-2</MinValue><MaxValue>#x10</MaxValue><DefaultData>05</DefaultData></Info></Object>
  </Objects></Dictionary></Profile></Device></Devices></Descriptions></EtherCATInfo>)";

TEST(EsiDictionary, KeepsFlagsLimitsAndNamesOfValues) {
  const auto file = parse_esi(kFile, "d.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  EXPECT_THAT(file->warnings, IsEmpty());
  const auto& device = file->devices.front();
  ASSERT_THAT(device.dictionary, SizeIs(2));
  const auto& record = device.dictionary[0];
  EXPECT_EQ(record.code, ObjectCode::kRecord);
  EXPECT_TRUE(record.depend_on_slot && record.overwritten_by_module);
  ASSERT_THAT(record.entries, SizeIs(3)) << "an array that has a sub-index is one value, not four";
  EXPECT_EQ(record.entries[1].bit_length, 32);
  EXPECT_TRUE(record.entries[1].writable) << "by the object";
  EXPECT_TRUE(record.entries[1].tx_mappable);
  const auto& gain = record.entries[2];
  EXPECT_EQ(gain.bit_offset, 48U);
  EXPECT_EQ(gain.category, ObjectCategory::kMandatory);
  EXPECT_TRUE(gain.rx_mappable && !gain.tx_mappable && gain.backup && gain.setting);
  EXPECT_EQ(gain.write_restrictions, "PreOP");
  EXPECT_THAT(gain.default_data, ElementsAre(7, 0));
  const auto& mode = device.dictionary[1].entries[0];
  EXPECT_THAT(mode.min_data, ElementsAre(0xFE));
  EXPECT_THAT(mode.max_data, ElementsAre(0x10));
  EXPECT_THAT(mode.default_data, ElementsAre(5));
  EXPECT_THAT(device.enums, ElementsAre(EnumDescription{"MODE", "USINT", 8, {{0, "Off"}, {-1, "On"}}}));
}

TEST(EsiDictionary, CategoriesAreReadInBothCases) {
  using enum ObjectCategory;
  for (const auto& [letter, category] : {std::pair{"m", kMandatory},
                                         {"M", kMandatory},
                                         {"c", kConditional},
                                         {"C", kConditional},
                                         {"o", kOptional},
                                         {"O", kOptional}}) {
    std::string text = kFile;
    const std::string before = "<Category>m</Category>";
    text.replace(text.find(before), before.size(), std::string("<Category>") + letter + "</Category>");
    const auto file = parse_esi(text, "d.xml");
    ASSERT_TRUE(file && file->devices.size() == 1);
    EXPECT_EQ(file->devices.front().dictionary[0].entries[2].category, category) << letter;
  }
}

TEST(EsiDictionary, WriterKeepsIt) {
  const auto file = parse_esi(kFile, "d.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  const auto again = parse_esi(write_esi(file->devices.front()), "d.xml");
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->devices == file->devices);
}

}  // namespace
}  // namespace syncline::eni
