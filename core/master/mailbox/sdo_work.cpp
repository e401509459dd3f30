// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sdo_work.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/overloaded.h"

namespace syncline {
namespace {

constexpr std::size_t kExpeditedMax = 4;
constexpr std::uint32_t kToggleError = 0x05030000, kGeneralError = 0x08000000, kLengthError = 0x06070010,
                        kMemoryError = 0x05040005;
/// Stale answers in front of the one that was asked for.
constexpr int kMostStale = 16;

BriefError aborted(std::uint32_t code) { return {.code = ErrorCode::kSdoAbort, .received = code}; }

}  // namespace

void SdoWork::use(SlaveMailbox& mailbox) {
  transfer_.use(mailbox);
  message_.reserve(std::max<std::size_t>(mailbox.port.send.length, 2 * kExpeditedMax + 2));
  step_ = Step::kOver;
}

void SdoWork::begin(SdoWork::Kind kind, coe::ObjectAddress object) {
  kind_ = kind;
  object_ = object;
  step_ = Step::kBegin;
  toggle_ = emergency_ = false;
  stale_ = 0;
  failure_.reset();
}

void SdoWork::upload(coe::ObjectAddress object, bool complete_access, std::vector<std::uint8_t>& into,
                     std::size_t limit) {
  begin(Kind::kUpload, object);
  complete_access_ = complete_access;
  into_ = &into;
  begin_ = into.size();
  limit_ = limit;
}

void SdoWork::download(coe::ObjectAddress object, bool complete_access, std::span<const std::uint8_t> data) {
  begin(Kind::kDownload, object);
  complete_access_ = complete_access;
  rest_ = data;
}

void SdoWork::ask(const coe::InformationRequest& request, std::vector<std::uint8_t>& into, std::size_t limit) {
  begin(Kind::kInformation, {});
  information_ = request;
  into_ = &into;
  begin_ = into.size();
  limit_ = limit;
  fragments_left_ = -1;
}

void SdoWork::give_up(const BriefError& why) {
  transfer_.give_up();
  fail_with(why);
}

std::string SdoWork::subject() const {
  const auto name = transfer_.mailbox() == nullptr ? std::string() : transfer_.mailbox()->port.name;
  if (kind_ != Kind::kInformation)
    return fmt::format("{}, object 0x{:04X}:{:02X}", name, object_.index, object_.sub_index);
  return std::visit(Overloaded{[&](const coe::ObjectListRequest&) { return name + ", object list"; },
                               [&](const coe::ObjectDescriptionRequest& r) {
                                 return fmt::format("{}, description of 0x{:04X}", name, r.index);
                               },
                               [&](const coe::EntryDescriptionRequest& r) {
                                 return fmt::format("{}, description of 0x{:04X}:{:02X}", name, r.index, r.sub_index);
                               }},
                    information_);
}

Status SdoWork::result() const {
  if (!failure_) return {};
  return fail(failure_->about(subject()));
}

void SdoWork::fail_with(const BriefError& why) {
  step_ = Step::kOver;
  failure_ = why;
}

/// Ends the transfer on the slave's side too, so that it does not wait for its next part.
void SdoWork::refuse(std::uint32_t abort_code, const BriefError& why, Nanoseconds now) {
  failure_ = why;
  step_ = Step::kAbort;
  message_.clear();
  append(message_, coe::Abort{object_, abort_code});
  transfer_.tell(MailboxType::kCoe, message_, now);
  if (transfer_.over()) step_ = Step::kOver;
}

// ---- requests -----------------------------------------------------------------------------------

void SdoWork::send(Nanoseconds now) { transfer_.ask(MailboxType::kCoe, message_, now); }

void SdoWork::ask_first(Nanoseconds now) {
  step_ = Step::kFirst;
  message_.clear();
  if (kind_ == Kind::kUpload) append(message_, coe::UploadRequest{object_, complete_access_});
  if (kind_ == Kind::kInformation) append(message_, information_);
  if (kind_ == Kind::kDownload) {
    const bool expedited = !complete_access_ && !rest_.empty() && rest_.size() <= kExpeditedMax;
    const auto room = coe::first_message_capacity(transfer_.mailbox()->port.send.length);
    const auto first = expedited ? rest_ : rest_.first(std::min(rest_.size(), room));
    coe::append_download(message_, object_, complete_access_, expedited, static_cast<std::uint32_t>(rest_.size()),
                         first);
    rest_ = rest_.subspan(first.size());
  }
  send(now);
}

void SdoWork::send_segment(bool toggle, Nanoseconds now) {
  step_ = Step::kSegments;
  toggle_ = toggle;
  const auto size = std::min(rest_.size(), coe::segment_capacity(transfer_.mailbox()->port.send.length));
  if (size == 0) return refuse(kGeneralError, protocol_error("the mailbox holds no segment"), now);
  message_.clear();
  coe::append_download_segment(message_, toggle, size == rest_.size(), rest_.first(size));
  rest_ = rest_.subspan(size);
  send(now);
}

void SdoWork::ask_segment(bool toggle, Nanoseconds now) {
  step_ = Step::kSegments;
  toggle_ = toggle;
  message_.clear();
  append(message_, coe::UploadSegmentRequest{toggle});
  send(now);
}

Datagram* SdoWork::next(Nanoseconds now) {
  if (step_ == Step::kBegin) ask_first(now);
  auto* datagram = over() ? nullptr : transfer_.next(now);
  go_on(now);
  return over() ? nullptr : datagram;
}

void SdoWork::take(Nanoseconds now) {
  transfer_.take(now);
  go_on(now);
}

/// What a step brings may be over at once.
void SdoWork::go_on(Nanoseconds now) {
  while (!over() && step_ != Step::kBegin && transfer_.over()) {
    emergency_ = emergency_ || transfer_.emergency();
    if (step_ == Step::kAbort) {
      step_ = Step::kOver;  // whether it arrived or not
    } else if (transfer_.failure()) {
      fail_with(*transfer_.failure());
    } else if (kind_ == Kind::kInformation) {
      take_fragment(now);
    } else {
      take_answer(now);
    }
  }
}

// ---- answers ------------------------------------------------------------------------------------

/// The late answer to a request that was given up: the right one is still to come.
void SdoWork::pass_over(Nanoseconds now) {
  if (++stale_ <= kMostStale) return transfer_.receive_instead(now);
  const auto why = protocol_error("only answers to other requests come");
  return kind_ == Kind::kInformation ? fail_with(why) : refuse(kGeneralError, why, now);
}

void SdoWork::take_answer(Nanoseconds now) {
  const auto service = coe::view_service(transfer_.data());
  const bool information = service && *service == coe::Service::kSdoInformation;
  if (information) return pass_over(now);
  const auto response = coe::view_response(transfer_.data());
  if (response) return take_sdo(*response, now);
  auto failure = response.error();
  failure.code = ErrorCode::kMailboxProtocol;
  fail_with(failure);
}

bool SdoWork::awaits(const coe::ResponseView& response) const {
  const bool upload = kind_ == Kind::kUpload;
  if (step_ == Step::kSegments) {
    return response.kind ==
           (upload ? coe::ResponseView::Kind::kUploadSegment : coe::ResponseView::Kind::kDownloadSegment);
  }
  return response.kind == (upload ? coe::ResponseView::Kind::kUpload : coe::ResponseView::Kind::kDownload) &&
         response.object == object_;
}

void SdoWork::take_sdo(const coe::ResponseView& response, Nanoseconds now) {
  if (response.kind == coe::ResponseView::Kind::kAbort) {
    const bool ours = response.object == object_ || response.object.index == 0;
    return ours ? fail_with(aborted(response.abort_code)) : pass_over(now);
  }
  if (!awaits(response)) {
    const bool initiates =
        response.kind == coe::ResponseView::Kind::kUpload || response.kind == coe::ResponseView::Kind::kDownload;
    if (initiates) return pass_over(now);
    return refuse(kGeneralError, protocol_error("the answer belongs to another request"), now);
  }
  stale_ = 0;
  if (step_ == Step::kSegments && response.toggle != toggle_)
    return refuse(kToggleError, protocol_error("the toggle bit did not alternate"), now);
  if (kind_ == Kind::kUpload)
    return step_ == Step::kFirst ? take_upload(response, now) : take_upload_segment(response, now);
  if (rest_.empty()) return succeed();
  send_segment(step_ == Step::kSegments && !toggle_, now);
}

void SdoWork::take_upload(const coe::ResponseView& response, Nanoseconds now) {
  size_ = response.expedited ? response.data.size() : response.complete_size;
  if (size_ > limit_) {
    return refuse(
        kMemoryError,
        protocol_error("the slave announces {bytes} bytes, more than the {most} that are taken", size_, limit_), now);
  }
  into_->insert(into_->end(), response.data.begin(), response.data.end());
  if (response.data.size() == size_) return succeed();
  ask_segment(false, now);
}

/// Every segment brings at least a byte and none more than was announced, so that a slave cannot keep it up for ever.
void SdoWork::take_upload_segment(const coe::ResponseView& response, Nanoseconds now) {
  const auto got = into_->size() - begin_ + response.data.size();
  if (got > size_)
    return refuse(kLengthError, protocol_error("more than the {bytes} bytes that were announced", size_), now);
  into_->insert(into_->end(), response.data.begin(), response.data.end());
  if (response.last) {
    if (got == size_) return succeed();
    return fail_with(protocol_error("{bytes} bytes where {announced} were announced", got, size_));
  }
  if (response.data.empty()) return refuse(kGeneralError, protocol_error("an empty segment that is not the last"), now);
  ask_segment(!toggle_, now);
}

void SdoWork::take_fragment(Nanoseconds now) {
  const auto fragment = coe::view_information_fragment(transfer_.data());
  if (!fragment || !coe::answers(fragment->opcode, information_)) return pass_over(now);
  if (fragments_left_ >= 0 && fragment->fragments_left + 1 != fragments_left_)
    return fail_with(protocol_error("its fragments do not follow each other"));
  fragments_left_ = fragment->fragments_left;
  if (into_->size() - begin_ + fragment->data.size() > limit_)
    return fail_with(protocol_error("its answer is longer than {bytes} bytes", limit_));
  into_->insert(into_->end(), fragment->data.begin(), fragment->data.end());
  if (fragments_left_ > 0) return transfer_.receive(now);
  const auto answer = std::span<const std::uint8_t>(*into_).subspan(begin_);
  if (const auto code = coe::information_abort_code(fragment->opcode, answer)) return fail_with(aborted(*code));
  if (fragment->opcode != coe::response_opcode(information_))
    return fail_with(protocol_error("an error that cannot be read"));
  if (coe::concerns(fragment->opcode, answer, information_)) return succeed();
  into_->resize(begin_);
  fragments_left_ = -1;
  pass_over(now);
}

}  // namespace syncline
