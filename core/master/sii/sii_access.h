// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/exchange/slave_address.h"

namespace syncline {

class Bus;

/// Eight bytes of one slave's EEPROM.
struct SiiRequest {
  std::size_t slave = 0;  // index into the slaves of the SiiAccess
  std::uint32_t word = 0;
  std::array<std::uint8_t, 8> data{};  // out
  std::optional<Error> error;          // out: kSii with the word in its detail
};

/// Reads through the EEPROM interfaces (0x0500 to 0x050F) of many slaves at the same time (SiiWork writes one): one
/// datagram starts a read, one fetches status, address and data of a finished one, many of them a frame. The address
/// that comes back tells which read the data belong to, so a lost or repeated frame cannot mix them up.
class SiiAccess {
 public:
  struct Options {
    bool take_ownership = true;  // false: leave an EEPROM alone that is assigned to the PDI
    bool broadcast = true;       // the slaves are the whole bus and one command may start them all
  };

  SiiAccess(Bus& bus, std::vector<SlaveAddress> slaves, Options options);

  /// Reads who owns each EEPROM; changes nothing.
  Status look();
  /// The same for who has read 0x0500 with these bytes already.
  static constexpr std::size_t kLookBytes = 4;
  void set_found(std::size_t slave, std::span<const std::uint8_t, kLookBytes> bytes);
  /// Takes the EEPROMs from their PDIs (ESC data sheet II, 0x0500) and clears old errors.
  Status open();
  /// Gives each EEPROM back to the PDI that had it. Also to be called when something failed.
  Status close();

  [[nodiscard]] std::size_t size() const { return slaves_.size(); }
  /// The slave's EEPROM was assigned to its PDI when look() looked.
  [[nodiscard]] bool was_assigned_to_pdi(std::size_t slave) const { return ports_[slave].pdi; }
  /// False when the EEPROM is the PDI's and must be left to it.
  [[nodiscard]] bool accessible(std::size_t slave) const { return options_.take_ownership || !ports_[slave].pdi; }

  /// Reads all of them, each slave at most once. An error of a slave stands in its request; the result
  /// is an error only when the bus fails or the user cancels. `next`: the word that all slaves will be
  /// asked for afterwards, so that its read can begin in the frame that ends this one.
  Status read(std::span<SiiRequest> requests, std::optional<std::uint32_t> next = std::nullopt);
  /// How long the slave's EEPROM takes for a read, as far as its reads have shown.
  [[nodiscard]] Nanoseconds pace(std::size_t slave) const { return ports_[slave].pace; }

 private:
  struct Port {
    bool looked_at = false;
    bool pdi = false;
    bool old_error = false;
    bool eight_bytes = false;
    bool reads_address_back = true;
    bool showed_address = false;           // it did so, with another one than 0
    std::optional<std::uint32_t> started;  // word of a read that is on its way or done
    Nanoseconds pace = 0;                  // from the start of a read to the first look at it
    Nanoseconds too_early = 0;             // a look that found it busy
    bool pace_shown = false;               // by a read of its own
    int calm_reads = 0;                    // since then
  };
  struct Job;

  Status start(std::vector<Job>& jobs);
  Status probe(const Job& job);
  Status fetch(std::span<const SiiRequest> requests, std::vector<Job>& jobs, std::optional<std::uint32_t> next);
  bool take(Job& job, bool looked_ahead);
  bool may_look_ahead(std::span<const SiiRequest> requests, const std::vector<Job>& jobs) const;
  void learn(const Job& job);
  Status clear_errors(std::vector<Job>& jobs);
  static constexpr std::size_t kWindowBytes = 14;  // from 0x0502, with the eight data bytes at 0x0508

  Bus& bus_;
  std::vector<SlaveAddress> slaves_;
  std::vector<Port> ports_;
  Options options_;
  bool probed_ = false;  // one EEPROM has shown how long it takes
  bool calm_ = false;    // in the latest read every look found what it came for
};

}  // namespace syncline
