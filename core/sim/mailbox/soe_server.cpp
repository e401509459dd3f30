// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/soe_server.h"

#include "protocol/soe.h"
#include "support/byte_order.h"

namespace syncline::sim {
namespace {

std::vector<std::uint8_t> refusal(soe::Header header, std::uint16_t code) {
  header.error = true;
  auto answer = soe::encode(header);
  ByteWriter(answer).u16(code);
  return answer;
}

}  // namespace

std::vector<std::uint8_t> SoeServer::respond(std::span<const std::uint8_t> request) {
  auto header = soe::decode(request).value_or(soe::Header{});
  const bool writes = header.op_code == soe::OpCode::kWriteRequest;
  header.op_code = writes ? soe::OpCode::kWriteResponse : soe::OpCode::kReadResponse;
  if (request.size() < soe::Header::kSize || header.incomplete) return refusal(header, soe::kNoElement);
  const auto place = std::tuple(header.drive_no, header.idn, header.elements);
  if (writes) {
    const auto data = request.subspan(soe::Header::kSize);
    values_[place].assign(data.begin(), data.end());
    return soe::encode(header);
  }
  const auto found = values_.find(place);
  if (found == values_.end()) return refusal(header, soe::kNoIdn);
  auto answer = soe::encode(header);
  answer.insert(answer.end(), found->second.begin(), found->second.end());
  return answer;
}

}  // namespace syncline::sim
