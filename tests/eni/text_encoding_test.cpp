// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/text_encoding.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iconv.h>
#include <rapidcheck.h>

#include "eni/esi/esi_reader.h"
#include "eni/xml/xml_reader.h"
#include "support/utf8.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;

/// The other way round, as a maker's editor does it.
std::string encode(const std::string& utf8, const char* encoding) {
  const iconv_t handle = ::iconv_open(encoding, "UTF-8");
  std::string out(utf8.size() * 4 + 16, '\0');
  std::string in = utf8;
  char* from = in.data();
  char* to = out.data();
  std::size_t left = in.size(), room = out.size();
  EXPECT_NE(::iconv(handle, &from, &left, &to, &room), static_cast<std::size_t>(-1)) << encoding;
  ::iconv_close(handle);
  out.resize(out.size() - room);
  return out;
}

std::string decoded(const std::string& text) {
  std::string buffer;
  const auto result = decode_text(text, buffer, "x.xml");
  return result ? std::string(result->text) : result.error().detail.text();
}

std::string declared(const std::string& encoding, const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?><A>" + content + "</A>";
}

TEST(TextEncoding, DeclaredCodePagesAreConverted) {
  const std::tuple<const char*, const char*, const char*> cases[] = {{"gb2312", "GB18030", "速度控制"},
                                                                     {"GBK", "GBK", "伺服驱动器"},
                                                                     {"Big5", "BIG5", "伺服驅動器"},
                                                                     {"Shift_JIS", "CP932", "サーボ"},
                                                                     {"Windows-31J", "CP932", "サーボ"},
                                                                     {"euc-kr", "EUC-KR", "드라이브"},
                                                                     {"windows-1252", "CP1252", "Größe “10 €”"},
                                                                     {"iso-8859-1", "ISO-8859-1", "Größe"},
                                                                     {"windows-1251", "CP1251", "Привод"},
                                                                     {"iso-8859-2", "ISO-8859-2", "Měření"}};
  for (const auto& [name, written_as, content] : cases) {
    const auto text = declared(name, content);
    EXPECT_EQ(decoded(encode(text, written_as)), text) << name;
    EXPECT_FALSE(find_encoding(encode(text, written_as)).guessed) << name;
  }
}

