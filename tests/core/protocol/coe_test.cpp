// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "byte_helpers.h"

namespace syncline::coe {
namespace {

using test::Bytes;
using test::from_hex;

Bytes some_bytes(int low, int high) {
  const auto size = static_cast<std::size_t>(*rc::gen::inRange(low, high));
  return *rc::gen::container<Bytes>(size, rc::gen::arbitrary<std::uint8_t>());
}

ObjectAddress any_object() { return {*rc::gen::arbitrary<std::uint16_t>(), *rc::gen::arbitrary<std::uint8_t>()}; }

template <class Transfer>
Transfer any_transfer() {
  Transfer transfer;
  transfer.object = any_object();
  transfer.complete_access = *rc::gen::arbitrary<bool>();
  transfer.expedited = *rc::gen::arbitrary<bool>();
  transfer.data = transfer.expedited ? some_bytes(1, 5) : some_bytes(0, 300);
  transfer.complete_size = static_cast<std::uint32_t>(transfer.data.size());
  if (!transfer.expedited) transfer.complete_size += static_cast<std::uint32_t>(*rc::gen::inRange(0, 1000));
  return transfer;
}

template <class Segment>
Segment any_segment() {
  return {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), some_bytes(0, 300)};
}

Request any_request() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return any_transfer<DownloadRequest>();
    case 1:
      return any_segment<DownloadSegmentRequest>();
    case 2:
      return UploadRequest{any_object(), *rc::gen::arbitrary<bool>()};
    case 3:
      return UploadSegmentRequest{*rc::gen::arbitrary<bool>()};
    default:
      return Abort{any_object(), *rc::gen::arbitrary<std::uint32_t>()};
  }
}

Response any_response() {
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return DownloadResponse{any_object()};
    case 1:
      return DownloadSegmentResponse{*rc::gen::arbitrary<bool>()};
    case 2:
      return any_transfer<UploadResponse>();
    case 3:
      return any_segment<UploadSegmentResponse>();
    case 4:
      return Abort{any_object(), *rc::gen::arbitrary<std::uint32_t>()};
    default:
      return Emergency{*rc::gen::arbitrary<std::uint16_t>(), *rc::gen::arbitrary<std::uint8_t>(),
                       *rc::gen::arbitrary<std::array<std::uint8_t, 5>>()};
  }
}

TEST(Coe, ExpeditedDownloadsByHand) {
  const auto encoded = [](Bytes data) {
    return encode(Request(DownloadRequest{{0x1C12, 1}, false, true, 0, std::move(data)}));
  };
  EXPECT_EQ(encoded({0x01}), from_hex("0020 2F 121C 01 01000000"));
  EXPECT_EQ(encoded({0x00, 0x16}), from_hex("0020 2B 121C 01 00160000"));
  EXPECT_EQ(encoded({1, 2, 3}), from_hex("0020 27 121C 01 01020300"));
  EXPECT_EQ(encoded({1, 2, 3, 4}), from_hex("0020 23 121C 01 01020304"));
}

TEST(Coe, NormalDownloadByHand) {
  const DownloadRequest request{{0x1008, 0}, false, false, 6, from_hex("414243444546")};
  EXPECT_EQ(encode(Request(request)), from_hex("0020 21 0810 00 06000000 414243444546"));
  const DownloadRequest complete{{0x1C12, 0}, true, false, 4, from_hex("01000016")};
  EXPECT_EQ(encode(Request(complete)), from_hex("0020 31 121C 00 04000000 01000016"));
}

TEST(Coe, FourBytesOrMoreThanFourGoNormalWhateverIsWished) {
  EXPECT_EQ(encode(Request(DownloadRequest{{0x2000, 0}, false, true, 0, Bytes(5, 1)})),
            from_hex("0020 21 0020 00 05000000 0101010101"));
  EXPECT_EQ(encode(Request(DownloadRequest{{0x2000, 0}, false, true, 0, {}})), from_hex("0020 21 0020 00 00000000"));
}

TEST(Coe, UploadByHand) {
  EXPECT_EQ(encode(Request(UploadRequest{{0x1018, 2}, false})), from_hex("0020 40 1810 02 00000000"));
  EXPECT_EQ(encode(Request(UploadRequest{{0x1018, 1}, true})), from_hex("0020 50 1810 01 00000000"));
  const auto answer = decode_response(from_hex("0030 4B 321C 01 02000000"));
  ASSERT_TRUE(answer);
  EXPECT_EQ(std::get<UploadResponse>(*answer), (UploadResponse{{0x1C32, 1}, false, true, 2, {2, 0}}));
  const auto normal = decode_response(from_hex("0030 41 0810 00 06000000 4142"));  // the rest comes in segments
  ASSERT_TRUE(normal);
  EXPECT_EQ(std::get<UploadResponse>(*normal), (UploadResponse{{0x1008, 0}, false, false, 6, from_hex("4142")}));
}

