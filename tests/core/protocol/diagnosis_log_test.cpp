// SPDX-License-Identifier: Apache-2.0
#include "protocol/diagnosis_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/diagnosis_text.h"

namespace syncline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using HistoryBytes = std::vector<std::uint8_t>;
using DiagType = DiagnosisMessage::Type;

constexpr std::uint16_t kUnsigned8 = 5, kSigned16 = 3, kUnsigned16 = 6, kUnsigned32 = 7, kReal32 = 8;

/// Room for four messages: 6 to 9.
DiagnosisHeader ring(std::uint8_t newest, std::uint8_t acknowledged, bool fresh, std::uint16_t flags = 0) {
  return {9, 4, newest, acknowledged, fresh, flags};
}

TEST(DiagnosisHeader, TakesOnlyWhatIsThere) {
  DiagnosisHeader header;
  EXPECT_TRUE(header.take(0, HistoryBytes{9}));
  EXPECT_TRUE(header.take(2, HistoryBytes{7, 0}));
  EXPECT_FALSE(header.take(3, {})) << "truncated";
  EXPECT_FALSE(header.take(5, HistoryBytes{1})) << "half of the flags";
  EXPECT_FALSE(header.flags);
  EXPECT_TRUE(header.take(5, HistoryBytes{0x10, 0}));
  EXPECT_FALSE(header.take(6, HistoryBytes{1})) << "a message";
  EXPECT_EQ(header, (DiagnosisHeader{9, 0, 7, 0, false, 0x10}));
}

TEST(DiagnosisHeader, OrderIsOldestFirst) {
  EXPECT_THAT(message_places(ring(7, 0, true)), ElementsAre(8, 9, 6, 7));
  EXPECT_THAT(message_places(ring(9, 0, true)), ElementsAre(6, 7, 8, 9));
  EXPECT_THAT(message_places(ring(0, 0, false)), ElementsAre(6, 7, 8, 9));
  EXPECT_THAT(message_places(ring(200, 0, false)), ElementsAre(6, 7, 8, 9)) << "a newest that lies";
  EXPECT_THAT(message_places(ring(7, 0, true), 9), ElementsAre(6, 7));
  EXPECT_THAT(message_places(ring(7, 0, true), 7), IsEmpty());
  EXPECT_THAT(message_places({.last = 5}), IsEmpty());
  EXPECT_THAT(message_places({.last = 255, .newest = 255}), ::testing::SizeIs(250));
}

TEST(DiagnosisHeader, KnowsWhatWasAcknowledged) {
  const auto of = [](const DiagnosisHeader& header) {
    std::vector<bool> all;
    for (std::uint8_t sub = 6; sub <= 9; ++sub) all.push_back(header.acknowledged(sub));
    return all;
  };
  EXPECT_THAT(of(ring(8, 8, false)), ElementsAre(true, true, true, true));
  EXPECT_THAT(of(ring(8, 6, true)), ElementsAre(true, false, false, true)) << "9 is the oldest";
  EXPECT_THAT(of(ring(7, 9, true)), ElementsAre(false, false, true, true)) << "around the end of the ring";
  EXPECT_THAT(of(ring(8, 0, true)), ElementsAre(false, false, false, false)) << "nobody ever has";
  EXPECT_THAT(of(ring(8, 8, true)), ElementsAre(false, false, false, false)) << "the mark was run over";
  EXPECT_THAT(of(ring(8, 6, true, diagnosis_history::kOverwritten)), ElementsAre(false, false, false, false));
  EXPECT_THAT(of(ring(8, 6, true, diagnosis_history::kOverwritten | diagnosis_history::kAcknowledgeMode)),
              ElementsAre(true, false, false, true))
      << "what came too late was thrown away, the mark still stands";
  EXPECT_FALSE(ring(8, 8, false).acknowledged(10));
}

TEST(DiagnosisLog, HoldsWhatCanBeReadAndWhatCannot) {
  const DiagnosisMessage good{0xA000E000, DiagType::kWarning, 0x1A, 42, {{kUnsigned16, {1, 2}}}};
  const auto bytes = good.encode();
  const HistoryBytes truncated(bytes.begin(), bytes.end() - 1);
  auto lying = bytes;
  lying[5] = 9;  // parameters
  const auto log = diagnosis_log(ring(7, 0, true), {{6, bytes}, {7, truncated}, {8, HistoryBytes(16)}, {9, lying}});
  ASSERT_EQ(log.entries.size(), 3U) << "an empty place is none";
  EXPECT_EQ(log.entries[0].sub_index, 9);
  EXPECT_FALSE(log.entries[0].message) << "it says nine parameters";
  EXPECT_EQ(log.entries[1].message, good);
  EXPECT_FALSE(log.entries[2].message);
  EXPECT_EQ(log.entries[2].bytes, truncated);
  for (std::size_t length = 1; length < bytes.size(); ++length) {
    EXPECT_FALSE(DiagnosisMessage::decode(std::span(bytes).first(length))) << length;
  }
  auto long_text = bytes;
  long_text[16] = 0xFF;
  long_text[17] = 0x2F;  // text of 4095 bytes
  EXPECT_FALSE(DiagnosisMessage::decode(long_text));
}

std::string filled(std::string_view text, std::vector<DiagnosisMessage::Parameter> parameters) {
  return diagnosis_text(text, {0, DiagType::kInfo, 1, 0, std::move(parameters)});
}

TEST(DiagnosisText, PutsParametersWhereTheTextWantsThem) {
  EXPECT_EQ(filled("Code 0x%x, %d%%", {{kUnsigned16, {0x1A, 0}}, {kSigned16, {0xFF, 0xFF}}}), "Code 0x1a, -1%");
  EXPECT_EQ(filled("0x%04X %#x", {{kUnsigned16, {0x1A, 0}}, {kUnsigned8, {5}}}), "0x001A 0x5");
  EXPECT_EQ(filled("%5u|%-5lu|%+d", {{kUnsigned8, {7}}, {kUnsigned32, {8, 0, 0, 0}}, {kUnsigned8, {9}}}),
            "    7|8    |+9");
  EXPECT_EQ(filled("%s at %.1f", {{0x2003, {'a', 'b', 'c'}}, {kReal32, {0, 0, 0xC0, 0x3F}}}), "abc at 1.5");
  EXPECT_EQ(filled("%s", {{0x3004, {0xB5, 0, 's', 0}}}), "\xC2\xB5s");
  EXPECT_EQ(filled("%d", {{0x1002, {0x12, 0xAB}}}), "12 ab") << "bytes are no number";
}

TEST(DiagnosisText, TrustsNoText) {
  EXPECT_EQ(filled("%d of %d", {{kUnsigned8, {7}}}), "7 of ?") << "fewer parameters than it wants";
  EXPECT_EQ(filled("no place", {{kUnsigned8, {7}}, {0x2002, {'x', 'y'}}}), "no place [7] [xy]");
  EXPECT_EQ(filled("%n %", {{kUnsigned8, {7}}}), "%n % [7]");
  EXPECT_EQ(filled("%99999999999d", {{kUnsigned8, {7}}}).size(), 64U);
  EXPECT_EQ(filled("%s%s%s", {}), "???");
  EXPECT_EQ(filled("%s", {{kUnsigned16, {5}}}), "05") << "one byte of two";
  EXPECT_EQ(raw_diagnosis_text({0, DiagType::kInfo, 0x1A, 0, {{kUnsigned8, {5}}}}), "text 0x001A [5]");
}

}  // namespace
}  // namespace syncline
