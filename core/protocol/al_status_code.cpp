// SPDX-License-Identifier: Apache-2.0
// AL status codes (register 0x0134): the names follow ETG.1020 table 11, the hints are our own.
#include <algorithm>
#include <array>

#include "protocol/al_state.h"

namespace syncline {
namespace {

struct Row {
  std::uint16_t code;
  AlStatusCodeText text;
};

constexpr std::array<Row, 63> kCodes{{
    {0x0000, {"no error", ""}},
    {0x0001, {"unspecified error", "the vendor's diagnosis, object 0x10F3 and the device's display"}},
    {0x0002, {"no memory", "whether PDOs and SyncManager lengths exceed what the slave can hold"}},
    {0x0003, {"invalid device setup", "modules and options of the device"}},
    {0x0004, {"invalid revision", "whether the ESI revision fits the device's hardware and firmware"}},
    {0x0006, {"SII does not match the firmware", "whether the EEPROM belongs to this firmware; rewrite one of them"}},
    {0x0007, {"firmware update not successful", "the firmware file, then repeat the update"}},
    {0x000E, {"licence error", "the vendor's licence for this function"}},
    {0x0011, {"invalid requested state change", "whether a state was skipped, e.g. INIT to SAFEOP"}},
    {0x0012, {"unknown requested state", "the value written to AL control 0x0120"}},
    {0x0013, {"bootstrap not supported", "whether this device has a BOOT state"}},
    {0x0014, {"no valid firmware", "the firmware; load it in BOOT"}},
    {0x0015, {"invalid mailbox configuration in BOOT", "SM0 and SM1 against SII words 0x14 to 0x17"}},
    {0x0016,
     {"invalid mailbox configuration in PREOP",
      "address, length and control byte of SM0 and SM1 and that both are enabled"}},
    {0x0017, {"invalid SyncManager configuration", "length and control byte of SM2 and SM3 against the assigned PDOs"}},
    {0x0018, {"no valid inputs available", "what the device needs for valid inputs (supply, encoder)"}},
    {0x0019, {"no valid outputs", "that cyclic frames run with the right working counter before OP is requested"}},
    {0x001A,
     {"synchronization error",
      "late or missing frames around SYNC0: host jitter, the shift, and that the master is locked to DC"}},
    {0x001B,
     {"SyncManager watchdog", "why outputs stopped for longer than the watchdog 0x0420 (loop, working counter)"}},
    {0x001C, {"invalid SyncManager types", "order and types of the SyncManagers against 0x1C00"}},
    {0x001D, {"invalid output configuration", "that the PDOs in 0x1C12 add up to the length of SM2"}},
    {0x001E, {"invalid input configuration", "that the PDOs in 0x1C13 add up to the length of SM3"}},
    {0x001F, {"invalid watchdog configuration", "0x0400, 0x0420 and the watchdog bit in the SM control byte"}},
    {0x0020, {"slave needs cold start", "power the slave off and on"}},
    {0x0021, {"slave needs INIT", "go to INIT first"}},
    {0x0022, {"slave needs PREOP", "go to PREOP first"}},
    {0x0023, {"slave needs SAFEOP", "go to SAFEOP first"}},
    {0x0024, {"invalid input mapping", "whether every object in the TxPDOs can be mapped"}},
    {0x0025, {"invalid output mapping", "whether every object in the RxPDOs can be mapped"}},
    {0x0026, {"inconsistent settings", "that operation mode, PDOs and DC settings fit together"}},
    {0x0027, {"free run not supported", "that DC is on or SM synchronous mode is chosen (0x1C32:01)"}},
    {0x0028, {"synchronization not supported", "0x1C32:01 against the DC activation 0x0980"}},
    {0x0029, {"free run needs three buffer mode", "the control bytes of SM2 and SM3"}},
    {0x002A, {"background watchdog", "the load of the slave's processor; a longer cycle helps"}},
    {0x002B, {"no valid inputs and outputs", "cyclic frames and the device's inputs before OP is requested"}},
    {0x002C, {"fatal sync error", "why SYNC0 or SYNC1 stopped; clear 0x0981 before a new start"}},
    {0x002D, {"no sync signal", "start time 0x0990 (must lie ahead), cycle 0x09A0, activation 0x0981"}},
    {0x002E, {"cycle time too small (older slaves: invalid input FMMU)", "the smallest cycle in 0x1C32:05"}},
    {0x0030, {"invalid DC SYNC configuration", "AssignActivate against the ESI, and that it is written in PREOP"}},
    {0x0031, {"invalid DC latch configuration", "who owns the latch units (AssignActivate bits 4 and 5)"}},
    {0x0032, {"PLL error", "jitter and drift of the reference clock; wait until DC has settled before OP"}},
    {0x0033, {"DC sync IO error", "SYNC signals and cyclic frames; several sync errors came together"}},
    {0x0034, {"DC sync timeout", "that SYNC pulses and frames come in time"}},
    {0x0035, {"invalid SYNC cycle time", "that the cycle is a multiple the device supports (e.g. 125 or 250 us)"}},
    {0x0036, {"invalid SYNC0 cycle time", "0x09A0 against the multiples that the device supports"}},
    {0x0037, {"invalid SYNC1 cycle time", "0x09A4 against the ESI's factor and shift"}},
    {0x0041, {"mailbox AoE error", "the device's AoE service"}},
    {0x0042, {"mailbox EoE error", "the device's EoE settings (IP address)"}},
    {0x0043, {"mailbox CoE error", "the CoE start-up commands"}},
    {0x0044, {"mailbox FoE error", "the file transfer"}},
    {0x0045, {"mailbox SoE error", "the SoE start-up commands"}},
    {0x004F, {"mailbox VoE error", "the vendor protocol"}},
    {0x0050, {"EEPROM no access", "that the EEPROM is given to the PDI before PREOP (0x0500)"}},
    {0x0051, {"EEPROM error", "content and wiring of the EEPROM"}},
    {0x0052, {"external hardware not ready", "supply and attached hardware of the device"}},
    {0x0060, {"slave restarted locally", "why the device restarted (supply, watchdog, operator)"}},
    {0x0061, {"device identification value updated", "the identification value, then restart the slave"}},
    {0x0070, {"detected modules differ from the configured ones", "0xF050 against 0xF030"}},
    {0x0080, {"supply voltage too low", "the supply"}},
    {0x0081, {"supply voltage too high", "the supply"}},
    {0x0082, {"temperature too low", "the ambient temperature"}},
    {0x0083, {"temperature too high", "ventilation and ambient temperature"}},
    {0x00F0, {"application controller available", ""}},
}};

}  // namespace

AlStatusCodeText al_status_code_text(std::uint16_t code) {
  const auto row = std::find_if(kCodes.begin(), kCodes.end(), [code](const Row& r) { return r.code == code; });
  if (row != kCodes.end()) return row->text;
  if (code >= 0x8000) return {"vendor specific code", "the vendor's manual"};
  return {"unknown code", "the vendor's manual"};
}

}  // namespace syncline
