// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"
#include "protocol/coe.h"
#include "protocol/sdo_information.h"

namespace syncline {

/// The one SDO client (ETG.1000.6, 5.6.2 and 5.6.3): uploads and downloads, expedited, normal, segmented and with
/// complete access, and SDO information, one transfer at a time with one slave. Late answers to transfers that were
/// given up are passed over; a slave that lies about lengths, toggles or ends gets an abort. Allocates in use() alone,
/// and where what comes has no room in the caller's bytes.
class SdoWork final : public SlaveWork {
 public:
  SdoWork() = default;
  explicit SdoWork(SlaveMailbox& mailbox) { use(mailbox); }

  void use(SlaveMailbox& mailbox);
  void set_response_timeout(Nanoseconds timeout) { transfer_.set_response_timeout(timeout); }

  /// What is there comes behind what `into` holds; an object of more than `limit` bytes is refused before its data are
  /// fetched. Complete access begins at sub-index 0 or 1. `into` outlives the transfer.
  void upload(coe::ObjectAddress object, bool complete_access, std::vector<std::uint8_t>& into, std::size_t limit);
  /// `data` outlives the transfer.
  void download(coe::ObjectAddress object, bool complete_access, std::span<const std::uint8_t> data);
  /// The data of all fragments come behind what `into` holds, for coe::decode_information_response().
  void ask(const coe::InformationRequest& request, std::vector<std::uint8_t>& into, std::size_t limit);
  /// Ends it now, without a word to the slave.
  void give_up(const BriefError& why);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return step_ == Step::kOver; }
  [[nodiscard]] Status result() const override;
  [[nodiscard]] bool in_a_hurry() const override { return transfer_.in_a_hurry(); }

  /// kSdoAbort with the abort code, kMailboxTimeout, kMailboxProtocol.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }
  /// "drive, object 0x6040:00".
  [[nodiscard]] std::string subject() const;
  [[nodiscard]] bool emergency() const { return emergency_; }

 private:
  enum class Kind : std::uint8_t { kUpload, kDownload, kInformation };
  enum class Step : std::uint8_t { kOver, kBegin, kFirst, kSegments, kAbort };

  void begin(Kind kind, coe::ObjectAddress object);
  void ask_first(Nanoseconds now);
  void send(Nanoseconds now);
  void go_on(Nanoseconds now);
  void take_answer(Nanoseconds now);
  void take_sdo(const coe::ResponseView& response, Nanoseconds now);
  void take_upload(const coe::ResponseView& response, Nanoseconds now);
  void take_upload_segment(const coe::ResponseView& response, Nanoseconds now);
  void ask_segment(bool toggle, Nanoseconds now);
  void send_segment(bool toggle, Nanoseconds now);
  void take_fragment(Nanoseconds now);
  void pass_over(Nanoseconds now);
  void refuse(std::uint32_t abort_code, const BriefError& why, Nanoseconds now);
  void fail_with(const BriefError& why);
  void succeed() { step_ = Step::kOver; }
  [[nodiscard]] bool awaits(const coe::ResponseView& response) const;

  MailboxTransfer transfer_;
  std::vector<std::uint8_t> message_;  // behind the mailbox header
  Kind kind_ = Kind::kUpload;
  Step step_ = Step::kOver;
  coe::ObjectAddress object_;
  bool complete_access_ = false, toggle_ = false, emergency_ = false;
  std::span<const std::uint8_t> rest_;            // still to be downloaded
  std::vector<std::uint8_t>* into_ = nullptr;     // of uploads
  std::size_t limit_ = 0, begin_ = 0, size_ = 0;  // at most; where the data begin; as announced
  coe::InformationRequest information_;
  int fragments_left_ = -1;  // after the last one, -1 before the first
  int stale_ = 0;
  std::optional<BriefError> failure_;
};

}  // namespace syncline
