// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_pieces.h"

#include <gtest/gtest.h>

#include "eni/xml/xml_text.h"
#include "support/random.h"
#include "tests/support/source_dir.h"

namespace syncline::eni {
namespace {

bool is_device(std::string_view element, std::string_view parent) { return element == "Device" && parent == "Devices"; }

/// An element with all that is in it, each with its line.
void print(const tinyxml2::XMLElement& element, std::string& out) {
  out += "<" + std::string(element.Name()) + ":" + std::to_string(line_of(element));
  for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    out += std::string(" ") + a->Name() + "=" + a->Value();
  }
  out += ">";
  for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) out += node->Value();
    if (node->ToElement() != nullptr) print(*node->ToElement(), out);
  }
  out += "</>";
}

/// The same of a document, whose pieces are taken one by one.
void print_whole(XmlPieces& pieces, const Node& node, std::string& out) {
  if (node.element()->GetUserData() != nullptr) {
    if (const Node whole = pieces.whole(node)) print(*whole.element(), out);
    return;
  }
  out += "<" + std::string(node.name()) + ":" + std::to_string(node.line()) + ">";
  for (const Node& child : node.children()) print_whole(pieces, child, out);
  out += "</>";
}

std::string in_pieces(std::string_view text, std::optional<Error>& error) {
  auto pieces = XmlPieces::parse(text, "file.xml", is_device);
  if (!pieces) {
    error = pieces.error();
    return {};
  }
  Reading reading("file.xml");
  std::string out;
  print_whole(*pieces, {pieces->root(), reading}, out);
  error = pieces->error();
  return out;
}

std::string at_once(std::string_view text, std::optional<Error>& error) {
  const auto document = parse_xml(text, "file.xml");
  if (!document) {
    error = document.error();
    return {};
  }
  Reading reading("file.xml");
  std::string out;
  // What is no device is printed without its texts there, too.
  const auto visit = [&](const auto& self, const Node& node, std::string_view parent) -> void {
    if (is_device(node.name(), parent)) return print(*node.element(), out);
    out += "<" + std::string(node.name()) + ":" + std::to_string(node.line()) + ">";
    for (const Node& child : node.children()) self(self, child, node.name());
    out += "</>";
  };
  visit(visit, {(*document)->RootElement(), reading}, "");
  return out;
}

void expect_same(std::string_view text) {
  std::optional<Error> error, expected;
  const std::string pieces = in_pieces(text, error), whole = at_once(text, expected);
  EXPECT_EQ(error, expected) << text.substr(0, 3000);
  if (!expected) {
    EXPECT_EQ(pieces, whole) << text.substr(0, 3000);
  }
}

std::string devices(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<EtherCATInfo>\n<Devices>" + content + "</Devices>\n<After>1</After></EtherCATInfo>";
}

TEST(XmlPieces, AreWhatTheWholeHasInTheSameLines) {
  for (const char* content :
       {"", "<Device/>", "<Device a='>'/>", "<Device></Device>",
        "<Device>\n<Name>1</Name>\n\n</Device>\n<Device>2</Device >",
        "<Device A=\"</Device>\"><Devices>\n<Device>in one</Device></Devices></Device><Device/>",
        "<!-- <Device> -->\n<Device><!-- </Device> --><X/>\n</Device>",
        "<Device><![CDATA[</Device><Device>]]>\n</Device><Other>\n</Other><Device\n B='1'\n>\n3&lt;</Device>",
        "<Device><?pi </Device>?>\r\n</Device>\r\n<Device>4</Device>", "text <Device>5</Device> more"}) {
    expect_same(devices(content));
  }
  expect_same("<Device>alone</Device>");
}

TEST(XmlPieces, TellWhatIsWrongAsTheWholeDoes) {
  for (const char* content :
       {"<Device>", "</Device>", "<Device></Devices>", "<Device><A></B></Device>", "<Device><A b=1/></Device>",
        "<Device>\n<A b='1' b='2'/></Device>", "<Device><A></Device>", "<Device><1/></Device>",
        "<Device\n<A/></Device>", "<Device><!-- </Device>", "<Device a='></Device>",
        "<Device>ok</Device>\n<Device>\n<A x/></Device><Device><B y/></Device>"}) {
    expect_same(devices(content));
  }
  for (const char* text : {"", " ", "no XML", "<", "<A", "<A></A><", "<A/><B>", "\xFF"}) expect_same(text);
}

/// A damaged file is the same to both, whatever the damage.
TEST(XmlPieces, OfDamagedFilesAreWhatTheWholeIs) {
  const std::string path = test::source_dir() + "/resources/esi/SL-XE2.xml";
  const std::string whole = *read_file(path);
  expect_same(whole);
  Random random(20);
  constexpr std::string_view kParts[] = {"<",    ">",   "/",   "\"", "'", "</Device>", "<Device>",
                                         "<!--", "-->", "]]>", "\n", "&", " x"};
  for (int i = 0; i < 400; ++i) {
    std::string text = whole;
    for (std::size_t n = 1 + random.next() % 2; n > 0; --n) {
      const std::size_t at = random.next() % text.size();
      if (random.next() % 2 == 0) {
        text.erase(at, 1 + random.next() % 30);
      } else {
        text.insert(at, kParts[random.next() % std::size(kParts)]);
      }
    }
    expect_same(text);
    if (testing::Test::HasFailure()) return;
  }
}

/// One device after the other: the tree of the file has none of their contents.
TEST(XmlPieces, StandInTheTreeWithoutContent) {
  auto pieces = XmlPieces::parse(devices("<Device A='1'><B/><C/></Device>\n<Device>2</Device>"), "file.xml", is_device);
  ASSERT_TRUE(pieces);
  Reading reading("file.xml");
  const auto stubs = Node(pieces->root(), reading).child("Devices").children("Device");
  ASSERT_EQ(stubs.size(), 2U);
  EXPECT_EQ(stubs[0].attribute("A"), "1");
  EXPECT_FALSE(stubs[0].has_children());
}

}  // namespace
}  // namespace syncline::eni
