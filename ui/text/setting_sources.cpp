// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "ui/text/setting_text.h"

namespace syncline::ui {
namespace {

// The words of core/settings that fields show once more, where lupdate can see them: core knows no Qt. A test compares
// the two.
constexpr const char* kSources[] = {
    QT_TRANSLATE_NOOP("Setting", "Name"),
    QT_TRANSLATE_NOOP("Setting", "Cycle time"),
    QT_TRANSLATE_NOOP("Setting", "Overlap inputs and outputs"),
    QT_TRANSLATE_NOOP("Setting", "Bring back lost slaves"),
    QT_TRANSLATE_NOOP("Setting", "Tries to leave an error state"),
    QT_TRANSLATE_NOOP("Setting", "Start without missing slaves"),
    QT_TRANSLATE_NOOP("Setting", "Distributed clocks"),
    QT_TRANSLATE_NOOP("Setting", "Reference clock"),
    QT_TRANSLATE_NOOP("Setting", "Show 64-bit system time"),
    QT_TRANSLATE_NOOP("Setting", "Master synchronisation"),
    QT_TRANSLATE_NOOP("Setting", "Send to SYNC0"),
    QT_TRANSLATE_NOOP("Setting", "In-sync limit"),
    QT_TRANSLATE_NOOP("Setting", "Settle time"),
    QT_TRANSLATE_NOOP("Setting", "Monitor the sync window"),
    QT_TRANSLATE_NOOP("Setting", "Limit 2ⁿ − 1"),
    QT_TRANSLATE_NOOP("Setting", "Station address"),
    QT_TRANSLATE_NOOP("Setting", "Alias"),
    QT_TRANSLATE_NOOP("Setting", "Vendor"),
    QT_TRANSLATE_NOOP("Setting", "Product code"),
    QT_TRANSLATE_NOOP("Setting", "Revision"),
    QT_TRANSLATE_NOOP("Setting", "Serial number"),
    QT_TRANSLATE_NOOP("Setting", "Mode"),
    QT_TRANSLATE_NOOP("Setting", "Potential reference clock"),
    QT_TRANSLATE_NOOP("Setting", "Sync Unit Cycle"),
    QT_TRANSLATE_NOOP("Setting", "Cycle"),
    QT_TRANSLATE_NOOP("Setting", "Shift"),
    QT_TRANSLATE_NOOP("Setting", "Error limit"),
    QT_TRANSLATE_NOOP("Setting", "Type"),
    QT_TRANSLATE_NOOP("Setting", "Outputs (RxPDO)"),
    QT_TRANSLATE_NOOP("Setting", "Inputs (TxPDO)"),
    QT_TRANSLATE_NOOP("Setting", "First with DC"),
    QT_TRANSLATE_NOOP("Setting", "Off (no DC commands)"),
    QT_TRANSLATE_NOOP("Setting", "As operation mode"),
    QT_TRANSLATE_NOOP("Setting", "Off"),
    QT_TRANSLATE_NOOP("Setting", "Bus shift"),
    QT_TRANSLATE_NOOP("Setting", "Master shift"),
    QT_TRANSLATE_NOOP("Setting", "Master reference clock"),
    QT_TRANSLATE_NOOP("Setting", "Adapter reference clock"),
    QT_TRANSLATE_NOOP("Setting", "External clock (DCX)"),
    QT_TRANSLATE_NOOP("Setting", "Master shift by application"),
    QT_TRANSLATE_NOOP("Setting", "Free run"),
    QT_TRANSLATE_NOOP("Setting", "SM event"),
    QT_TRANSLATE_NOOP("Setting", "SYNC0"),
    QT_TRANSLATE_NOOP("Setting", "SYNC1"),
    QT_TRANSLATE_NOOP("Setting", "Name of the master in the ENI file."),
    QT_TRANSLATE_NOOP("Setting", "Time between two cyclic frames."),
    QT_TRANSLATE_NOOP("Setting",
                      "Inputs and outputs of a slave share logical addresses, which halves the cyclic frame."),
    QT_TRANSLATE_NOOP(
        "Setting",
        "Slaves that come back (cable healed, power back) are set up again and led to the state of the bus."),
    QT_TRANSLATE_NOOP(
        "Setting", "How often an error state is acknowledged and the state requested again; 0 leaves it to the user."),
    QT_TRANSLATE_NOOP("Setting", "Goes online with the slaves that are there; the others join when they appear."),
    QT_TRANSLATE_NOOP("Setting", "Distributed clocks for the whole bus."),
    QT_TRANSLATE_NOOP("Setting",
                      "Position of the slave whose clock all others follow; auto is the first slave with DC."),
    QT_TRANSLATE_NOOP("Setting", "Reads and shows 64 bits of the system time (0x0910)."),
    QT_TRANSLATE_NOOP("Setting", "How the send time of the frames and the reference clock are brought together."),
    QT_TRANSLATE_NOOP("Setting", "Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle."),
    QT_TRANSLATE_NOOP("Setting", "Largest control error that still counts as in sync; 0 is 4000 ns."),
    QT_TRANSLATE_NOOP("Setting", "Time inside that limit before the controller counts as in sync; 0 is 1500 ms."),
    QT_TRANSLATE_NOOP("Setting", "Watches the wire-ored system time difference of all slaves (0x092C)."),
    QT_TRANSLATE_NOOP("Setting", "Limit of the sync window: 2^exponent - 1 ns."),
    QT_TRANSLATE_NOOP("Setting", "Time inside the window before the bus counts as in sync."),
    QT_TRANSLATE_NOOP("Setting", "Name of the slave in the ENI file."),
    QT_TRANSLATE_NOOP("Setting", "Address that the master gives the slave (0x0010)."),
    QT_TRANSLATE_NOOP("Setting", "Address in the slave's EEPROM (0x0012); 0 is none."),
    QT_TRANSLATE_NOOP("Setting", "Compares the vendor in the slave's EEPROM with the configured one at start-up."),
    QT_TRANSLATE_NOOP("Setting", "Compares the product in the slave's EEPROM with the configured one at start-up."),
    QT_TRANSLATE_NOOP("Setting", "Compares the revision in the slave's EEPROM with the configured one at start-up."),
    QT_TRANSLATE_NOOP("Setting", "Compares the serial in the slave's EEPROM with the configured one at start-up."),
    QT_TRANSLATE_NOOP(
        "Setting",
        "Operation mode of distributed clocks; where the ESI gives a mode its own PDOs, they are assigned too."),
    QT_TRANSLATE_NOOP("Setting", "Marks the slave as a possible reference clock in the ENI."),
    QT_TRANSLATE_NOOP(
        "Setting", "Sync Unit Cycle of SYNC0: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI."),
    QT_TRANSLATE_NOOP("Setting", "Cycle of SYNC0 (0x09A0), before the factor."),
    QT_TRANSLATE_NOOP("Setting", "Shift of SYNC0; auto as in the ESI."),
    QT_TRANSLATE_NOOP(
        "Setting", "Sync Unit Cycle of SYNC1: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI."),
    QT_TRANSLATE_NOOP("Setting", "Cycle of SYNC1 (0x09A4), before the factor."),
    QT_TRANSLATE_NOOP("Setting", "Shift of SYNC1; auto as in the ESI."),
    QT_TRANSLATE_NOOP("Setting",
                      "Error counter (3 more for a missed SM event, 1 less for a good one) at which the device gives "
                      "up (0x10F1:02); 0 never, auto leaves the device's default."),
    QT_TRANSLATE_NOOP("Setting",
                      "What starts the device's cycle (0x1C32:01 and 0x1C33:01); auto as the operation mode says."),
    QT_TRANSLATE_NOOP("Setting", "RxPDOs (outputs) in the order in which they lie in the process data."),
    QT_TRANSLATE_NOOP("Setting", "TxPDOs (inputs) in the order in which they lie in the process data."),
};

}  // namespace

std::span<const char* const> translatableSettings() { return kSources; }

}  // namespace syncline::ui
