<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>CutShortDialog</name>
        <message numerus="yes">
            <source>%n more write(s) follow.</source>
            <translation>
                <numerusform>%n more write follows.</numerusform>
                <numerusform>%n more writes follow.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>DeviceEditor</name>
        <message numerus="yes">
            <source>%n slave(s), cycle %1</source>
            <translation>
                <numerusform>%n slave, cycle %1</numerusform>
                <numerusform>%n slaves, cycle %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Events</name>
        <message numerus="yes">
            <source>Process data watchdog expired (%n time(s))</source>
            <translation>
                <numerusform>Process data watchdog expired (%n time)</numerusform>
                <numerusform>Process data watchdog expired (%n times)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Propagation delays measured again: %n slave(s) to correct, by %1 at most</source>
            <translation>
                <numerusform>Propagation delays measured again: %n slave to correct, by %1 at most</numerusform>
                <numerusform>Propagation delays measured again: %n slaves to correct, by %1 at most</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>PDI watchdog expired (%n time(s)): the firmware is silent</source>
            <translation>
                <numerusform>PDI watchdog expired (%n time): the firmware is silent</numerusform>
                <numerusform>PDI watchdog expired (%n times): the firmware is silent</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Distributed clocks initialised: %n slave(s), reference clock at position %1</source>
            <translation>
                <numerusform>Distributed clocks initialised: %n slave, reference clock at position %1</numerusform>
                <numerusform>Distributed clocks initialised: %n slaves, reference clock at position %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) lost</source>
            <translation>
                <numerusform>%n frame lost</numerusform>
                <numerusform>%n frames lost</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n event(s) were lost: the queue was full</source>
            <translation>
                <numerusform>%n event was lost: the queue was full</numerusform>
                <numerusform>%n events were lost: the queue was full</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline (%2 of them told as lost before)</source>
            <translation>
                <numerusform>%n frame back late, up to %1 after the deadline (%2 of them told as lost before)</numerusform>
                <numerusform>%n frames back late, up to %1 after the deadline (%2 of them told as lost before)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline</source>
            <translation>
                <numerusform>%n frame back late, up to %1 after the deadline</numerusform>
                <numerusform>%n frames back late, up to %1 after the deadline</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) left out, the host sent nothing for up to %1</source>
            <translation>
                <numerusform>%n cycle left out, the host sent nothing for up to %1</numerusform>
                <numerusform>%n cycles left out, the host sent nothing for up to %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Slaves out of sync, deviation %1; %n slave(s) over the limit</source>
            <translation>
                <numerusform>Slaves out of sync, deviation %1; %n slave over the limit</numerusform>
                <numerusform>Slaves out of sync, deviation %1; %n slaves over the limit</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>StatusPanel</name>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n slave</numerusform>
                <numerusform>%n slaves</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Units</name>
        <message numerus="yes">
            <source>%n Byte(s)</source>
            <translation>
                <numerusform>%n byte</numerusform>
                <numerusform>%n bytes</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n Bit(s)</source>
            <translation>
                <numerusform>%n bit</numerusform>
                <numerusform>%n bits</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Workspace</name>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>%n slave found on %1</numerusform>
                <numerusform>%n slaves found on %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>SyncSettingsEditor</name>
        <message numerus="yes">
            <source>%1 (%n miss(es) in a row)</source>
            <translation>
                <numerusform>%1 (%n miss in a row)</numerusform>
                <numerusform>%1 (%n misses in a row)</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>FoundDialog</name>
        <message numerus="yes">
            <source>%n match(es)</source>
            <translation>
                <numerusform>%n matches</numerusform>
                <numerusform>%n match</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n additional</source>
            <translation>
                <numerusform>%n additional</numerusform>
                <numerusform>%n additional</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n missing</source>
            <translation>
                <numerusform>%n missing</numerusform>
                <numerusform>%n missing</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n moved</source>
            <translation>
                <numerusform>%n moved</numerusform>
                <numerusform>%n moved</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n wired otherwise</source>
            <translation>
                <numerusform>%n wired otherwise</numerusform>
                <numerusform>%n wired otherwise</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n in another revision</source>
            <translation>
                <numerusform>%n in another revision</numerusform>
                <numerusform>%n in another revision</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n other device(s)</source>
            <translation>
                <numerusform>%n other device</numerusform>
                <numerusform>%n other devices</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</source>
            <translation>
                <numerusform>%n slave of this bus is running. It was only looked at and nothing was written, so some of what it is may not be known.</numerusform>
                <numerusform>%n slaves of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ImportCommands</name>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>A project was made of %1; exported again, %n command would differ.</numerusform>
                <numerusform>A project was made of %1; exported again, %n commands would differ.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n new device(s) of %1 are in the catalogue.</source>
            <translation>
                <numerusform>%n new device of %1 is in the catalogue.</numerusform>
                <numerusform>%n new devices of %1 are in the catalogue.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>RecoveryDialog</name>
        <message numerus="yes">
            <source>kept %1, %n slave(s)</source>
            <translation>
                <numerusform>kept %1, %n slave</numerusform>
                <numerusform>kept %1, %n slaves</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>RunBar</name>
        <message numerus="yes">
            <source>The machine does not run what the project says: %n difference(s).</source>
            <translation>
                <numerusform>The machine does not run what the project says: %n difference.</numerusform>
                <numerusform>The machine does not run what the project says: %n differences.</numerusform>
            </translation>
        </message>
    </context>
</TS>
