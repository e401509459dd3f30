<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
    <name>AcceptanceText</name>
    <message numerus="yes">
        <source>%n episode(s)</source>
        <translation><numerusform>%n episode</numerusform><numerusform>%n episodes</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation><numerusform>%n error</numerusform><numerusform>%n errors</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation><numerusform>%n warning</numerusform><numerusform>%n warnings</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>, lost %n time(s)</source>
        <translation><numerusform>, lost %n time</numerusform><numerusform>, lost %n times</numerusform></translation>
    </message>
</context>
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
    <name>CycleTable</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation><numerusform>%n more</numerusform><numerusform>%n more</numerusform></translation>
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
    <name>LinkChooser</name>
        <message numerus="yes">
            <source>Simulated bus of the %n slave(s) of the project, as they are wired there</source>
            <translation>
                <numerusform>Simulated bus of the %n slave of the project, as it is wired there</numerusform>
                <numerusform>Simulated bus of the %n slaves of the project, as they are wired there</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>OverviewPanel</name>
        <message numerus="yes">
            <source>%n do(es) not answer</source>
            <translation><numerusform>%n does not answer</numerusform><numerusform>%n do not answer</numerusform></translation>
        </message>
        <message numerus="yes">
            <source>lost %n time(s)</source>
            <translation><numerusform>lost %n time</numerusform><numerusform>lost %n times</numerusform></translation>
        </message>
    </context>
    <context>
    <name>StabilityText</name>
        <message numerus="yes">
            <source>%n gap(s)</source>
            <translation>
                <numerusform>%n gap</numerusform>
                <numerusform>%n gaps</numerusform>
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
        <message numerus="yes">
            <source>%n bit(s) forced</source>
            <translation>
                <numerusform>%n bit forced</numerusform>
                <numerusform>%n bits forced</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n other network(s) online</source>
            <translation>
                <numerusform>%n other network online</numerusform>
                <numerusform>%n other networks online</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>Sync</name>
        <message numerus="yes">
            <source>%n of %1 do(es) not answer</source>
            <translation><numerusform>%n of %1 does not answer</numerusform><numerusform>%n of %1 do not answer</numerusform></translation>
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
    <name>MachineDraft</name>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>%n slave found on %1</numerusform>
                <numerusform>%n slaves found on %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>A project was made of %1; exported again, %n command would differ.</numerusform>
                <numerusform>A project was made of %1; exported again, %n commands would differ.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) as in %1</source>
            <translation>
                <numerusform>%n slave as in %1</numerusform>
                <numerusform>%n slaves as in %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>SourceStep</name>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n slave</numerusform>
                <numerusform>%n slaves</numerusform>
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
    <name>SummaryStep</name>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n error</numerusform>
                <numerusform>%n errors</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n warning</numerusform>
                <numerusform>%n warnings</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n note</numerusform>
                <numerusform>%n notes</numerusform>
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
            <source>The machine does not run what the project says: %n change(s).</source>
            <translation>
                <numerusform>The machine does not run what the project says: %n change.</numerusform>
                <numerusform>The machine does not run what the project says: %n changes.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>SlaveObjectsPage</name>
        <message numerus="yes">
            <source>%n object(s)</source>
            <translation>
                <numerusform>%n object</numerusform>
                <numerusform>%n objects</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>&amp;Watch %n favourite(s) of %1</source>
            <translation>
                <numerusform>&amp;Watch %n favourite of %1</numerusform>
                <numerusform>&amp;Watch %n favourites of %1</numerusform>
            </translation>
        </message>