TEST(Coe, SegmentsByHand) {
  EXPECT_EQ(encode(Request(DownloadSegmentRequest{true, true, {0xAA}})), from_hex("0020 1D AA 000000000000"));
  EXPECT_EQ(encode(Request(DownloadSegmentRequest{false, false, Bytes(9, 0x11)})),
            from_hex("0020 00 111111111111111111"));
  EXPECT_EQ(encode(Request(UploadSegmentRequest{true})), from_hex("0020 70 00000000000000"));
  EXPECT_EQ(encode(Response(DownloadSegmentResponse{true})), from_hex("0030 30 00000000000000"));
  const auto last = decode_response(from_hex("0030 0B 4142 0000000000"));  // five of seven bytes unused
  ASSERT_TRUE(last);
  EXPECT_EQ(std::get<UploadSegmentResponse>(*last), (UploadSegmentResponse{false, true, from_hex("4142")}));
}

TEST(Coe, AbortComesUnderEitherService) {
  const Abort abort{{0x1018, 9}, 0x06090011};
  EXPECT_EQ(encode(Response(abort)), from_hex("0020 80 1810 09 11000906"));
  for (const auto* text : {"0020 80 1810 09 11000906", "0030 80 1810 09 11000906"}) {
    const auto decoded = decode_response(from_hex(text));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(std::get<Abort>(*decoded), abort);
  }
  EXPECT_EQ(abort_code_text(abort.code), "subindex does not exist");
  EXPECT_EQ(abort_code_text(1), "unknown abort code");
}

TEST(Coe, EmergencyByHand) {
  const auto decoded = decode_response(from_hex("0010 01A0 11 0102030405"));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(std::get<Emergency>(*decoded), (Emergency{0xA001, 0x11, {1, 2, 3, 4, 5}}));
}

TEST(Coe, RequestsRoundTrip) {
  EXPECT_TRUE(rc::check([] {
    const auto request = any_request();
    const auto decoded = decode_request(encode(request));
    RC_ASSERT(decoded.has_value());
    RC_ASSERT((*decoded == request));
  }));
}

TEST(Coe, ResponsesRoundTrip) {
  EXPECT_TRUE(rc::check([] {
    const auto response = any_response();
    const auto decoded = decode_response(encode(response));
    RC_ASSERT(decoded.has_value());
    RC_ASSERT((*decoded == response));
  }));
}

TEST(Coe, WhatFitsAMailboxFillsIt) {
  const std::size_t mailbox = 128;
  const DownloadRequest first{{0x2000, 0}, false, false, 1000, Bytes(first_message_capacity(mailbox), 1)};
  EXPECT_EQ(encode(Request(first)).size() + 6, mailbox);
  const DownloadSegmentRequest segment{false, false, Bytes(segment_capacity(mailbox), 1)};
  EXPECT_EQ(encode(Request(segment)).size() + 6, mailbox);
}

TEST(Coe, TruncatedMessagesAreRefused) {
  for (const auto* text : {"0020 2B 121C 01 00160000", "0020 40 1810 02 00000000", "0020 80 1810 09 11000906"}) {
    const auto bytes = from_hex(text);
    const std::size_t needed = bytes[2] == 0x40 ? 6 : bytes.size();  // the upload's filler may be missing
    for (std::size_t size = 0; size < needed; ++size) {
      EXPECT_FALSE(decode_request(std::span(bytes).first(size))) << text << " " << size;
    }
    EXPECT_TRUE(decode_request(bytes));
  }
}

TEST(Coe, AnyBytesDecodeOrFail) {
  EXPECT_TRUE(rc::check([](Bytes bytes) {
    if (bytes.size() > 1 && *rc::gen::arbitrary<bool>())
      bytes[1] = static_cast<std::uint8_t>(0x10 * *rc::gen::inRange(1, 4));
    const auto request = decode_request(bytes);
    if (request) RC_ASSERT((decode_request(encode(*request)) == request));
    const auto response = decode_response(bytes);
    if (response) RC_ASSERT((decode_response(encode(*response)) == response));
  }));
}

TEST(Coe, ServicesThatAreNoSdoAreNamed) {
  EXPECT_EQ(service_of(from_hex("0080")), Service::kSdoInformation);
  EXPECT_FALSE(service_of(from_hex("00F0")));
  EXPECT_FALSE(service_of(from_hex("00")));
  EXPECT_FALSE(decode_response(from_hex("0080 81 00 0000 0000 0000")));
}

}  // namespace
}  // namespace syncline::coe
