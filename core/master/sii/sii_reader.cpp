// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "master/sii/sii_access.h"
#include "master/sii/sii_kind.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::uint32_t kWordsPerPiece = 4;
/// Each piece of a shared EEPROM is read from so many slaves.
constexpr std::size_t kWitnesses = 2;

class SiiImageReader {
 public:
  SiiImageReader(SiiAccess& access, const SiiReadOptions& options, const std::function<void(std::size_t)>& progress)
      : access_(access), options_(options), progress_(progress), contents_(access.size()), own_(access.size()) {}

  Status run() {
    if (auto status = read_own_words(); !status) return status;
    kinds_ = find_sii_kinds(own_, options_.share_kinds);
    for (auto& kind : kinds_) choose_readers(kind);
    while (std::ranges::any_of(kinds_, [](const auto& kind) { return !kind.done(); })) {
      if (auto status = read_round(); !status) return status;
      tell();
    }
    for (const auto& kind : kinds_) finish(kind);
    return {};
  }
  std::vector<SiiContent> take() { return std::move(contents_); }

 private:
  /// One piece of one kind in one round: the requests begin..end are its witnesses.
  struct Piece {
    std::size_t kind = 0;
    std::size_t begin = 0, end = 0;
  };

  Status read_own_words() {
    std::vector<std::size_t> whom;
    for (std::size_t i = 0; i < access_.size(); ++i) {
      if (access_.accessible(i)) {
        whom.push_back(i);
      } else {
        contents_[i].error =
            Error{ErrorCode::kSii, "slave", because("the EEPROM belongs to the PDI and is left to it")};
      }
    }
    for (std::uint32_t word = 0; word < kOwnSiiWords && !whom.empty(); word += kWordsPerPiece) {
      std::vector<SiiRequest> requests;
      for (const auto i : whom) requests.push_back({i, word, {}, {}});
      // Behind its own words a slave of a kind is asked for another piece than its neighbour.
      const auto next = word + kWordsPerPiece;
      const bool same = next < kOwnSiiWords || !options_.share_kinds;
      if (auto status = access_.read(requests, same ? std::optional(next) : std::nullopt); !status) return status;
      for (auto& request : requests) {
        auto& own = own_[request.slave];
        if (request.error) {
          contents_[request.slave].error = std::move(request.error);
        } else {
          own.insert(own.end(), request.data.begin(), request.data.end());
        }
      }
      std::erase_if(whom, [this](std::size_t i) { return contents_[i].error.has_value(); });
    }
    return {};
  }

  /// Nobody waits for a slow EEPROM whose words others can give.
  void choose_readers(SiiKind& kind) const {
    const auto pace = [this](std::size_t slave) { return access_.pace(slave); };
    auto& readers = kind.readers;
    if (readers.size() <= kWitnesses) return;
    std::ranges::stable_sort(readers, {}, pace);
    const auto most = 2 * pace(readers[kWitnesses - 1]);
    while (readers.size() > kWitnesses && pace(readers.back()) > most) readers.pop_back();
  }

  /// What to ask now: single slaves their next piece, slaves of a kind several pieces.
  void plan(std::vector<SiiRequest>& requests, std::vector<Piece>& pieces) const {
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      const auto& kind = kinds_[k];
      if (kind.done()) continue;
      const auto witnesses = std::min(kWitnesses, kind.readers.size());
      const auto count = std::min(kind.pieces_wanted(), kind.readers.size() / witnesses);
      for (std::size_t n = 0; n < count; ++n) {
        const auto begin = requests.size();
        for (std::size_t w = 0; w < witnesses; ++w) {
          requests.push_back({kind.readers[n * witnesses + w],
                              kind.next_word() + static_cast<std::uint32_t>(n) * kWordsPerPiece,
                              {},
                              {}});
        }
        pieces.push_back({k, begin, requests.size()});
      }
    }
  }

  Status read_round() {
    std::vector<SiiRequest> requests;
    std::vector<Piece> pieces;
    plan(requests, pieces);
    // Slaves that are all different walk through their EEPROMs in step; nobody knows the end before.
    std::optional<std::uint32_t> next;
    const bool in_step = std::ranges::all_of(requests, [&](const auto& r) { return r.word == requests[0].word; });
    if (in_step) next = requests[0].word + kWordsPerPiece;
    if (auto status = access_.read(requests, next); !status) return status;
    std::vector<std::size_t> broken;
    for (const auto& piece : pieces) {
      if (std::ranges::find(broken, piece.kind) != broken.end()) continue;
      if (!take(piece, requests)) broken.push_back(piece.kind);
    }
    return {};
  }

  /// False when nothing that follows in this round can be used.
  bool take(const Piece& piece, std::vector<SiiRequest>& requests) {
    auto& kind = kinds_[piece.kind];
    const SiiRequest* good = nullptr;
    bool differ = false;
    std::optional<Error> error;
    for (auto n = piece.begin; n < piece.end; ++n) {
      auto& request = requests[n];
      if (request.error) {
        std::erase(kind.readers, request.slave);
        error = request.error;
      } else if (good == nullptr) {
        good = &request;
      } else {
        differ = differ || good->data != request.data;
      }
    }
    if (differ) {
      dissolve(piece.kind);
      return false;
    }
    if (good == nullptr) {
      if (kind.readers.empty()) kind.give_up(*error);
      return false;
    }
    kind.append(good->data);
    return true;
  }

  void dissolve(std::size_t k) {
    const auto members = kinds_[k].members;
    kinds_[k] = SiiKind({members[0]}, own_[members[0]]);
    for (std::size_t n = 1; n < members.size(); ++n) kinds_.emplace_back(std::vector{members[n]}, own_[members[n]]);
  }

  void finish(const SiiKind& kind) {
    for (const auto member : kind.members) {
      auto& content = contents_[member];
      content.error = kind.error();
      content.bytes = own_[member];
      content.bytes.insert(content.bytes.end(), kind.bytes().begin() + 2 * kOwnSiiWords, kind.bytes().end());
      if (member != kind.members[0]) content.shared_with = kind.members[0];
    }
  }

  void tell() {
    if (!progress_) return;
    std::size_t done = static_cast<std::size_t>(
        std::ranges::count_if(contents_, [](const auto& content) { return content.error.has_value(); }));
    for (const auto& kind : kinds_) done += kind.done() ? kind.members.size() : 0;
    if (done != told_) progress_(done);
    told_ = done;
  }

  SiiAccess& access_;
  const SiiReadOptions& options_;
  const std::function<void(std::size_t)>& progress_;
  std::vector<SiiContent> contents_;
  std::vector<std::vector<std::uint8_t>> own_;
  std::vector<SiiKind> kinds_;
  std::size_t told_ = 0;
};

}  // namespace

Result<std::vector<SiiContent>> read_sii(SiiAccess& access, const SiiReadOptions& options,
                                         const std::function<void(std::size_t)>& progress) {
  SiiImageReader reader(access, options, progress);
  auto status = access.open();
  if (status) status = reader.run();
  // An EEPROM that was taken from its PDI goes back even when the reading ended early.
  auto closed = access.close();
  if (!status) return tl::unexpected(status.error());
  if (!closed) return tl::unexpected(closed.error());
  return reader.take();
}

}  // namespace syncline
