// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "config/esi_text.h"
#include "eni/esi/diag_messages.h"

namespace syncline::eni {
namespace {

constexpr const char* kDiagEsi =
    R"(<EtherCATInfo><Vendor><Id>#x2</Id><Name>M</Name></Vendor><Descriptions><Groups/><Devices>
<Device Physics="YY"><Type ProductCode="nonsense">Broken</Type></Device>
<Device Physics="YY"><Type ProductCode="#x10" RevisionNo="1">A</Type><Profile><DiagMessages>
  <DiagMessage><TextId>#x0001</TextId><MessageText LcId="1031">alt</MessageText></DiagMessage></DiagMessages></Profile></Device>
<Device Physics="YY"><Type ProductCode="#x10" RevisionNo="2">A</Type><Profile><DiagMessages>
  <DiagMessage><TextId>#x0021</TextId><MessageText LcId="1033">Over %d V</MessageText><MessageText LcId="1031">Über %d V</MessageText>
    <Description LcId="1033">Mend it</Description></DiagMessage>
  <DiagMessage><TextId>much</TextId><MessageText>left out</MessageText></DiagMessage>
  <DiagMessage><TextId>#x0021</TextId><MessageText>again</MessageText></DiagMessage></DiagMessages>
  <DiagFile>a_diag.xml</DiagFile><DiagFile>../outside.xml</DiagFile></Profile></Device></Devices>
<Modules><Module><Type ModuleIdent="1">m</Type><Profile><DiagMessages>
  <DiagMessage><TextId>34</TextId><MessageText>Of a module</MessageText></DiagMessage></DiagMessages></Profile></Module></Modules>
</Descriptions></EtherCATInfo>)";

TEST(DiagMessages, AreThoseOfTheDeviceAndItsModules) {
  const auto texts = parse_diag_messages(kDiagEsi, "d.xml", {2, 0x10, 2, 0});
  ASSERT_TRUE(texts);
  ASSERT_EQ(texts->size(), 2U) << "a text id that is none is left out, and the second of one";
  EXPECT_EQ((*texts)[0], (DiagMessageText{0x21, "Over %d V", "Mend it"}));
  EXPECT_EQ(find_text(*texts, 0x22)->text, "Of a module");
  EXPECT_EQ(find_text(*texts, 0x23), nullptr);
  const auto german = parse_diag_messages(kDiagEsi, "d.xml", {2, 0x10, 2, 0}, {.language = 1031});
  EXPECT_EQ(find_text(*german, 0x21)->text, "Über %d V");
  EXPECT_EQ(parse_diag_messages(kDiagEsi, "d.xml", {2, 0x10, 1, 0})->size(), 2U) << "another revision has its own";
}

TEST(DiagMessages, OfADeviceThatIsNotThereAreAnError) {
  EXPECT_EQ(parse_diag_messages(kDiagEsi, "d.xml", {3, 0x10, 2, 0}).error().code, ErrorCode::kUnknownDevice);
  EXPECT_EQ(parse_diag_messages(kDiagEsi, "d.xml", {2, 0x10, 9, 0}).error().code, ErrorCode::kUnknownDevice);
  EXPECT_FALSE(parse_diag_messages("<EtherCATInfo", "d.xml", {2, 0x10, 2, 0}));
  EXPECT_FALSE(read_diag_messages("/nowhere/d.xml", {2, 0x10, 2, 0}));
}

TEST(DiagMessages, OfADiagFileCountToo) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "diag_messages_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "d.xml") << kDiagEsi;
  std::ofstream(folder / "a_diag.xml") << R"(<EtherCATDiag><DiagMessages>
    <DiagMessage><TextId>7</TextId><MessageText>Beside</MessageText></DiagMessage></DiagMessages></EtherCATDiag>)";
  const auto texts = read_diag_messages((folder / "d.xml").string(), {2, 0x10, 2, 0});
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(texts);
  ASSERT_NE(find_text(*texts, 7), nullptr);
  EXPECT_EQ(find_text(*texts, 7)->text, "Beside");
}

}  // namespace
}  // namespace syncline::eni
