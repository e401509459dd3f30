// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fuzz/bus_targets.h"
#include "fuzz/script.h"
#include "master/mailbox/coe_client.h"
#include "master/mailbox/foe_client.h"
#include "master/mailbox/sdo_info_client.h"
#include "sim/mailbox/mailbox_server.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::fuzz {
namespace {

constexpr std::uint16_t kMailbox = 128;

/// A slave's mailbox that answers as a script says: honestly, with bytes changed, twice, with another message, or not.
class LyingServer {
 public:
  explicit LyingServer(Script& script) : script_(script), server_(dictionary_, description(), 0) {
    dictionary_.add<std::uint32_t>(0x1000, 0, "Device type", 1);
    dictionary_.add(0x1008, 0, "Device name", Bytes(300, 'n'));
    dictionary_.add<std::uint8_t>(0x1C12, 0, "Assigned PDOs", 2, true);
    dictionary_.add<std::uint16_t>(0x1C12, 1, "Assigned PDO", 0x1600, true);
    dictionary_.add<std::uint16_t>(0x1C12, 2, "Assigned PDO", 0x1601, true);
    server_.files().put("file", Bytes(300, 'f'));
  }
  std::vector<MailboxMessage> answer(const MailboxMessage& request) {
    server_.receive(request.encode(kMailbox), kMailbox, true);
    std::vector<MailboxMessage> answers;
    while (server_.waiting() && answers.size() < 64) {
      const auto bytes = server_.next(kMailbox);
      if (!bytes) break;
      if (auto message = MailboxMessage::decode(*bytes)) answers.push_back(std::move(*message));
    }
    if (!script_.over()) lie(answers, request);
    return answers;
  }

 private:
  static MailboxDescription description() {
    MailboxDescription made;
    made.coe.emplace();
    made.coe->sdo_info = made.coe->complete_access = true;
    made.foe = true;
    return made;
  }
  void lie(std::vector<MailboxMessage>& answers, const MailboxMessage& request) {
    const auto choice = script_.byte();
    if (answers.empty() || choice % 8 == 0) answers.push_back(test::message_of(request.type, {}));
    auto& data = answers.back().data;
    switch (choice % 8) {
      case 1:
        break;
      case 2:
        data.resize(script_.byte() % (kMailbox - MailboxMessage::kHeaderSize + 1U));
        break;
      case 3:
        answers.push_back(answers.back());
        break;
      case 4:
        answers.clear();
        break;
      case 5:
        answers.back().type = static_cast<MailboxType>(script_.byte() % 16);
        break;
      case 0: {
        const auto taken = script_.take(script_.byte() % 120);
        data.assign(taken.begin(), taken.end());
        break;
      }
      default:
        for (auto changes = choice / 64; changes >= 0 && !data.empty(); --changes) {
          const auto place = script_.byte() % data.size();
          data[place] = script_.byte();
        }
    }
  }

  Script& script_;
  sim::ObjectDictionary dictionary_;
  sim::MailboxServer server_;
};

void ask(MailboxClient& mailbox, std::uint8_t what) {
  const Bytes long_value(300, 7);
  switch (what % 10) {
    case 0:
      (void)CoeClient(mailbox).upload({0x1000, 0});
      break;
    case 1:
      (void)CoeClient(mailbox).upload({0x1008, 0});
      break;
    case 2:
      (void)CoeClient(mailbox).upload({0x1C12, 0}, true);
      break;
    case 3:
      (void)CoeClient(mailbox).download({0x1C12, 1}, Bytes(2, 1));
      break;
    case 4:
      (void)CoeClient(mailbox).download({0x1C12, 0}, long_value, true);
      break;
    case 5:
      (void)SdoInfoClient(mailbox).object_list();
      break;
    case 6:
      (void)SdoInfoClient(mailbox).object(0x1C12);
      break;
    case 7:
      (void)SdoInfoClient(mailbox).entry(0x1C12, 1);
      break;
    case 8:
      (void)FoeClient(mailbox).read("file");
      break;
    default:
      (void)FoeClient(mailbox).write("file", long_value);
  }
}

}  // namespace

void run_clients(std::span<const std::uint8_t> bytes) {
  constexpr Nanoseconds kPatience = 20 * kMillisecond, kLongest = 60 * kSecond;
  Script script(bytes);
  const auto what = script.byte();
  test::MailboxBed bed(0, kMailbox);
  LyingServer server(script);
  bed.slave->handler = [&server](const MailboxMessage& request) { return server.answer(request); };
  bed.slave->answers_repeats = bed.slave->has_repeats = what < 128;
  bed.client->set_response_timeout(kPatience);
  ask(*bed.client, what);
  promise(bed.elapsed() < kLongest);
}

std::vector<Bytes> client_scripts() {
  std::vector<Bytes> scripts;
  for (std::uint8_t what = 0; what < 10; ++what) {
    scripts.push_back({what, 1, 1, 6, 2, 0x11, 1, 7, 0, 0xFF, 3, 5, 2});
    scripts.push_back({what, 0, 12, 0, 0x30, 0x60, 0, 0x10, 0, 0xFF, 0xFF, 0xFF, 0x0F, 1, 2, 1, 2, 10});
  }
  return scripts;
}

}  // namespace syncline::fuzz
