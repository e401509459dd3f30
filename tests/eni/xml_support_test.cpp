// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <limits>

#include "eni/xml/xml_number.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "eni/xml/xml_writer.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;

TEST(XmlNumber, TakesTheFormsOfTheField) {
  EXPECT_EQ(parse_number("#x1A00"), 0x1A00);
  EXPECT_EQ(parse_number(" #X1a00 "), 0x1A00);
  EXPECT_EQ(parse_number("0x044c2c52"), 0x044C2C52);
  EXPECT_EQ(parse_number("-3"), -3);
  EXPECT_EQ(parse_number("+3"), 3);
  EXPECT_EQ(parse_number("0"), 0);
  for (const char* wrong : {"", " ", "#x", "#", "1A00", "12 34", "0x12g", "--1", "-", "1.5", "99999999999999999999"}) {
    EXPECT_EQ(parse_number(wrong), std::nullopt) << wrong;
  }
}

TEST(XmlNumber, HexDecAndBytesComeBack) {
  EXPECT_TRUE(rc::check([](std::uint32_t value, const std::vector<std::uint8_t>& bytes) {
    RC_ASSERT(parse_number(hex_dec(value)) == std::optional<std::int64_t>(value));
    RC_ASSERT(parse_hex_bytes(hex_bytes(bytes)) == std::optional(bytes));
  }));
  EXPECT_EQ(parse_hex_bytes(" 01 Ab\n"), (std::vector<std::uint8_t>{0x01, 0xAB}));
  EXPECT_EQ(parse_hex_bytes("012"), std::nullopt);
  EXPECT_EQ(parse_hex_bytes("0g"), std::nullopt);
}

TEST(XmlText, TextOfProgramsBecomesUtf8) {
  EXPECT_EQ(to_utf8("Gr\xF6\xDF"
                    "e"),
            "Größe");
  EXPECT_EQ(to_utf8("Größe"), "Größe");
  EXPECT_EQ(to_utf8("\xEF\xBB\xBFGröße"), "Größe");
  EXPECT_EQ(printable_text(std::string("a\0b\n\xE4", 5)), "abä");
}

/// Whatever a user types must come back as it was, as text and as attribute.
TEST(XmlWriter, TextComesBackExactly) {
  EXPECT_TRUE(rc::check([] {
    const auto piece =
        rc::gen::element<std::string>("a", "B", " ", "\n", "\r", "\t", "<", ">", "&", "\"", "'", "]]>", "ö", "速");
    std::string value;
    for (const auto& part : *rc::gen::container<std::vector<std::string>>(piece)) value += part;
    XmlWriter xml;
    xml.open("Root").attribute("A", value).element("T", value).element("After", "x");
    const auto text = xml.take();
    const auto document = parse_xml(text, "test");
    RC_ASSERT(document.has_value());
    Reading reading("test");
    const Node root((*document)->RootElement(), reading);
    RC_ASSERT(root.attribute("A") == value);
    RC_ASSERT(root.child("T").text() == value);
    RC_ASSERT(root.child("After").text() == "x");
  }));
}

TEST(XmlReader, FirstErrorNamesLineAndElement) {
  const auto document = parse_xml("<A>\n <B C=\"300\"/>\n <D>x</D>\n</A>", "f.xml");
  ASSERT_TRUE(document);
  Reading reading("f.xml");
  const Node root((*document)->RootElement(), reading);
  EXPECT_EQ(root.child("B").number<std::uint16_t>("C"), 300);
  EXPECT_TRUE(reading.ok());
  (void)root.child("B").number<std::uint8_t>("C");
  (void)root.child("D").number<int>();
  ASSERT_FALSE(reading.ok());
  EXPECT_EQ(reading.error()->code, ErrorCode::kXmlBadValue);
  EXPECT_EQ(reading.error()->line, 2);
  EXPECT_EQ(reading.error()->subject, "B@C");
  EXPECT_THAT(reading.error()->detail.text(), HasSubstr("out of range"));
}

TEST(XmlReader, MalformedTextNamesItsLine) {
  const auto document = parse_xml("<A>\n<B>\n</A>", "f.xml");
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kXmlMalformed);
  EXPECT_EQ(document.error().file, "f.xml");
  EXPECT_GT(document.error().line, 0);
  EXPECT_THAT(document.error().detail.text(), HasSubstr("end tag"));
  EXPECT_FALSE(parse_xml("", "f.xml"));
  EXPECT_FALSE(parse_xml("<!-- nothing -->", "f.xml"));
}

/// The element that is wrong, or the one around what is wrong.
TEST(XmlReader, MalformedTextNamesTheElement) {
  struct Case {
    const char* text;
    const char* element;
    int line;
  };
  const Case cases[] = {
      {"<A>\n<B>\n</A>", "B", 2},
      {"<A>\n<B x=>\n</B></A>", "B", 2},
      {"<A>\n<B/>\n<", "A", 3},
      {"<A>\n<C/><B y='/>'>\n<1/>\n</B></A>", "B", 3},
      {"<A>\n<B>\ntext", "B", 3},
      {"<A>\n<B></B><C><![CDATA[ <D>\n\n", "C", 2},
      {"<A><!-- <D> -->\n<!-- <B>\n</A>", "A", 2},
      {"<?xml version='1.0'?><A>\n<B z=\"'\"><?x", "B", 2},
      {"<A>\n<B/><!x", "A", 2},
      {"hello", "", 1},
      {"<A/>\ntail", "", 2},
  };
  for (const auto& [text, element, line] : cases) {
    const auto document = parse_xml(text, "f.xml");
    ASSERT_FALSE(document) << text;
    EXPECT_EQ(document.error().subject, element) << text;
    EXPECT_EQ(document.error().line, line) << text;
    if (*element != '\0') {
      EXPECT_THAT(document.error().detail.text(), HasSubstr("<" + std::string(element) + ">")) << text;
    }
  }
}

TEST(XmlReader, NumbersMustFitTheirType) {
  const auto document = parse_xml("<A>-1</A>", "f.xml");
  ASSERT_TRUE(document);
  Reading reading("f.xml");
  const Node node((*document)->RootElement(), reading);
  EXPECT_EQ(node.number<std::int8_t>(), -1);
  EXPECT_TRUE(reading.ok());
  (void)node.number<std::uint32_t>();
  EXPECT_FALSE(reading.ok());
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "syncline-xml-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(TextFile, SavingReplacesTheFileAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const auto file = (folder.path() / "a.xml").string();
  ASSERT_TRUE(write_file_atomic(file, "one"));
  ASSERT_TRUE(write_file_atomic(file, "two"));
  EXPECT_EQ(read_file(file), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(TextFile, SavingThroughALinkKeepsTheLinkAndThePermissions) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.xml", link = folder.path() / "link.xml";
  ASSERT_TRUE(write_file_atomic(file.string(), "one"));
  std::filesystem::permissions(file, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  std::filesystem::create_symlink(file, link);
  ASSERT_TRUE(write_file_atomic(link.string(), "two"));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(file.string()), "two");
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST(TextFile, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto missing = (folder.path() / "no" / "a.xml").string();
  const auto read = read_file(missing);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kFileNotFound);
  EXPECT_EQ(read.error().file, missing);
  const auto written = write_file_atomic(missing, "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(read_file(folder.path().string()).error().code, ErrorCode::kFileNotReadable);
}

}  // namespace
}  // namespace syncline::eni