/// Each letter of one byte is one of three.
TEST(TextEncoding, ATextMayBecomeThreeTimesAsLong) {
  std::string euros;
  for (int i = 0; i < 5'000; ++i) euros += "€";
  const auto text = declared("windows-1252", euros);
  EXPECT_TRUE(decoded(encode(text, "CP1252")) == text);
}

TEST(TextEncoding, WideEncodingsWithAndWithoutMark) {
  const std::string text = "<?xml version=\"1.0\"?><A>Größe 速 😀</A>";
  for (const char* name : {"UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE"}) {
    EXPECT_EQ(decoded(encode(text, name)), text) << name;
    EXPECT_EQ(decoded(encode("\xEF\xBB\xBF" + text, name)), text) << name << " with its mark";
  }
  EXPECT_EQ(decoded("\xEF\xBB\xBF" + text), text);
}

/// XML 1.0, appendix F: where there is no mark the zeros tell; a document without declaration may begin with spaces.
TEST(TextEncoding, WideEncodingsWithoutMarkMayBeginWithSpaces) {
  const std::string text = "\r\n <A>Größe 速</A>";
  for (const char* name : {"UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE"}) {
    EXPECT_EQ(decoded(encode(text, name)), text) << name;
    EXPECT_EQ(decoded(encode("<A/>", name)), "<A/>") << name;
  }
}

std::string doubt_of(const std::string& text) {
  std::string buffer;
  const auto result = decode_text(text, buffer, "x.xml");
  if (!result || !result->doubt) return {};
  return fmt::format("{}: {}", result->doubt->line, result->doubt->reason.text());
}

/// An editor that saves in the code of its country under the declaration that was there.
TEST(TextEncoding, ADeclarationThatTheBytesContradictIsSaid) {
  const auto chinese = declared("windows-1252", "伺服驱动器 速度"), german = declared("gb2312", "Größe für Öl");
  EXPECT_EQ(decoded(encode(chinese, "GB18030")), chinese);
  EXPECT_THAT(doubt_of(encode(chinese, "GB18030")), HasSubstr("names the encoding WINDOWS-1252"));
  EXPECT_EQ(decoded(encode(german, "CP1252")), german);
  EXPECT_THAT(doubt_of(encode(german, "CP1252")), HasSubstr("names the encoding GB2312"));
  for (const auto& [name, content] : {std::pair{"windows-1252", "Größe für Öl"}, std::pair{"gb2312", "伺服驱动器"}}) {
    EXPECT_EQ(doubt_of(encode(declared(name, content), name)), "") << name;
  }
}

TEST(TextEncoding, AByteThatTheCodePageDoesNotAssignIsSaidWithItsLine) {
  EXPECT_THAT(doubt_of(declared("windows-1252",
                                "Gr\xF6\xDF"
                                "e\n\x8D")),
              HasSubstr("2: the byte 0x8d is no letter of the encoding windows-1252"));
  const auto file = parse_esi(declared("iso-8859-1", "\x81"), "x.xml");
  ASSERT_FALSE(file) << "no ESI file";
  const auto esi = parse_esi(
      "<?xml version=\"1.0\" encoding=\"iso-8859-1\"?><EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions><Groups/>"
      "<Devices/></Descriptions><!-- \x81 --></EtherCATInfo>",
      "x.xml");
  ASSERT_TRUE(esi);
  ASSERT_EQ(esi->warnings.size(), 1U);
  EXPECT_THAT(esi->warnings[0].reason.text(), HasSubstr("0x81"));
}

TEST(TextEncoding, WhatIsUtf8StaysWhateverItDeclares) {
  for (const char* name : {"UTF-8", "utf-8", "iso-8859-1", "gb2312", "UTF-16"}) {
    const auto text = declared(name, "速度 Größe");
    EXPECT_EQ(decoded(text), text) << name;
  }
  EXPECT_EQ(decoded(declared("iso-8859-1", "Größe")), declared("iso-8859-1", "Größe"));
}

TEST(TextEncoding, WithoutDeclarationItIsGuessedAndSaid) {
  const std::string german = "<A>Größe für Öl</A>", chinese = "<A>伺服驱动器 速度</A>";
  EXPECT_EQ(decoded(encode(german, "CP1252")), german);
  EXPECT_EQ(decoded(encode(chinese, "GB18030")), chinese);
  EXPECT_TRUE(find_encoding(encode(german, "CP1252")).guessed);
  EXPECT_EQ(find_encoding(encode(chinese, "GB18030")), (TextEncoding{"GB18030", 0, true}));
  EXPECT_EQ(decoded(encode(declared("UTF-8", "Größe"), "CP1252")), declared("UTF-8", "Größe"));
}

TEST(TextEncoding, WhatCannotBeConvertedIsRefusedByName) {
  EXPECT_THAT(decoded(declared("x-klingon", "\xE4")), HasSubstr("\"X-KLINGON\""));
  const auto broken = parse_xml(declared("gb2312", "\n\xFF\xFF"), "b.xml");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().line, 2);
  EXPECT_THAT(broken.error().detail.text(), HasSubstr("0xff"));
}

TEST(TextEncoding, AnEsiFileInAnyOfThemHasItsNames) {
  const std::string esi =
      "<EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions><Groups/><Devices><Device Physics=\"YY\"><Type "
      "ProductCode=\"1\" "
      "RevisionNo=\"1\">T</Type><Name>伺服驱动器</Name></Device></Devices></Descriptions></EtherCATInfo>";
  for (const char* name : {"gb2312", "gbk"}) {
    const std::string head = std::string("<?xml version=\"1.0\" encoding=\"") + name + "\"?>";
    const auto file = parse_esi(encode(head + esi, "GBK"), "x.xml");
    ASSERT_TRUE(file) << name;
    EXPECT_EQ(file->devices.at(0).name, "伺服驱动器");
    EXPECT_TRUE(file->warnings.empty());
  }
  const auto wide = parse_esi(encode(esi, "UTF-16LE"), "x.xml");
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->devices.at(0).name, "伺服驱动器");
}

/// Whatever comes, the result is UTF-8 or an error.
TEST(TextEncoding, AnyBytesGiveUtf8OrAnError) {
  EXPECT_TRUE(rc::check([](const std::string& bytes, bool declare) {
    const std::string text = declare ? declared("gb2312", bytes) : bytes;
    std::string buffer;
    const auto result = decode_text(text, buffer, "x.xml");
    if (result) RC_ASSERT(is_utf8(result->text));
  }));
}

}  // namespace
}  // namespace syncline::eni
