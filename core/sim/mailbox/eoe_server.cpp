// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/eoe_server.h"

#include "protocol/eoe.h"

namespace syncline::sim {
namespace {

constexpr std::size_t kHeaderSize = 4;

std::vector<std::uint8_t> response(eoe::Kind kind, std::uint8_t port, std::uint16_t result) {
  eoe::Header header;
  header.kind = kind;
  header.port = port;
  header.last_fragment = true;
  header.result = result;
  return eoe::encode(header);
}

}  // namespace

std::vector<std::uint8_t> EoeServer::respond(std::span<const std::uint8_t> request) {
  const auto header = eoe::decode(request);
  if (!header) return response(eoe::Kind::kSetIpResponse, 0, eoe::kUnsupportedFrame);
  switch (header->kind) {
    case eoe::Kind::kSetIpRequest:
      parameters_.assign(request.begin() + kHeaderSize, request.end());
      return response(eoe::Kind::kSetIpResponse, header->port, eoe::kSuccess);
    case eoe::Kind::kGetIpRequest: {
      auto answer = response(eoe::Kind::kGetIpResponse, header->port, eoe::kSuccess);
      answer.insert(answer.end(), parameters_.begin(), parameters_.end());
      return answer;
    }
    case eoe::Kind::kSetFilterRequest:
      return response(eoe::Kind::kSetFilterResponse, header->port, eoe::kNoFilterSupport);
    case eoe::Kind::kGetFilterRequest:
      return response(eoe::Kind::kGetFilterResponse, header->port, eoe::kNoFilterSupport);
    default:
      return {};
  }
}

}  // namespace syncline::sim
