// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/aoe_server.h"

#include <algorithm>
#include <utility>

#include "protocol/aoe.h"
#include "support/byte_order.h"

namespace syncline::sim {
namespace {

constexpr std::size_t kMostValues = 1024;  // a device has little memory

std::vector<std::uint8_t> response(const aoe::Header& request, std::uint32_t error_code,
                                   std::span<const std::uint8_t> data) {
  auto header = request;
  std::swap(header.target, header.source);
  header.state_flags = static_cast<std::uint16_t>(header.state_flags | aoe::Header::kResponse);
  header.error_code = error_code;
  header.length = static_cast<std::uint32_t>(data.size());
  auto answer = aoe::encode(header);
  answer.insert(answer.end(), data.begin(), data.end());
  return answer;
}

}  // namespace

std::vector<std::uint8_t> AoeServer::respond(std::span<const std::uint8_t> request) {
  const auto header = aoe::decode(request);
  if (!header || header->is_response()) return {};
  ByteReader reader(request.subspan(aoe::Header::kSize));
  const std::uint32_t group = reader.u32(), offset = reader.u32(), length = reader.u32();
  std::vector<std::uint8_t> data;
  ByteWriter result(data);
  if (reader.ok() && header->command == aoe::kWrite && length <= reader.remaining() && values_.size() < kMostValues) {
    const auto bytes = reader.take(length);
    values_[{group, offset}].assign(bytes.begin(), bytes.end());
    result.u32(0);
  } else if (reader.ok() && header->command == aoe::kRead) {
    const auto found = values_.find({group, offset});
    const auto value =
        found == values_.end() ? std::span<const std::uint8_t>{} : std::span<const std::uint8_t>(found->second);
    const auto bytes = value.first(std::min<std::size_t>(length, value.size()));
    result.u32(0).u32(static_cast<std::uint32_t>(bytes.size())).bytes(bytes);
  } else {
    return response(*header, aoe::kServiceNotSupported, {});
  }
  return response(*header, 0, data);
}

}  // namespace syncline::sim
