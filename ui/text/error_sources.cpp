// SPDX-License-Identifier: Apache-2.0
#include "ui/text/error_text.h"

#include <QCoreApplication>

namespace syncline::ui {
namespace {

// The templates of core/protocol/error_text.cpp once more, where lupdate can see them: core knows no Qt.
// A test compares the two.
constexpr const char* kErrorSources[] = {
    QT_TRANSLATE_NOOP("Error", "The file {file} does not exist; check its name and folder."),
    QT_TRANSLATE_NOOP("Error", "The file {file} cannot be read{because}."),
    QT_TRANSLATE_NOOP("Error",
                      "The file {file} cannot be written{because}; check the folder's permissions and free "
                      "space."),
    QT_TRANSLATE_NOOP("Error", "{where}: this is not well-formed XML{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: the element <{subject}> is missing{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: the value of <{subject}> cannot be used{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: this is another kind of file; expected{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: this is not well-formed TOML{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: the key \"{subject}\" cannot be used{because}."),
    QT_TRANSLATE_NOOP("Error", "The device {subject} is not known{because}; load its ESI file."),
    QT_TRANSLATE_NOOP("Error",
                      "No ESI file describes {subject}; put the vendor's ESI file into the ESI folder {detail} "
                      "and scan again."),
    QT_TRANSLATE_NOOP("Error", "There is no setting \"{subject}\"{because}."),
    QT_TRANSLATE_NOOP("Error", "The value of {subject} cannot be used{because}."),
    QT_TRANSLATE_NOOP("Error", "The configuration of {subject} does not work out{because}."),
    QT_TRANSLATE_NOOP("Error",
                      "There is no network adapter or link \"{subject}\"{because}; list them with "
                      "\"synclinectl adapters\"."),
    QT_TRANSLATE_NOOP("Error", "The link {subject} is down{because}; check the cable and that the interface is up."),
    QT_TRANSLATE_NOOP("Error", "No permission to send raw frames on {subject}; grant it once with: {detail}"),
    QT_TRANSLATE_NOOP("Error", "Sending or receiving on {subject} failed{because}."),
    QT_TRANSLATE_NOOP("Error", "{subject} is not supported{because}."),
    QT_TRANSLATE_NOOP("Error",
                      "No answer from {subject}; check power, cabling and the working counter of the slaves "
                      "before it."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject}: working counter {received} where {expected} was expected; a slave did not "
                      "process the datagram."),
    QT_TRANSLATE_NOOP("Error",
                      "The bus has {received} slaves where {expected} were expected; compare the wiring with "
                      "the configuration."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject} is another device than configured{because}; scan again or exchange the device."),
    QT_TRANSLATE_NOOP("Error", "{subject} refused {state} and stays in {actual}: AL status code {alcode}."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject} did not reach {state} in time and is in {actual}; raise the timeout or check "
                      "what the slave waits for."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject} did not answer in its mailbox in time; the slave may be busy or its mailbox "
                      "is set up wrongly."),
    QT_TRANSLATE_NOOP("Error", "{subject} answered in its mailbox with something else than was asked{because}."),
    QT_TRANSLATE_NOOP("Error", "{subject}: the slave aborted the SDO transfer with {abort}."),
    QT_TRANSLATE_NOOP("Error", "The SII (EEPROM) of {subject} cannot be used{because}."),
    QT_TRANSLATE_NOOP("Error", "{subject}: the slave's answer differs from what the init command demands{because}."),
    QT_TRANSLATE_NOOP("Error", "{subject} is malformed{because}."),
    QT_TRANSLATE_NOOP("Error", "Distributed clocks of {subject} could not be set up{because}."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject}: the DCM error of {received} ns is beyond the limit of {expected} ns; check "
                      "the host's jitter and the clock's drift."),
    QT_TRANSLATE_NOOP("Error", "{subject} took too long{because}."),
    QT_TRANSLATE_NOOP("Error", "Cancelled."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject} is missing{because}; check its power and the cable to it, or take it out of the "
                      "configuration."),
    QT_TRANSLATE_NOOP("Error",
                      "There is a device that is not in the configuration: {subject}{because}; scan again or take it "
                      "off the bus."),
    QT_TRANSLATE_NOOP("Error",
                      "{subject} and {detail} have changed places; swap their cables, or their positions in the "
                      "configuration."),
    QT_TRANSLATE_NOOP("Error", "Wiring of {subject}: {detail}."),
    QT_TRANSLATE_NOOP("Error", "Identification of {subject}: {detail}."),
    QT_TRANSLATE_NOOP("Error", "Not read from {subject}: {detail}."),
    QT_TRANSLATE_NOOP("Error", "{subject}{because}."),
    QT_TRANSLATE_NOOP("Error", "{subject}: the slave ended the file transfer with {foe}{because}."),
    QT_TRANSLATE_NOOP("Error", "{where}: the file is beyond what is read{because}."),
    QT_TRANSLATE_NOOP("Error", "The device catalogue {file} cannot be used{because}; delete it or choose another one."),
};

}  // namespace

std::span<const char* const> translatableErrors() { return kErrorSources; }

}  // namespace syncline::ui
