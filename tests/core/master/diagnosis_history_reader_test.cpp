// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/diagnosis_history_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mailbox/mailbox_server.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint8_t kFirst = diagnosis_history::kFirstMessage, kPlaces = 5;

/// A slave with a ring of five places, of which some hold a message whose code is the place's sub-index.
class HistoryOfASlave : public testing::Test {
 protected:
  HistoryOfASlave() : server_(dictionary, description(), 0) {
    dictionary.add<std::uint8_t>(diagnosis_history::kIndex, 0, "Sub-indices", kFirst + kPlaces - 1);
    dictionary.add<std::uint8_t>(diagnosis_history::kIndex, diagnosis_history::kNewest, "Newest", 0);
    dictionary.add<std::uint8_t>(diagnosis_history::kIndex, diagnosis_history::kNewAvailable, "New", 1);
    for (std::uint8_t n = 0; n < kPlaces; ++n) {
      const auto sub_index = static_cast<std::uint8_t>(kFirst + n);
      dictionary.add(diagnosis_history::kIndex, sub_index, "Message", std::vector<std::uint8_t>(16));
    }
    bed.slave->handler = [this](const MailboxMessage& request) {
      server_.receive(request.encode(128), 128, true);
      std::vector<MailboxMessage> answers;
      while (server_.waiting()) answers.push_back(MailboxMessage::decode(*server_.next(128)).value());
      return answers;
    };
  }
  void fill(std::uint8_t sub_index) {
    const DiagnosisMessage message{sub_index, DiagnosisMessage::Type::kError, 1, 42, {}};
    dictionary.find(diagnosis_history::kIndex, sub_index)->value = message.encode();
    dictionary.set<std::uint8_t>(diagnosis_history::kIndex, diagnosis_history::kNewest, sub_index);
  }
  /// Codes of what is read, in its order.
  std::vector<std::uint32_t> read(std::uint8_t after = 0) {
    std::vector<std::uint32_t> codes;
    const auto history = read_diagnosis_history(*bed.client, after);
    EXPECT_TRUE(history);
    if (!history) return codes;
    for (const auto& entry : history->messages) codes.push_back(entry.message.code);
    return codes;
  }

  MailboxBed bed;
  sim::ObjectDictionary dictionary;

 private:
  static MailboxDescription description() {
    MailboxDescription made;
    made.coe.emplace();
    return made;
  }
  sim::MailboxServer server_;
};

TEST_F(HistoryOfASlave, IsReadFromTheOldestMessageOn) {
  EXPECT_THAT(read(), IsEmpty());
  for (std::uint8_t n = 0; n < 3; ++n) fill(kFirst + n);
  EXPECT_THAT(read(), ElementsAre(kFirst, kFirst + 1, kFirst + 2));
}

TEST_F(HistoryOfASlave, GoesRoundWhenItIsFull) {
  for (std::uint8_t n = 0; n < kPlaces; ++n) fill(kFirst + n);
  fill(kFirst);
  fill(kFirst + 1);
  EXPECT_THAT(read(), ElementsAre(kFirst + 2, kFirst + 3, kFirst + 4, kFirst, kFirst + 1));
}

TEST_F(HistoryOfASlave, GivesWhatCameBehindTheOneThatIsKnown) {
  for (std::uint8_t n = 0; n < kPlaces; ++n) fill(kFirst + n);
  fill(kFirst);
  EXPECT_THAT(read(kFirst + 3), ElementsAre(kFirst + 4, kFirst));
  EXPECT_THAT(read(kFirst), IsEmpty());
}

}  // namespace
}  // namespace syncline::test
