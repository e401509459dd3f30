// SPDX-License-Identifier: Apache-2.0
#include "engine/slave_eeprom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "engine/eeprom_journal.h"
#include "engine/open_bus.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_address.h"
#include "master/sii/sii_writer.h"
#include "reasons/because.h"
#include "support/text_bytes.h"
#include "support/whole_file.h"

namespace syncline {
namespace {

/// Names the slave in errors that know only that there is one.
Error with_slave(Error error, std::uint16_t position) {
  if (error.code == ErrorCode::kSii) error.subject = fmt::format("slave {}", position);
  return error;
}

template <class Work>
auto with_slave_of(const EepromRequest& request, Work work)
    -> decltype(work(std::declval<Bus&>(), std::declval<SlaveAddress>())) {
  auto opened = OpenBus::open_for_slave(request.open(request.link), request.position, request.cancel);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  auto result = work(bus, SlaveAddress::at_position(request.position));
  if (!result) return tl::unexpected(with_slave(result.error(), request.position));
  return result;
}

/// Words that are neither the one's nor the other's.
std::size_t foreign_words(std::span<const std::uint8_t> now, const EepromJournal& journal) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < journal.before.size(); i += 2) {
    const auto is = [&](const std::vector<std::uint8_t>& image) {
      return now[i] == image[i] && now[i + 1] == image[i + 1];
    };
    if (i + 1 >= now.size() || (!is(journal.before) && !is(journal.after))) ++count;
  }
  return count;
}

/// Writes by `write` with a journal around it.
template <class Write>
Result<SiiWriteReport> with_journal(const EepromRequest& request, Write write) {
  bool kept = false;
  const auto keep = [&](std::span<const std::uint8_t> before, std::span<const std::uint8_t> after) -> Status {
    EepromJournal journal{
        request.link, request.position, {}, {before.begin(), before.end()}, {after.begin(), after.end()}};
    // Half a write of a program that was killed is nothing that anybody wants back.
    const auto old = find_journal(request.link, request.position);
    if (old && old->before.size() == before.size() && foreign_words(before, *old) <= 1) journal.before = old->before;
    kept = true;
    return keep_journal(journal);
  };
  auto report =
      with_slave_of(request, [&](Bus& bus, const SlaveAddress& slave) { return write(bus, slave, SiiIntent(keep)); });
  // An error that leaves the EEPROM half written keeps its journal: the next start can try again.
  const bool whole = report || report.error().code == ErrorCode::kCancelled || old_content_is_back(report.error());
  if (whole && (kept || report)) drop_journal(request.link, request.position);
  return report;
}

}  // namespace

Result<std::size_t> save_eeprom(const EepromRequest& request, const std::string& path) {
  const auto bytes =
      with_slave_of(request, [](Bus& bus, const SlaveAddress& slave) { return read_eeprom(bus, slave); });
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto status = write_whole_file(path, *bytes); !status) return tl::unexpected(status.error());
  return bytes->size();
}

Result<SiiWriteReport> load_eeprom(const EepromRequest& request, const std::string& path) {
  const auto image = read_whole_file(path);
  if (!image) return tl::unexpected(image.error());
  return with_journal(request, [&](Bus& bus, const SlaveAddress& slave, const SiiIntent& intent) {
    return write_eeprom(bus, slave, bytes_of(*image), {}, intent);
  });
}

Result<SiiWriteReport> set_eeprom_alias(const EepromRequest& request, std::uint16_t alias) {
  if (find_journal(request.link, request.position)) {
    return fail(ErrorCode::kSii, fmt::format("slave {}", request.position),
                because("a write of it was cut short; end that first with \"sii finish\", or write a whole image"));
  }
  return with_journal(request, [&](Bus& bus, const SlaveAddress& slave, const SiiIntent& intent) {
    return write_alias(bus, slave, alias, intent);
  });
}

Result<SiiWriteReport> finish_eeprom(const EepromRequest& request, bool undo) {
  const auto journal = find_journal(request.link, request.position);
  if (!journal) {
    return fail(ErrorCode::kBadValue, fmt::format("slave {} on {}", request.position, request.link),
                because("no EEPROM write of this slave was cut short"));
  }
  return with_journal(
      request, [&](Bus& bus, const SlaveAddress& slave, const SiiIntent& intent) -> Result<SiiWriteReport> {
        const auto now = read_eeprom(bus, slave, {}, journal->before.size());
        if (!now) return tl::unexpected(now.error());
        if (foreign_words(*now, *journal) > 1) {
          return fail(ErrorCode::kSii, "slave",
                      because("it holds neither what was there nor what was to be written: another slave, or written "
                              "since; write the image that it is to have with \"sii write\""));
        }
        return write_image(bus, slave, undo ? journal->before : journal->after, intent);
      });
}

}  // namespace syncline
