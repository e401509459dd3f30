// SPDX-License-Identifier: Apache-2.0
#include "app/composition/link_text.h"

#include <charconv>

#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::uint64_t kMostNetworks = 256;

Reason forms() { return because("use sim:FILE[?virtual][&seed=N][&network=N], nic:NAME or replay:FILE"); }

/// True when `option` is `key` and a number.
bool number_option(std::string_view option, std::string_view key, std::uint64_t& number) {
  if (!option.starts_with(key)) return false;
  const auto digits = option.substr(key.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc{} && end == digits.data() + digits.size();
}

Status apply_option(LinkText& link, std::string_view option, std::string_view whole) {
  if (option == "virtual") {
    link.virtual_clock = true;
    return {};
  }
  std::uint64_t number = 0;
  if (number_option(option, "seed=", number)) {
    link.seed = number;
    return {};
  }
  if (number_option(option, "network=", number) && number < kMostNetworks) {
    link.network = static_cast<unsigned>(number);
    return {};
  }
  return fail(ErrorCode::kBadValue, std::string(whole), because("unknown option '{option}'; {forms}", option, forms()));
}

}  // namespace

Result<LinkText> parse_link_text(std::string_view text) {
  const auto colon = text.find(':');
  const auto scheme = text.substr(0, colon == std::string_view::npos ? 0 : colon);
  LinkText link;
  if (scheme == "sim") {
    link.kind = LinkKind::kSimulated;
  } else if (scheme == "nic") {
    link.kind = LinkKind::kAdapter;
  } else if (scheme == "replay") {
    link.kind = LinkKind::kReplay;
  } else {
    return fail(ErrorCode::kBadValue, std::string(text), forms());
  }
  auto rest = text.substr(colon + 1);
  if (link.kind == LinkKind::kSimulated) {
    // Both "?virtual&seed=2" and "?virtual" followed by "&..." are written; '?' and '&' separate alike.
    const auto question = rest.find('?');
    auto options = question == std::string_view::npos ? std::string_view{} : rest.substr(question + 1);
    rest = rest.substr(0, question);
    while (!options.empty()) {
      const auto end = options.find('&');
      if (auto status = apply_option(link, options.substr(0, end), text); !status)
        return tl::unexpected(status.error());
      options = end == std::string_view::npos ? std::string_view{} : options.substr(end + 1);
    }
  }
  if (rest.empty()) return fail(ErrorCode::kBadValue, std::string(text), forms());
  link.target = std::string(rest);
  return link;
}

}  // namespace syncline