</context>
    <context>
    <name>CataloguePanel</name>
        <message numerus="yes">
            <source>None of the %n device(s) has all these words.</source>
            <translation>
                <numerusform>The %n device does not have all these words.</numerusform>
                <numerusform>None of the %n devices has all these words.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>MachineBuilding</name>
        <message numerus="yes">
            <source>%n new device(s) are in the catalogue.</source>
            <translation>
                <numerusform>%n new device is in the catalogue.</numerusform>
                <numerusform>%n new devices are in the catalogue.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>ReplaceDialog</name>
        <message numerus="yes">
            <source>%1 and %n more</source>
            <translation>
                <numerusform>%1 and %n more</numerusform>
                <numerusform>%1 and %n more</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>SlaveCommands</name>
        <message numerus="yes">
            <source>%1 was removed with %n slave(s) of its branches.</source>
            <translation>
                <numerusform>%1 was removed with %n slave of its branches.</numerusform>
                <numerusform>%1 was removed with %n slaves of its branches.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n setting(s) of the old device are gone; undo brings them back.</source>
            <translation>
                <numerusform>%n setting of the old device is gone; undo brings it back.</numerusform>
                <numerusform>%n settings of the old device are gone; undo brings them back.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>Events</name>
        <message numerus="yes">
            <source>Propagation delays measured again: %n slave(s) to correct, by %1 at most</source>
            <translation>
                <numerusform>Propagation delays measured again: %n slave to correct, by %1 at most</numerusform>
                <numerusform>Propagation delays measured again: %n slaves to correct, by %1 at most</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Overview</name>
        <message numerus="yes">
            <source>%n SM2 event(s) missed</source>
            <translation>
                <numerusform>%n SM2 event missed</numerusform>
                <numerusform>%n SM2 events missed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>, last lost %1 ago, %n time(s)</source>
            <translation>
                <numerusform>, last lost %1 ago, %n time</numerusform>
                <numerusform>, last lost %1 ago, %n times</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) before</source>
            <translation><numerusform>%n cycle before</numerusform><numerusform>%n cycles before</numerusform></translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) later</source>
            <translation><numerusform>%n cycle later</numerusform><numerusform>%n cycles later</numerusform></translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) do(es) not answer</source>
            <translation><numerusform>%n slave does not answer</numerusform><numerusform>%n slaves do not answer</numerusform></translation>
        </message>
    </context>
    <context>
        <name>EniModel</name>
        <message numerus="yes">
            <source>… %n line(s) …</source>
            <translation>
                <numerusform>… %n line …</numerusform>
                <numerusform>… %n lines …</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>EniPage</name>
        <message numerus="yes">
            <source>%n error(s) of the project stand against this ENI.</source>
            <translation>
                <numerusform>%n error of the project stands against this ENI.</numerusform>
                <numerusform>%n errors of the project stand against this ENI.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n line(s) added</source>
            <translation>
                <numerusform>%n line added</numerusform>
                <numerusform>%n lines added</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n removed</source>
            <translation>
                <numerusform>%n removed</numerusform>
                <numerusform>%n removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n altered</source>
            <translation>
                <numerusform>%n altered</numerusform>
                <numerusform>%n altered</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n error</numerusform>
                <numerusform>%n errors</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n warning</numerusform>
                <numerusform>%n warnings</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n note</numerusform>
                <numerusform>%n notes</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ComparisonModel</name>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n difference</numerusform>
                <numerusform>%n differences</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>CompareDialog</name>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n difference</numerusform>
                <numerusform>%n differences</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>(%n of them are changes of the project; the others follow from these, or change nothing)</source>
            <translation>
                <numerusform>(%n of them is a change of the project; the others follow from it, or change nothing)</numerusform>
                <numerusform>(%n of them are changes of the project; the others follow from these, or change nothing)</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>SlaveHistoryPage</name>
        <message numerus="yes">
            <source>Acknowledge %n message(s) of %1?</source>
            <translation>
                <numerusform>Acknowledge %n message of %1?</numerusform>
                <numerusform>Acknowledge %n messages of %1?</numerusform>
            </translation>
        </message>
</context>
    <context>
        <name>WelcomePage</name>
        <message numerus="yes">
            <source>%n more in New Machine</source>
            <translation>
                <numerusform>%n more in New Machine</numerusform>
                <numerusform>%n more in New Machine</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>InitCommandsPage</name>
    <message numerus="yes">
        <source>%n command(s), in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, those of registers below.</source>
        <translation>
            <numerusform>%n command, in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, those of registers below.</numerusform>
            <numerusform>%n commands, in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, those of registers below.</numerusform>
        </translation>
    </message>
        <message numerus="yes">
            <source>%n zero byte(s)</source>
            <translation>
                <numerusform>%n zero byte</numerusform>
                <numerusform>%n zero bytes</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n repeat(s)</source>
            <translation>
                <numerusform>%n repeat</numerusform>
                <numerusform>%n repeats</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>NetworkCommands</name>
        <message numerus="yes">
            <source>Its %n slave(s) go with it. That cannot be undone, but until the project is saved the file keeps it.</source>
            <translation>
                <numerusform>Its %n slave goes with it. That cannot be undone, but until the project is saved the file keeps it.</numerusform>
                <numerusform>Its %n slaves go with it. That cannot be undone, but until the project is saved the file keeps it.</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>FindingFixes</name>
        <message numerus="yes">
            <source>Set %1 of %n slave(s) to %2</source>
            <translation>
                <numerusform>Set %1 of %n slave to %2</numerusform>
                <numerusform>Set %1 of %n slaves to %2</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>VariablesPage</name>
        <message numerus="yes">
            <source>%n input(s) not known: they do not come back, or their slaves exchange none</source>
            <translation>
                <numerusform>%n input not known: it does not come back, or its slave exchanges none</numerusform>
                <numerusform>%n inputs not known: they do not come back, or their slaves exchange none</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>SyncUnitModel</name>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n slave</numerusform>
                <numerusform>%n slaves</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>syncline::ui::SlavesView</name>
        <message numerus="yes">
            <source>%1 (and %n more here)</source>
            <translation>
                <numerusform>%1 (and %n more here)</numerusform>
                <numerusform>%1 (and %n more here)</numerusform>
            </translation>
        </message>
</context>
    <context>
    <name>BlackBoxText</name>
        <message numerus="yes">
            <source>%n file(s), %1</source>
            <translation>
                <numerusform>%n file, %1</numerusform>
                <numerusform>%n files, %1</numerusform>
            </translation>
        </message>
    </context>
<context>
    <name>StartBar</name>
        <message numerus="yes">
            <source>(%n further slave(s) in the messages)</source>
            <translation>
                <numerusform>(%n further slave in the messages)</numerusform>
                <numerusform>(%n further slaves in the messages)</numerusform>
            </translation>
        </message>
</context>
</TS>
