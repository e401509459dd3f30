<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Finding</name>
    <message>
        <source>"{name}" is the name of slave {slave}, too</source>
        <translation>"{name}" ist auch der Name von Slave {slave}</translation>
    </message>
    <message>
        <source>"{variable}" is a {type} of {bits:# bit|# bits}, which has {has}</source>
        <translation>"{variable}" ist ein {type} von {bits:# Bit|# Bits}, der {has} hat</translation>
    </message>
    <message>
        <source>"{variable}" shares bits with "{other}"</source>
        <translation>"{variable}" teilt sich Bits mit "{other}"</translation>
    </message>
    <message>
        <source>"{variable}" takes bits {first} to {last}, the image has {image}</source>
        <translation>"{variable}" belegt die Bits {first} bis {last}, das Abbild hat {image}</translation>
    </message>
    <message>
        <source>0 is what all slaves have before they are set up, so commands reach any of them</source>
        <translation>0 haben alle Slaves, bevor sie eingerichtet sind; Kommandos erreichen also irgendeinen von ihnen</translation>
    </message>
    <message>
        <source>0, 1, true or false</source>
        <translation>0, 1, true oder false</translation>
    </message>
    <message>
        <source>0x0400, 0x0420 and the watchdog bit in the SM control byte</source>
        <translation>0x0400, 0x0420 und das Watchdog-Bit im SM-Steuerbyte</translation>
    </message>
    <message>
        <source>0x0990 is set to {written}, ShiftTime says {said}</source>
        <translation>0x0990 wird auf {written} gesetzt, ShiftTime sagt {said}</translation>
    </message>
    <message>
        <source>0x09A0 against the multiples that the device supports</source>
        <translation>0x09A0 gegen die Vielfachen, die das Gerät unterstützt</translation>
    </message>
    <message>
        <source>0x09A0 is set to {written}, CycleTime0 says {said}</source>
        <translation>0x09A0 wird auf {written} gesetzt, CycleTime0 sagt {said}</translation>
    </message>
    <message>
        <source>0x09A4 against the ESI's factor and shift</source>
        <translation>0x09A4 gegen Faktor und Verschiebung der ESI</translation>
    </message>
    <message>
        <source>0x09A4 is set to {written}, CycleTime1 says {said}</source>
        <translation>0x09A4 wird auf {written} gesetzt, CycleTime1 sagt {said}</translation>
    </message>
    <message>
        <source>0x1C32:01 against the DC activation 0x0980</source>
        <translation>0x1C32:01 gegen die DC-Aktivierung 0x0980</translation>
    </message>
    <message>
        <source>0xF050 against 0xF030</source>
        <translation>0xF050 gegen 0xF030</translation>
    </message>
    <message>
        <source>1 cycle left out, the host sent nothing for up to {standstill}</source>
        <translation>1 Zyklus ausgelassen, der Host sendete bis zu {standstill} lang nichts</translation>
    </message>
    <message>
        <source>1 frame back late, {late} after the deadline</source>
        <translation>1 Frame kam zu spät zurück, {late} nach der Frist</translation>
    </message>
    <message>
        <source>1 frame back late, {late} after the deadline (told as lost before)</source>
        <translation>1 Frame kam zu spät zurück, {late} nach der Frist (er war als verloren gemeldet)</translation>
    </message>
    <message>
        <source>6 bytes of two hexadecimal digits each</source>
        <translation>6 Bytes aus je zwei Hexadezimalziffern</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; in &lt;{parent}&gt;</source>
        <translation>&lt;{element}&gt; in &lt;{parent}&gt;</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; in &lt;{parent}&gt;, {count:# time|# times}</source>
        <translation>&lt;{element}&gt; in &lt;{parent}&gt;, {count}-mal</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; is "{value}" instead of {wanted}</source>
        <translation>&lt;{element}&gt; ist "{value}" statt {wanted}</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; stands behind elements of &lt;{parent}&gt; that it has to precede</source>
        <translation>&lt;{element}&gt; steht hinter Elementen von &lt;{parent}&gt;, vor denen es stehen muss</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; stands {count:# time|# times} in &lt;{parent}&gt;, allowed are {most}</source>
        <translation>&lt;{element}&gt; steht {count}-mal in &lt;{parent}&gt;, erlaubt sind {most}</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has both &lt;{one}&gt; and &lt;{other}&gt;</source>
        <translation>&lt;{parent}&gt; hat sowohl &lt;{one}&gt; als auch &lt;{other}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has neither &lt;{one}&gt; nor &lt;{other}&gt;</source>
        <translation>&lt;{parent}&gt; hat weder &lt;{one}&gt; noch &lt;{other}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has no &lt;{element}&gt;</source>
        <translation>&lt;{parent}&gt; hat kein &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has no attribute {attribute}</source>
        <translation>&lt;{parent}&gt; hat kein Attribut {attribute}</translation>
    </message>
    <message>
        <source>A CAN cycle that does not fit the bus cycle</source>
        <translation>Ein CAN-Zyklus, der nicht zum Buszyklus passt</translation>
    </message>
    <message>
        <source>A PDI watchdog expired</source>
        <translation>Ein PDI-Watchdog lief ab</translation>
    </message>
    <message>
        <source>A PDO and the SyncManagers' lists contradict each other</source>
        <translation>Ein PDO und die Listen der SyncManager widersprechen einander</translation>
    </message>
    <message>
        <source>A PDO is assigned twice</source>
        <translation>Ein PDO ist doppelt zugeordnet</translation>
    </message>
    <message>
        <source>A PDO is described twice</source>
        <translation>Ein PDO ist doppelt beschrieben</translation>
    </message>
    <message>
        <source>A PDO lies in a SyncManager that it must not lie in</source>
        <translation>Ein PDO liegt in einem SyncManager, in dem es nicht liegen darf</translation>
    </message>
    <message>
        <source>A PDO that the device does not have</source>
        <translation>Ein PDO, das das Gerät nicht hat</translation>
    </message>
    <message>
        <source>A SYNC0 cycle does not fit the bus cycle; make it a multiple or a divisor.</source>
        <translation>Ein SYNC0-Zyklus passt nicht zum Buszyklus; ihn zu einem Vielfachen oder Teiler machen.</translation>
    </message>
    <message>
        <source>A SYNC0 cycle that the device does not take</source>
        <translation>Ein SYNC0-Zyklus, den das Gerät nicht annimmt</translation>
    </message>
    <message>
        <source>A SYNC0 cycle that the device takes with losses</source>
        <translation>Ein SYNC0-Zyklus, den das Gerät mit Verlusten annimmt</translation>
    </message>
    <message>
        <source>A SYNC1 time without SYNC1</source>
        <translation>Eine SYNC1-Zeit ohne SYNC1</translation>
    </message>
    <message>
        <source>A Sync Unit runs in a task that does not exist</source>
        <translation>Eine Sync Unit läuft in einer Task, die es nicht gibt</translation>
    </message>
    <message>
        <source>A Sync Unit that does not exist</source>
        <translation>Eine Sync Unit, die es nicht gibt</translation>
    </message>
    <message>
        <source>A SyncManager carries a PDO that the slave does not describe</source>
        <translation>Ein SyncManager trägt ein PDO, das der Slave nicht beschreibt</translation>
    </message>
    <message>
        <source>A SyncManager is set behind the request for the state that needs it</source>
        <translation>Ein SyncManager wird hinter der Anforderung des Zustands gesetzt, der ihn braucht</translation>
    </message>
    <message>
        <source>A SyncManager is set to another length than its PDOs have</source>
        <translation>Ein SyncManager wird auf eine andere Länge gesetzt, als seine PDOs haben</translation>
    </message>
    <message>
        <source>A SyncManager is set to another start than its element says</source>
        <translation>Ein SyncManager wird auf einen anderen Anfang gesetzt, als sein Element sagt</translation>
    </message>
    <message>
        <source>A SyncManager lies outside the memory for data</source>
        <translation>Ein SyncManager liegt außerhalb des Datenspeichers</translation>
    </message>
    <message>
        <source>A SyncManager needs more process data</source>
        <translation>Ein SyncManager braucht mehr Prozessdaten</translation>
    </message>
    <message>
        <source>A SyncManager that is not enabled is switched on</source>
        <translation>Ein nicht freigegebener SyncManager wird eingeschaltet</translation>
    </message>
    <message>
        <source>A SyncManager's PDOs or sizes</source>
        <translation>PDOs oder Größen eines SyncManagers</translation>
    </message>
    <message>
        <source>A SyncManager's settings</source>
        <translation>Einstellungen eines SyncManagers</translation>
    </message>
    <message>
        <source>A buffer changes only when its last byte is read or written, so that data stay old</source>
        <translation>Ein Puffer wechselt erst, wenn sein letztes Byte gelesen oder geschrieben wird, so dass Daten alt bleiben</translation>
    </message>
    <message>
        <source>A cable is healed</source>
        <translation>Ein Kabel ist wieder heil</translation>
    </message>
    <message>
        <source>A capture breaks off</source>
        <translation>Eine Aufzeichnung bricht ab</translation>
    </message>
    <message>
        <source>A capture is cut off</source>
        <translation>Ein Mitschnitt ist abgeschnitten</translation>
    </message>
    <message>
        <source>A check has a time-out of 0</source>
        <translation>Eine Prüfung hat eine Zeitgrenze von 0</translation>
    </message>
    <message>
        <source>A check waits for another state than the one requested</source>
        <translation>Eine Prüfung wartet auf einen anderen Zustand als den angeforderten</translation>
    </message>
    <message>
        <source>A clock that stepped, was not initialised or cannot follow; its loop values and its propagation delay stand in its distributed clocks.</source>
        <translation>Eine Uhr, die gesprungen ist, nicht eingerichtet wurde oder nicht folgen kann; ihre Regelwerte und ihre Laufzeit stehen bei ihren Distributed Clocks.</translation>
    </message>
    <message>
        <source>A clock that steps, or a reference clock that was exchanged; see the events of that moment.</source>
        <translation>Eine Uhr, die springt, oder eine ausgetauschte Referenzuhr; siehe die Ereignisse dieses Moments.</translation>
    </message>
    <message>
        <source>A command has either a register or a logical address, and either data or a length: readers choose differently</source>
        <translation>Ein Kommando hat entweder ein Register oder eine logische Adresse, und entweder Daten oder eine Länge: Leser wählen verschieden</translation>
    </message>
    <message>
        <source>A command has no bytes</source>
        <translation>Ein Kommando hat keine Bytes</translation>
    </message>
    <message>
        <source>A command requests another state than its transition leads to</source>
        <translation>Ein Kommando fordert einen anderen Zustand an als den, zu dem sein Übergang führt</translation>
    </message>
    <message>
        <source>A command specifier that is not 1</source>
        <translation>Ein Command Specifier, der nicht 1 ist</translation>
    </message>
    <message>
        <source>A command that no slave can carry out</source>
        <translation>Ein Kommando, das kein Slave ausführen kann</translation>
    </message>
    <message>
        <source>A command to a clock register has the wrong length</source>
        <translation>Ein Kommando an ein Uhrenregister hat die falsche Länge</translation>
    </message>
    <message>
        <source>A command's data lie outside the image</source>
        <translation>Die Daten eines Kommandos liegen außerhalb des Abbilds</translation>
    </message>
    <message>
        <source>A configuration does not work out</source>
        <translation>Eine Konfiguration geht nicht auf</translation>
    </message>
    <message>
        <source>A copy between slaves reaches outside the image</source>
        <translation>Eine Kopie zwischen Slaves reicht über das Abbild hinaus</translation>
    </message>
    <message>
        <source>A cyclic command</source>
        <translation>Ein zyklisches Kommando</translation>
    </message>
    <message>
        <source>A cyclic command addresses no slave of the file</source>
        <translation>Ein zyklisches Kommando spricht keinen Slave der Datei an</translation>
    </message>
    <message>
        <source>A cyclic synchronous mode without SYNC0</source>
        <translation>Eine zyklisch synchrone Betriebsart ohne SYNC0</translation>
    </message>
    <message>
        <source>A device ID was not requested</source>
        <translation>Eine Gerätekennung wurde nicht angefordert</translation>
    </message>
    <message>
        <source>A device is not in the configuration</source>
        <translation>Ein Gerät steht nicht in der Konfiguration</translation>
    </message>
    <message>
        <source>A device is not known</source>
        <translation>Ein Gerät ist nicht bekannt</translation>
    </message>
    <message>
        <source>A device on the bus is not in the configuration</source>
        <translation>Ein Gerät am Bus steht nicht in der Konfiguration</translation>
    </message>
    <message>
        <source>A download has another size than its object</source>
        <translation>Ein Download hat eine andere Größe als sein Objekt</translation>
    </message>
    <message>
        <source>A drive interpolates over the wrong time: it moves in jerks, or refuses to</source>
        <translation>Ein Antrieb interpoliert über die falsche Zeit: er bewegt sich ruckartig oder weigert sich</translation>
    </message>
    <message>
        <source>A field of an init command</source>
        <translation>Ein Feld eines Init-Kommandos</translation>
    </message>
    <message>
        <source>A file cannot be read</source>
        <translation>Eine Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>A file cannot be written</source>
        <translation>Eine Datei kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>A file does not exist</source>
        <translation>Eine Datei gibt es nicht</translation>
    </message>
    <message>
        <source>A file is beyond what is read</source>
        <translation>Eine Datei ist größer, als gelesen wird</translation>
    </message>
    <message>
        <source>A file is not well-formed TOML</source>
        <translation>Eine Datei ist kein wohlgeformtes TOML</translation>
    </message>
    <message>
        <source>A file is not well-formed XML</source>
        <translation>Eine Datei ist kein wohlgeformtes XML</translation>
    </message>
    <message>
        <source>A frame is back only when it has passed all slaves, each of which takes about 1 us, or 0.3 us at E-bus: it meets the next cycle</source>
        <translation>Ein Frame ist erst zurück, wenn er alle Slaves durchlaufen hat, von denen jeder etwa 1 us braucht, am E-Bus 0,3 us: er trifft den nächsten Zyklus</translation>
    </message>
    <message>
        <source>A frame or datagram is too long for Ethernet</source>
        <translation>Ein Frame oder Datagramm ist zu lang für Ethernet</translation>
    </message>
    <message>
        <source>A gateway that does not know the bus cycle</source>
        <translation>Ein Gateway, das den Buszyklus nicht kennt</translation>
    </message>
    <message>
        <source>A gateway's fieldbus needs longer than a cycle</source>
        <translation>Der Feldbus eines Gateways braucht länger als einen Zyklus</translation>
    </message>
    <message>
        <source>A hot-connect group came or went</source>
        <translation>Eine Hot-Connect-Gruppe kam oder ging</translation>
    </message>
    <message>
        <source>A hot-connect group cannot be identified</source>
        <translation>Eine Hot-Connect-Gruppe lässt sich nicht erkennen</translation>
    </message>
    <message>
        <source>A hot-connect group does not have the members it says</source>
        <translation>Eine Hot-Connect-Gruppe hat nicht die Mitglieder, die sie nennt</translation>
    </message>
    <message>
        <source>A key of a scenario cannot be used</source>
        <translation>Ein Schlüssel eines Szenarios ist nicht verwendbar</translation>
    </message>
    <message>
        <source>A link is down</source>
        <translation>Ein Link ist nicht verbunden</translation>
    </message>
    <message>
        <source>A list can be changed only while its count is 0; slaves abort the write otherwise (0x06010000, 0x08000022)</source>
        <translation>Eine Liste lässt sich nur ändern, solange ihre Anzahl 0 ist; sonst brechen Slaves das Schreiben ab (0x06010000, 0x08000022)</translation>
    </message>
    <message>
        <source>A list is written in an order that slaves refuse</source>
        <translation>Eine Liste wird in einer Reihenfolge geschrieben, die Slaves ablehnen</translation>
    </message>
    <message>
        <source>A loose plug at the host, or somebody who switches the adapter off: a network manager, power saving, the reset of a USB adapter.</source>
        <translation>Ein loser Stecker am Rechner, oder jemand, der die Karte abschaltet: eine Netzwerkverwaltung, das Stromsparen, der Neustart eines USB-Adapters.</translation>
    </message>
    <message>
        <source>A loose plug or a weak supply; the lost links of the ports say which cable.</source>
        <translation>Ein loser Stecker oder eine schwache Versorgung; die Link-Verluste der Ports sagen, welches Kabel.</translation>
    </message>
    <message>
        <source>A loose plug, a bad cable, or a neighbour without power.</source>
        <translation>Ein loser Stecker, ein schlechtes Kabel oder ein Nachbar ohne Versorgung.</translation>
    </message>
    <message>
        <source>A mailbox SyncManager is set to other values than the mailbox says</source>
        <translation>Ein Mailbox-SyncManager wird auf andere Werte gesetzt, als die Mailbox sagt</translation>
    </message>
    <message>
        <source>A mailbox answered something else</source>
        <translation>Eine Mailbox antwortete etwas anderes</translation>
    </message>
    <message>
        <source>A mailbox did not answer in time</source>
        <translation>Eine Mailbox antwortete nicht rechtzeitig</translation>
    </message>
    <message>
        <source>A mailbox has an impossible size or place</source>
        <translation>Eine Mailbox hat eine unmögliche Größe oder Lage</translation>
    </message>
    <message>
        <source>A mailbox names no protocol</source>
        <translation>Eine Mailbox nennt kein Protokoll</translation>
    </message>
    <message>
        <source>A mailbox without SyncManagers</source>
        <translation>Eine Mailbox ohne SyncManager</translation>
    </message>
    <message>
        <source>A mailbox without usable size</source>
        <translation>Eine Mailbox ohne brauchbare Größe</translation>
    </message>
    <message>
        <source>A mandatory PDO is not assigned</source>
        <translation>Ein Pflicht-PDO ist nicht zugeordnet</translation>
    </message>
    <message>
        <source>A master that goes by the commands runs whatever device stands in that place</source>
        <translation>Ein Master, der nach den Kommandos geht, betreibt jedes Gerät an dieser Stelle</translation>
    </message>
    <message>
        <source>A master that goes by the file leaves it in INIT; only masters that make the commands themselves run it</source>
        <translation>Ein Master, der nach der Datei geht, lässt ihn in INIT; nur Master, die die Kommandos selbst machen, betreiben ihn</translation>
    </message>
    <message>
        <source>A module demands another operation mode</source>
        <translation>Ein Modul verlangt eine andere Betriebsart</translation>
    </message>
    <message>
        <source>A module does not fit into its place</source>
        <translation>Ein Modul passt nicht auf seinen Platz</translation>
    </message>
    <message>
        <source>A module is plugged into a place that is not there</source>
        <translation>Ein Modul steckt auf einem Platz, den es nicht gibt</translation>
    </message>
    <message>
        <source>A module is plugged into place {place}; the device has {places}.</source>
        <translation>Ein Modul steckt auf Platz {place}; das Gerät hat {places}.</translation>
    </message>
    <message>
        <source>A part of a recording is damaged</source>
        <translation>Ein Teil einer Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>A part of the ENI is not read</source>
        <translation>Ein Teil der ENI wird nicht gelesen</translation>
    </message>
    <message>
        <source>A place must have a module</source>
        <translation>Ein Platz muss ein Modul haben</translation>
    </message>
    <message>
        <source>A port has one cable: the master finds another wiring than the one told</source>
        <translation>Ein Port hat ein Kabel: der Master findet eine andere Verdrahtung als die genannte</translation>
    </message>
    <message>
        <source>A port lost its link</source>
        <translation>Ein Port verlor seinen Link</translation>
    </message>
    <message>
        <source>A previous port names a slave that is not in the file</source>
        <translation>Ein Vorgängerport nennt einen Slave, der nicht in der Datei ist</translation>
    </message>
    <message>
        <source>A process data watchdog expired</source>
        <translation>Ein Prozessdaten-Watchdog lief ab</translation>
    </message>
    <message>
        <source>A process-data command has no working counter</source>
        <translation>Ein Prozessdatenkommando hat keinen Working Counter</translation>
    </message>
    <message>
        <source>A recording that was cut short has its last part in a log beside it.</source>
        <translation>Eine abgebrochene Aufzeichnung hat ihren letzten Teil in einem Protokoll daneben.</translation>
    </message>
    <message>
        <source>A required element or attribute is missing</source>
        <translation>Ein Pflichtelement oder Pflichtattribut fehlt</translation>
    </message>
    <message>
        <source>A scan touches a machine that runs</source>
        <translation>Eine Suche berührt eine Maschine, die läuft</translation>
    </message>
    <message>
        <source>A serial number is to be compared, and none is known</source>
        <translation>Eine Seriennummer soll verglichen werden, und es ist keine bekannt</translation>
    </message>
    <message>
        <source>A setting of the master synchronisation is out of range</source>
        <translation>Eine Einstellung der Master-Synchronisation liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>A setting that no ENI carries</source>
        <translation>Eine Einstellung, die keine ENI trägt</translation>
    </message>
    <message>
        <source>A slave aborted an SDO transfer</source>
        <translation>Ein Slave brach eine SDO-Übertragung ab</translation>
    </message>
    <message>
        <source>A slave answers again</source>
        <translation>Ein Slave antwortet wieder</translation>
    </message>
    <message>
        <source>A slave answers in a few to some hundred milliseconds; the command fails before</source>
        <translation>Ein Slave antwortet in einigen bis einigen hundert Millisekunden; das Kommando scheitert vorher</translation>
    </message>
    <message>
        <source>A slave could not be led up again</source>
        <translation>Ein Slave ließ sich nicht wieder hochführen</translation>
    </message>
    <message>
        <source>A slave did not answer for a while</source>
        <translation>Ein Slave antwortete eine Weile nicht</translation>
    </message>
    <message>
        <source>A slave did not process a datagram</source>
        <translation>Ein Slave hat ein Datagramm nicht bearbeitet</translation>
    </message>
    <message>
        <source>A slave did not reach a state in time</source>
        <translation>Ein Slave erreichte einen Zustand nicht rechtzeitig</translation>
    </message>
    <message>
        <source>A slave does not answer</source>
        <translation>Ein Slave antwortet nicht</translation>
    </message>
    <message>
        <source>A slave does not answer behind a cable</source>
        <translation>Ein Slave hinter einem Kabel antwortet nicht</translation>
    </message>
    <message>
        <source>A slave does not renew its inputs in each cycle</source>
        <translation>Ein Slave erneuert seine Eingänge nicht in jedem Zyklus</translation>
    </message>
    <message>
        <source>A slave does not take its outputs in each cycle</source>
        <translation>Ein Slave nimmt seine Ausgänge nicht in jedem Zyklus</translation>
    </message>
    <message>
        <source>A slave ended a file transfer</source>
        <translation>Ein Slave beendete eine Dateiübertragung</translation>
    </message>
    <message>
        <source>A slave hangs on a port that leads nowhere</source>
        <translation>Ein Slave hängt an einem Port, der nirgendwohin führt</translation>
    </message>
    <message>
        <source>A slave hangs on itself or on one behind it</source>
        <translation>Ein Slave hängt an sich selbst oder an einem hinter ihm</translation>
    </message>
    <message>
        <source>A slave hangs on one that cannot stand in front of it</source>
        <translation>Ein Slave hängt an einem, der nicht vor ihm stehen kann</translation>
    </message>
    <message>
        <source>A slave hangs on one that only swapped cables put behind it</source>
        <translation>Ein Slave hängt an einem, den nur vertauschte Kabel hinter ihn stellen</translation>
    </message>
    <message>
        <source>A slave hangs on port B, C or D of its predecessor.</source>
        <translation>Ein Slave hängt an Port B, C oder D seines Vorgängers.</translation>
    </message>
    <message>
        <source>A slave has a new diagnosis message</source>
        <translation>Ein Slave hat eine neue Diagnosemeldung</translation>
    </message>
    <message>
        <source>A slave has left OP after its firmware had stood still</source>
        <translation>Ein Slave hat OP verlassen, nachdem seine Firmware stillgestanden hatte</translation>
    </message>
    <message>
        <source>A slave has left OP after missed SM2 events</source>
        <translation>Ein Slave hat OP nach verpassten SM2-Ereignissen verlassen</translation>
    </message>
    <message>
        <source>A slave has left OP because a clock had moved</source>
        <translation>Ein Slave hat OP verlassen, weil sich eine Uhr verstellt hatte</translation>
    </message>
    <message>
        <source>A slave has left OP because frames came too late</source>
        <translation>Ein Slave hat OP verlassen, weil Frames zu spät kamen</translation>
    </message>
    <message>
        <source>A slave has left OP while the bus was in order</source>
        <translation>Ein Slave hat OP verlassen, während der Bus in Ordnung war</translation>
    </message>
    <message>
        <source>A slave has left OP with an error</source>
        <translation>Ein Slave hat OP mit einem Fehler verlassen</translation>
    </message>
    <message>
        <source>A slave has no init commands</source>
        <translation>Ein Slave hat keine InitCmds</translation>
    </message>
    <message>
        <source>A slave has the station address 0</source>
        <translation>Ein Slave hat die Stationsadresse 0</translation>
    </message>
    <message>
        <source>A slave in DC mode checks its SYNC signals on that way and refuses (AL status code 0x0030 or 0x002D)</source>
        <translation>Ein Slave im DC-Betrieb prüft seine SYNC-Signale auf diesem Weg und lehnt ab (AL-Statuscode 0x0030 oder 0x002D)</translation>
    </message>
    <message>
        <source>A slave is addressed by its station address before it has one</source>
        <translation>Ein Slave wird mit seiner Stationsadresse angesprochen, bevor er eine hat</translation>
    </message>
    <message>
        <source>A slave is another device than configured</source>
        <translation>Ein Slave ist ein anderes Gerät als konfiguriert</translation>
    </message>
    <message>
        <source>A slave is given another station address than its PhysAddr</source>
        <translation>Ein Slave bekommt eine andere Stationsadresse als seine PhysAddr</translation>
    </message>
    <message>
        <source>A slave is known by an alias that it does not have</source>
        <translation>Ein Slave wird an einem Alias erkannt, den er nicht hat</translation>
    </message>
    <message>
        <source>A slave is led up again</source>
        <translation>Ein Slave wird wieder hochgeführt</translation>
    </message>
    <message>
        <source>A slave is not in sync</source>
        <translation>Ein Slave ist nicht synchron</translation>
    </message>
    <message>
        <source>A slave is not led up any more</source>
        <translation>Ein Slave wird nicht mehr hochgeführt</translation>
    </message>
    <message>
        <source>A slave lacks the clock that its ESI has</source>
        <translation>Einem Slave fehlt die Uhr, die seine ESI hat</translation>
    </message>
    <message>
        <source>A slave left OP, lost its link or did not serve its data.</source>
        <translation>Ein Slave hat OP verlassen, seinen Link verloren oder seine Daten nicht bedient.</translation>
    </message>
    <message>
        <source>A slave left the sync window for a while</source>
        <translation>Ein Slave verließ eine Weile das Sync-Fenster</translation>
    </message>
    <message>
        <source>A slave needs longer than its cycle</source>
        <translation>Ein Slave braucht länger als seinen Zyklus</translation>
    </message>
    <message>
        <source>A slave of the configuration is missing</source>
        <translation>Ein Slave der Konfiguration fehlt</translation>
    </message>
    <message>
        <source>A slave refused a state</source>
        <translation>Ein Slave verweigerte einen Zustand</translation>
    </message>
    <message>
        <source>A slave refused a state or left one by itself</source>
        <translation>Ein Slave verweigerte einen Zustand oder verließ einen von selbst</translation>
    </message>
    <message>
        <source>A slave refuses to go on</source>
        <translation>Ein Slave weigert sich weiterzugehen</translation>
    </message>
    <message>
        <source>A slave sent an emergency</source>
        <translation>Ein Slave sandte eine Emergency</translation>
    </message>
    <message>
        <source>A slave stays behind the others</source>
        <translation>Ein Slave bleibt hinter den anderen zurück</translation>
    </message>
    <message>
        <source>A slave with distributed clocks stands before the reference clock</source>
        <translation>Ein Slave mit verteilter Uhr steht vor der Referenzuhr</translation>
    </message>
    <message>
        <source>A slave's SYNC0 comes at another time than configured</source>
        <translation>Das SYNC0 eines Slaves kommt zu einer anderen Zeit als konfiguriert</translation>
    </message>
    <message>
        <source>A slave's SYNC0 does not come</source>
        <translation>Das SYNC0 eines Slaves kommt nicht</translation>
    </message>
    <message>
        <source>A slave's cables IN and OUT are swapped</source>
        <translation>Die Kabel IN und OUT eines Slaves sind vertauscht</translation>
    </message>
    <message>
        <source>A slave's clock was off</source>
        <translation>Die Uhr eines Slaves lag daneben</translation>
    </message>
    <message>
        <source>A slave's firmware is fast enough again</source>
        <translation>Die Firmware eines Slaves ist wieder schnell genug</translation>
    </message>
    <message>
        <source>A slave's firmware is slow</source>
        <translation>Die Firmware eines Slaves ist langsam</translation>
    </message>
    <message>
        <source>A slave's firmware stood still</source>
        <translation>Die Firmware eines Slaves stand still</translation>
    </message>
    <message>
        <source>A slave's mailbox does not answer</source>
        <translation>Die Mailbox eines Slaves antwortet nicht</translation>
    </message>
    <message>
        <source>A start-up command</source>
        <translation>Ein Startkommando</translation>
    </message>
    <message>
        <source>A start-up command and a setting write different values</source>
        <translation>Ein Startkommando und eine Einstellung schreiben verschiedene Werte</translation>
    </message>
    <message>
        <source>A start-up command has hardly any time</source>
        <translation>Ein Startkommando hat kaum Zeit</translation>
    </message>
    <message>
        <source>A start-up command has no data</source>
        <translation>Ein Startkommando ohne Daten</translation>
    </message>
    <message>
        <source>A start-up command on a transition without mailbox</source>
        <translation>Ein Startkommando auf einem Übergang ohne Mailbox</translation>
    </message>
    <message>
        <source>A synchronisation setting that cannot be set</source>
        <translation>Eine Synchronisationseinstellung, die sich nicht setzen lässt</translation>
    </message>
    <message>
        <source>A synchronisation type that does not use the SYNC signals</source>
        <translation>Eine Synchronisationsart, die die SYNC-Signale nicht benutzt</translation>
    </message>
    <message>
        <source>A synchronisation type that the device does not take</source>
        <translation>Eine Synchronisationsart, die das Gerät nicht annimmt</translation>
    </message>
    <message>
        <source>A table is cut off</source>
        <translation>Eine Tabelle ist abgeschnitten</translation>
    </message>
    <message>
        <source>A task without cycle time</source>
        <translation>Eine Task ohne Zykluszeit</translation>
    </message>
    <message>
        <source>A value cannot be used</source>
        <translation>Ein Wert ist nicht verwendbar</translation>
    </message>
    <message>
        <source>A value has the wrong type or is out of range</source>
        <translation>Ein Wert hat den falschen Typ oder liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>A value is written in a form that the schema does not allow</source>
        <translation>Ein Wert ist in einer Form geschrieben, die das Schema nicht erlaubt</translation>
    </message>
    <message>
        <source>A value stands in a form that no reader understands, so that nothing behind it was checked by meaning</source>
        <translation>Ein Wert steht in einer Form, die kein Leser versteht, so dass nichts dahinter nach seiner Bedeutung geprüft wurde</translation>
    </message>
    <message>
        <source>A variable</source>
        <translation>Eine Variable</translation>
    </message>
    <message>
        <source>A variable has another size than its type</source>
        <translation>Eine Variable hat eine andere Größe als ihr Typ</translation>
    </message>
    <message>
        <source>A variable lies outside the process image</source>
        <translation>Eine Variable liegt außerhalb des Prozessabbilds</translation>
    </message>
    <message>
        <source>A working counter is not what is expected</source>
        <translation>Ein Working Counter ist nicht der erwartete</translation>
    </message>
    <message>
        <source>Activate SYNC1 (0x0400), or set CycleTime1 to 0</source>
        <translation>SYNC1 aktivieren (0x0400), oder CycleTime1 auf 0 setzen</translation>
    </message>
    <message>
        <source>Activation (0x0980)</source>
        <translation>Aktivierung (0x0980)</translation>
    </message>
    <message>
        <source>Add Cnt</source>
        <translation>Cnt hinzufügen</translation>
    </message>
    <message>
        <source>Add NOP 0x0900 and ARMW 0x0910 to the cyclic commands</source>
        <translation>NOP 0x0900 und ARMW 0x0910 zu den zyklischen Kommandos hinzufügen</translation>
    </message>
    <message>
        <source>Add PollTime, or StatusBitAddr with an FMMU for the status bit</source>
        <translation>PollTime hinzufügen, oder StatusBitAddr mit einer FMMU für das Statusbit</translation>
    </message>
    <message>
        <source>Add a BRD of 0x0130 with 2 bytes</source>
        <translation>Ein BRD von 0x0130 mit 2 Bytes hinzufügen</translation>
    </message>
    <message>
        <source>Add a NOP with Ado 2304 and 4 bytes before the ARMW</source>
        <translation>Vor dem ARMW ein NOP mit Ado 2304 und 4 Bytes hinzufügen</translation>
    </message>
    <message>
        <source>Add a read of 0x0130 with Validate behind the request</source>
        <translation>Hinter der Anforderung ein Lesen von 0x0130 mit Validate ergänzen</translation>
    </message>
    <message>
        <source>Add the AL control write (0x0120) on that transition</source>
        <translation>Das Schreiben von AL Control (0x0120) auf diesem Übergang ergänzen</translation>
    </message>
    <message>
        <source>Add the FMMU on PS, or take the PDOs out of the assignment</source>
        <translation>Die FMMU auf PS hinzufügen, oder die PDOs aus der Zuordnung nehmen</translation>
    </message>
    <message>
        <source>Add the Protocol, or remove the commands</source>
        <translation>Das Protocol hinzufügen, oder die Kommandos entfernen</translation>
    </message>
    <message>
        <source>Add the Sync Unit, or choose another.</source>
        <translation>Die Sync Unit hinzufügen, oder eine andere wählen.</translation>
    </message>
    <message>
        <source>Add the broadcast writes of 0x0010, 0x0600 and 0x0800 on IP to the master's init commands</source>
        <translation>Die Broadcast-Schreibkommandos von 0x0010, 0x0600 und 0x0800 auf IP zu den InitCmds des Masters hinzufügen</translation>
    </message>
    <message>
        <source>Add the element, or export the file again with the tool that made it</source>
        <translation>Das Element hinzufügen, oder die Datei mit ihrem Werkzeug neu exportieren</translation>
    </message>
    <message>
        <source>Add the folder of its ESI to the catalogue, then import again.</source>
        <translation>Den Ordner seiner ESI zum Katalog hinzufügen, dann neu importieren.</translation>
    </message>
    <message>
        <source>Add the reads of vendor and product from the EEPROM with Validate on IP</source>
        <translation>Auf IP das Lesen von Hersteller und Produkt aus dem EEPROM mit Validate hinzufügen</translation>
    </message>
    <message>
        <source>Add the state SAFEOP to the command</source>
        <translation>Den Zustand SAFEOP zum Kommando hinzufügen</translation>
    </message>
    <message>
        <source>Add the task, or choose another for the Sync Unit.</source>
        <translation>Die Task hinzufügen, oder der Sync Unit eine andere geben.</translation>
    </message>
    <message>
        <source>Add the write of 0 to 0x0980 on SP, OP, SI and OI</source>
        <translation>Das Schreiben von 0 nach 0x0980 auf SP, OP, SI und OI hinzufügen</translation>
    </message>
    <message>
        <source>Add the write of 8 bytes at 0x0990 before 0x0980</source>
        <translation>Vor 0x0980 das Schreiben von 8 Bytes bei 0x0990 hinzufügen</translation>
    </message>
    <message>
        <source>Add the write of its 8 bytes at 0x0800 + 8 n on PS</source>
        <translation>Das Schreiben seiner 8 Bytes bei 0x0800 + 8 n auf PS hinzufügen</translation>
    </message>
    <message>
        <source>Add the write of its 8 bytes at 0x0800 or 0x0808 on IP</source>
        <translation>Das Schreiben seiner 8 Bytes bei 0x0800 oder 0x0808 auf IP hinzufügen</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>Hinzugekommen</translation>
    </message>
    <message>
        <source>Addresses for a device without EoE</source>
        <translation>Adressen für ein Gerät ohne EoE</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}), and came back, {count} in all. The reference clock stepped or changed its rate{led}.</source>
        <translation>Alle Slaves bewegten sich bei {since} zugleich und zur selben Seite aus dem Sync-Fenster ({deviation}, Grenze {limit}) und kamen zurück, insgesamt {count}. Die Referenzuhr ist gesprungen oder hat ihre Geschwindigkeit geändert{led}.</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}). No reading is outside any more, but not for the settle time yet. The reference clock stepped or changed its rate{led}.</source>
        <translation>Alle Slaves bewegten sich bei {since} zugleich und zur selben Seite aus dem Sync-Fenster ({deviation}, Grenze {limit}). Kein Messwert liegt mehr außerhalb, aber noch nicht für die Einschwingzeit. Die Referenzuhr ist gesprungen oder hat ihre Geschwindigkeit geändert{led}.</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}). The reference clock stepped or changed its rate{led}.</source>
        <translation>Alle Slaves bewegten sich bei {since} zugleich und zur selben Seite aus dem Sync-Fenster ({deviation}, Grenze {limit}). Die Referenzuhr ist gesprungen oder hat ihre Geschwindigkeit geändert{led}.</translation>
    </message>
    <message>
        <source>An AMS Net ID for a device without AoE</source>
        <translation>Eine AMS Net ID für ein Gerät ohne AoE</translation>
    </message>
    <message>
        <source>An EEPROM (SII) cannot be used</source>
        <translation>Ein EEPROM (SII) ist nicht verwendbar</translation>
    </message>
    <message>
        <source>An EEPROM's checksum is wrong</source>
        <translation>Die Prüfsumme eines EEPROMs ist falsch</translation>
    </message>
    <message>
        <source>An ENI does not hold all settings of the clocks</source>
        <translation>Eine ENI enthält nicht alle Einstellungen der Uhren</translation>
    </message>
    <message>
        <source>An ENI file holds whole microseconds: {cycle} is rounded there. Masters that take the cycle from the file run at another rate than the SYNC signals.</source>
        <translation>Eine ENI-Datei fasst ganze Mikrosekunden: {cycle} wird dort gerundet. Master, die den Zyklus aus der Datei nehmen, laufen in einem anderen Takt als die SYNC-Signale.</translation>
    </message>
    <message>
        <source>An ENI keeps the layout of its image</source>
        <translation>Eine ENI behält die Anordnung ihres Abbilds</translation>
    </message>
    <message>
        <source>An ENI says of the clocks' settings only which commands are sent: limit and settle time of the sync window, set value, burst and controller have their defaults.</source>
        <translation>Eine ENI sagt von den Einstellungen der Uhren nur, welche Kommandos gesendet werden: Grenze und Einschwingzeit des Sync-Fensters, Sollwert, Burst und Regler haben ihre Vorgaben.</translation>
    </message>
    <message>
        <source>An FMMU</source>
        <translation>Eine FMMU</translation>
    </message>
    <message>
        <source>An FMMU does not map the whole buffer of a SyncManager</source>
        <translation>Eine FMMU bildet nicht den ganzen Puffer eines SyncManagers ab</translation>
    </message>
    <message>
        <source>An FMMU has contradictory values</source>
        <translation>Eine FMMU hat widersprüchliche Werte</translation>
    </message>
    <message>
        <source>An FMMU is set behind the request for the state that needs it</source>
        <translation>Eine FMMU wird hinter der Anforderung des Zustands gesetzt, der sie braucht</translation>
    </message>
    <message>
        <source>An FMMU maps a SyncManager in the wrong direction</source>
        <translation>Eine FMMU bildet einen SyncManager in der falschen Richtung ab</translation>
    </message>
    <message>
        <source>An FMMU maps memory that no SyncManager guards</source>
        <translation>Eine FMMU bildet Speicher ab, den kein SyncManager bewacht</translation>
    </message>
    <message>
        <source>An element is missing</source>
        <translation>Ein Element fehlt</translation>
    </message>
    <message>
        <source>An element or attribute that ETG.2100 does not know</source>
        <translation>Ein Element oder Attribut, das ETG.2100 nicht kennt</translation>
    </message>
    <message>
        <source>An element stands more often than allowed</source>
        <translation>Ein Element steht öfter als erlaubt</translation>
    </message>
    <message>
        <source>An element's value cannot be used</source>
        <translation>Der Wert eines Elements ist nicht verwendbar</translation>
    </message>
    <message>
        <source>An entry that the ESI fixes is not mapped</source>
        <translation>Ein Eintrag, den die ESI festlegt, ist nicht gemappt</translation>
    </message>
    <message>
        <source>An error limit beyond the device's range</source>
        <translation>Eine Fehlergrenze außerhalb des Bereichs des Geräts</translation>
    </message>
    <message>
        <source>An impossible cycle time</source>
        <translation>Eine unmögliche Zykluszeit</translation>
    </message>
    <message>
        <source>An init command goes to another slave</source>
        <translation>Ein InitCmd geht an einen anderen Slave</translation>
    </message>
    <message>
        <source>An init command of the master</source>
        <translation>Ein Init-Kommando des Masters</translation>
    </message>
    <message>
        <source>An older program has written it.</source>
        <translation>Ein älteres Programm hat sie geschrieben.</translation>
    </message>
    <message>
        <source>An optional slave</source>
        <translation>Ein wahlweiser Slave</translation>
    </message>
    <message>
        <source>Another clock leads</source>
        <translation>Eine andere Uhr führt</translation>
    </message>
    <message>
        <source>Another slave is set up with the settings of this one</source>
        <translation>Ein anderer Slave wird mit den Einstellungen dieses Slaves eingerichtet</translation>
    </message>
    <message>
        <source>Another working counter is expected</source>
        <translation>Ein anderer Working Counter wird erwartet</translation>
    </message>
    <message>
        <source>AoE address</source>
        <translation>AoE-Adresse</translation>
    </message>
    <message>
        <source>AoE, EoE, CoE, SoE, FoE or VoE</source>
        <translation>AoE, EoE, CoE, SoE, FoE oder VoE</translation>
    </message>
    <message>
        <source>Assign fewer PDOs, or do without the mailbox state bit.</source>
        <translation>Weniger PDOs zuordnen, oder auf das Mailbox-Zustandsbit verzichten.</translation>
    </message>
    <message>
        <source>Assign fewer PDOs, or map fewer objects.</source>
        <translation>Weniger PDOs zuordnen, oder weniger Objekte mappen.</translation>
    </message>
    <message>
        <source>Assign fewer PDOs.</source>
        <translation>Weniger PDOs zuordnen.</translation>
    </message>
    <message>
        <source>Assign fewer or more PDOs</source>
        <translation>Weniger oder mehr PDOs zuordnen</translation>
    </message>
    <message>
        <source>Assign it once.</source>
        <translation>Es einmal zuordnen.</translation>
    </message>
    <message>
        <source>Assign it.</source>
        <translation>Es zuordnen.</translation>
    </message>
    <message>
        <source>Assign more PDOs.</source>
        <translation>Mehr PDOs zuordnen.</translation>
    </message>
    <message>
        <source>Assign the PDO</source>
        <translation>Das PDO zuordnen</translation>
    </message>
    <message>
        <source>AssignActivate against the ESI, and that it is written in PREOP</source>
        <translation>AssignActivate gegen die ESI, und ob es in PREOP geschrieben wird</translation>
    </message>
    <message>
        <source>Auto-increment address</source>
        <translation>Auto-Increment-Adresse</translation>
    </message>
    <message>
        <source>AutoIncAddr is {said}, the place in the file makes it {expected}</source>
        <translation>AutoIncAddr ist {said}, nach dem Platz in der Datei ist sie {expected}</translation>
    </message>
    <message>
        <source>B, C or D</source>
        <translation>B, C oder D</translation>
    </message>
    <message>
        <source>Before that, at {since}, all slaves had moved at once and to the same side, out of the sync window ({deviation}, limit {limit}); {count} in all. The reference clock had stepped or changed its rate{led}.</source>
        <translation>Davor, bei {since}, hatten sich alle Slaves zugleich und zur selben Seite aus dem Sync-Fenster bewegt ({deviation}, Grenze {limit}); insgesamt {count}. Die Referenzuhr war gesprungen oder hatte ihre Geschwindigkeit geändert{led}.</translation>
    </message>
    <message>
        <source>Best effort instead of real time</source>
        <translation>So gut es geht statt Echtzeit</translation>
    </message>
    <message>
        <source>Bootstrap mailbox for answers</source>
        <translation>Bootstrap-Mailbox für Antworten</translation>
    </message>
    <message>
        <source>Bootstrap mailbox for requests</source>
        <translation>Bootstrap-Mailbox für Anfragen</translation>
    </message>
    <message>
        <source>Both answer the commands to that address: working counters are 2 and data are mixed</source>
        <translation>Beide antworten auf Kommandos an diese Adresse: Working Counter sind 2, und Daten vermischen sich</translation>
    </message>
    <message>
        <source>Both slaves get the same outputs, which is rarely meant</source>
        <translation>Beide Slaves bekommen dieselben Ausgänge, was selten gemeint ist</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Cancelled{because}.</source>
        <translation>Abgebrochen{because}.</translation>
    </message>
    <message>
        <source>Capture whole frames (a snap length of 0).</source>
        <translation>Ganze Frames mitschneiden (Snap-Länge 0).</translation>
    </message>
    <message>
        <source>Capture whole frames (tcpdump -s 0).</source>
        <translation>Ganze Frames aufzeichnen (tcpdump -s 0).</translation>
    </message>
    <message>
        <source>Capture with a probe in the line, or at the master; compare with the lost frames that the master counts.</source>
        <translation>Mit einer Sonde in der Leitung oder am Master aufzeichnen; mit den verlorenen Frames vergleichen, die der Master zählt.</translation>
    </message>
    <message>
        <source>Check its name and folder.</source>
        <translation>Namen und Ordner prüfen.</translation>
    </message>
    <message>
        <source>Check its power and the cable to it, or take it out of the configuration.</source>
        <translation>Versorgung und Kabel dorthin prüfen, oder ihn aus der Konfiguration nehmen.</translation>
    </message>
    <message>
        <source>Check power, cabling and the working counter of the slaves before it.</source>
        <translation>Versorgung, Verkabelung und Working Counter der Slaves davor prüfen.</translation>
    </message>
    <message>
        <source>Check the cable and that the interface is up.</source>
        <translation>Das Kabel prüfen und ob die Schnittstelle aktiv ist.</translation>
    </message>
    <message>
        <source>Check the cycle time and the host's timer frequency.</source>
        <translation>Zykluszeit und Timerfrequenz des Rechners prüfen.</translation>
    </message>
    <message>
        <source>Check the folder's permissions and free space.</source>
        <translation>Rechte des Ordners und freien Platz prüfen.</translation>
    </message>
    <message>
        <source>Check the host's jitter and the clock's drift.</source>
        <translation>Jitter des Hosts und Drift der Uhr prüfen.</translation>
    </message>
    <message>
        <source>Check the plug at the host, and that the adapter is switched on (ip link set ... up); the bus comes back with it.</source>
        <translation>Den Stecker am Rechner prüfen und ob die Karte eingeschaltet ist (ip link set ... up); der Bus kommt mit ihr zurück.</translation>
    </message>
    <message>
        <source>Check the power of the first one and the cable that leads to it.</source>
        <translation>Die Versorgung des ersten und das Kabel zu ihm prüfen.</translation>
    </message>
    <message>
        <source>Check the power of the first one, and the cable and plugs between the two.</source>
        <translation>Die Versorgung des ersten prüfen, und Kabel und Stecker zwischen beiden.</translation>
    </message>
    <message>
        <source>Check them in the project.</source>
        <translation>Sie im Projekt prüfen.</translation>
    </message>
    <message>
        <source>Check {check}.</source>
        <translation>Zu prüfen: {check}.</translation>
    </message>
    <message>
        <source>Choose a cycle of up to 255 times a power of ten.</source>
        <translation>Einen Zyklus bis zum 255-fachen einer Zehnerpotenz wählen.</translation>
    </message>
    <message>
        <source>Choose a cycle of whole microseconds.</source>
        <translation>Einen Zyklus in ganzen Mikrosekunden wählen.</translation>
    </message>
    <message>
        <source>Choose a cycle that all devices take (page General, button Accepted, or synclinectl project cycle-times)</source>
        <translation>Einen Zyklus wählen, den alle Geräte annehmen (Seite Allgemein, Schaltfläche Angenommen, oder synclinectl project cycle-times)</translation>
    </message>
    <message>
        <source>Choose a factor of that range.</source>
        <translation>Einen Faktor aus diesem Bereich wählen.</translation>
    </message>
    <message>
        <source>Choose a factor that divides the bus cycle.</source>
        <translation>Einen Faktor wählen, der den Buszyklus teilt.</translation>
    </message>
    <message>
        <source>Choose a larger set value.</source>
        <translation>Einen größeren Sollwert wählen.</translation>
    </message>
    <message>
        <source>Choose a longer cycle, or exchange less.</source>
        <translation>Einen längeren Zyklus wählen, oder weniger austauschen.</translation>
    </message>
    <message>
        <source>Choose a longer cycle, or let slow slaves run in a task of their own with a longer one.</source>
        <translation>Einen längeren Zyklus wählen, oder langsame Slaves in einer eigenen Task mit längerem Zyklus laufen lassen.</translation>
    </message>
    <message>
        <source>Choose a longer cycle.</source>
        <translation>Einen längeren Zyklus wählen.</translation>
    </message>
    <message>
        <source>Choose a lower address, or leave the choice open.</source>
        <translation>Eine niedrigere Adresse wählen, oder die Wahl offen lassen.</translation>
    </message>
    <message>
        <source>Choose a multiple of its full step</source>
        <translation>Ein Vielfaches seiner vollen Schrittweite wählen</translation>
    </message>
    <message>
        <source>Choose a multiple of the first task's cycle.</source>
        <translation>Ein Vielfaches des Zyklus der ersten Task wählen.</translation>
    </message>
    <message>
        <source>Choose a multiple or a whole fraction of the bus cycle.</source>
        <translation>Ein Vielfaches oder einen ganzen Bruchteil des Buszyklus wählen.</translation>
    </message>
    <message>
        <source>Choose a slave that stands before it in the frame.</source>
        <translation>Einen Slave wählen, der im Frame vor ihm steht.</translation>
    </message>
    <message>
        <source>Choose a slave with a distributed clock, or leave the choice open.</source>
        <translation>Einen Slave mit verteilter Uhr wählen, oder die Wahl offen lassen.</translation>
    </message>
    <message>
        <source>Choose a value that the device takes.</source>
        <translation>Einen Wert wählen, den das Gerät annimmt.</translation>
    </message>
    <message>
        <source>Choose a value within the range.</source>
        <translation>Einen Wert innerhalb des Bereichs wählen.</translation>
    </message>
    <message>
        <source>Choose another, or none.</source>
        <translation>Ein anderes wählen, oder keins.</translation>
    </message>
    <message>
        <source>Choose bus shift or master shift.</source>
        <translation>Bus-Shift oder Master-Shift wählen.</translation>
    </message>
    <message>
        <source>Choose one of the ESI's operation modes.</source>
        <translation>Eine der Betriebsarten der ESI wählen.</translation>
    </message>
    <message>
        <source>Choose one of these ports.</source>
        <translation>Einen dieser Ports wählen.</translation>
    </message>
    <message>
        <source>Choose that operation mode.</source>
        <translation>Diese Betriebsart wählen.</translation>
    </message>
    <message>
        <source>Choose the first slave with DC.</source>
        <translation>Den ersten Slave mit DC wählen.</translation>
    </message>
    <message>
        <source>Choose the operation mode by hand.</source>
        <translation>Die Betriebsart von Hand wählen.</translation>
    </message>
    <message>
        <source>Clear the AMS Net ID.</source>
        <translation>Die AMS Net ID leeren.</translation>
    </message>
    <message>
        <source>Clear the addresses.</source>
        <translation>Die Adressen leeren.</translation>
    </message>
    <message>
        <source>Clocks drift apart before SYNC signals start, and slaves miss their first pulses</source>
        <translation>Uhren laufen auseinander, bevor SYNC-Signale beginnen, und Slaves verpassen ihre ersten Pulse</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, one slave makes it {computed}</source>
        <translation>Cnt von {command} ist {count}, ein Slave ergibt {computed}</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, the FMMUs make it {computed} ({readers:# slave|# slaves} read, {writers:# slave|# slaves} written)</source>
        <translation>Cnt von {command} ist {count}, nach den FMMUs ist er {computed} ({readers:# Slave|# Slaves} gelesen, {writers:# Slave|# Slaves} geschrieben)</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, the file has {slaves:# slave|# slaves}</source>
        <translation>Cnt von {command} ist {count}, die Datei hat {slaves:# Slave|# Slaves}</translation>
    </message>
    <message>
        <source>Commands come in another order</source>
        <translation>Die Kommandos kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>Commands to a position reach another slave than the one described</source>
        <translation>Kommandos an eine Position erreichen einen anderen Slave als den beschriebenen</translation>
    </message>
    <message>
        <source>Compare the wiring with the configuration.</source>
        <translation>Die Verdrahtung mit der Konfiguration vergleichen.</translation>
    </message>
    <message>
        <source>Complete access starts at sub-index 0 or 1; slaves abort it</source>
        <translation>Complete Access beginnt bei Subindex 0 oder 1; Slaves brechen ihn ab</translation>
    </message>
    <message>
        <source>Complete access to a sub-index other than 0 or 1</source>
        <translation>Complete Access auf einen anderen Subindex als 0 oder 1</translation>
    </message>
    <message>
        <source>Copy the file that ends in -wal together with the recording.</source>
        <translation>Die Datei, die auf -wal endet, zusammen mit der Aufzeichnung kopieren.</translation>
    </message>
    <message>
        <source>Correct Adp, or remove the command</source>
        <translation>Adp berichtigen, oder das Kommando entfernen</translation>
    </message>
    <message>
        <source>Correct BitOffs or BitSize, or ByteSize of the image</source>
        <translation>BitOffs oder BitSize berichtigen, oder ByteSize des Abbilds</translation>
    </message>
    <message>
        <source>Correct BitOffs or BitSize, unless one is a part of the other</source>
        <translation>BitOffs oder BitSize berichtigen, wenn nicht die eine ein Teil der anderen ist</translation>
    </message>
    <message>
        <source>Correct BitSize or DataType</source>
        <translation>BitSize oder DataType berichtigen</translation>
    </message>
    <message>
        <source>Correct BitStart or BitLength, or ByteSize of the image</source>
        <translation>BitStart oder BitLength berichtigen, oder ByteSize des Abbilds</translation>
    </message>
    <message>
        <source>Correct BitStart, or the offsets of the command</source>
        <translation>BitStart oder die Offsets des Kommandos berichtigen</translation>
    </message>
    <message>
        <source>Correct Cmd and Ado, or remove Validate</source>
        <translation>Cmd und Ado berichtigen oder Validate entfernen</translation>
    </message>
    <message>
        <source>Correct CycleTime</source>
        <translation>CycleTime berichtigen</translation>
    </message>
    <message>
        <source>Correct InputOffs or OutputOffs, or ByteSize of the image</source>
        <translation>InputOffs oder OutputOffs berichtigen, oder ByteSize des Abbilds</translation>
    </message>
    <message>
        <source>Correct Port or PhysAddr of one PreviousPort</source>
        <translation>Port oder PhysAddr eines PreviousPort berichtigen</translation>
    </message>
    <message>
        <source>Correct Validate, or VendorId, ProductCode, RevisionNo and SerialNo of Info</source>
        <translation>Validate berichtigen, oder VendorId, ProductCode, RevisionNo und SerialNo von Info</translation>
    </message>
    <message>
        <source>Correct length, start bit, stop bit, type and activation in the 16 bytes</source>
        <translation>Länge, Startbit, Stoppbit, Art und Aktivierung in den 16 Bytes berichtigen</translation>
    </message>
    <message>
        <source>Correct start and length; data memory begins at 0x1000, digital outputs at 0x0F00</source>
        <translation>Anfang und Länge berichtigen; Datenspeicher beginnt bei 0x1000, digitale Ausgänge bei 0x0F00</translation>
    </message>
    <message>
        <source>Correct start or length of one</source>
        <translation>Anfang oder Länge des einen berichtigen</translation>
    </message>
    <message>
        <source>Correct the PhysAddr of PreviousPort, or the order of the slaves</source>
        <translation>Die PhysAddr von PreviousPort oder die Reihenfolge der Slaves berichtigen</translation>
    </message>
    <message>
        <source>Correct the data of Validate</source>
        <translation>Die Daten von Validate berichtigen</translation>
    </message>
    <message>
        <source>Correct the data of the AL control write</source>
        <translation>Die Daten des Schreibens von AL Control berichtigen</translation>
    </message>
    <message>
        <source>Correct the data of the command, or Start and Length</source>
        <translation>Die Daten des Kommandos oder Start und Length berichtigen</translation>
    </message>
    <message>
        <source>Correct the data of the command, or StartAddress</source>
        <translation>Die Daten des Kommandos oder StartAddress berichtigen</translation>
    </message>
    <message>
        <source>Correct the data of the write to 0x0010</source>
        <translation>Die Daten des Schreibens nach 0x0010 berichtigen</translation>
    </message>
    <message>
        <source>Correct the offsets of CopyInfo</source>
        <translation>Die Offsets von CopyInfo berichtigen</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Zykluszeit</translation>
    </message>
    <message>
        <source>CycleTime is in microseconds; masters run some 31 us to 10 s</source>
        <translation>CycleTime ist in Mikrosekunden; Master laufen mit etwa 31 us bis 10 s</translation>
    </message>
    <message>
        <source>CycleTime is {cycle}</source>
        <translation>CycleTime ist {cycle}</translation>
    </message>
    <message>
        <source>CycleTime0 is {cycle}, and no command on PS switches SYNC0 on</source>
        <translation>CycleTime0 ist {cycle}, und kein Kommando auf PS schaltet SYNC0 ein</translation>
    </message>
    <message>
        <source>CycleTime1 is {time}, and {activation} does not switch SYNC1 on</source>
        <translation>CycleTime1 ist {time}, und {activation} schaltet SYNC1 nicht ein</translation>
    </message>
    <message>
        <source>Cycles come late when the host has other work.</source>
        <translation>Zyklen kommen zu spät, wenn der Host anderes zu tun hat.</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode is executed with SYNC0 only</source>
        <translation>Zyklisch synchrone Lage (CSP) wird nur mit SYNC0 ausgeführt</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>Zyklisch synchron Lage (CSP) braucht SYNC0: ohne es kommen Sollwerte in keinem festen Abstand zur Servoperiode</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>Zyklisch synchrone Lage (CSP) bekommt ohne SYNC0 ihre Sollwerte in keinem festen Abstand zur Servoperiode und bewegt sich schlecht</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode is executed with SYNC0 only</source>
        <translation>Zyklisch synchrones Drehmoment (CST) wird nur mit SYNC0 ausgeführt</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>Zyklisch synchron Drehmoment (CST) braucht SYNC0: ohne es kommen Sollwerte in keinem festen Abstand zur Servoperiode</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>Zyklisch synchrones Drehmoment (CST) bekommt ohne SYNC0 seine Sollwerte in keinem festen Abstand zur Servoperiode und bewegt sich schlecht</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode is executed with SYNC0 only</source>
        <translation>Zyklisch synchrone Geschwindigkeit (CSV) wird nur mit SYNC0 ausgeführt</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>Zyklisch synchron Geschwindigkeit (CSV) braucht SYNC0: ohne es kommen Sollwerte in keinem festen Abstand zur Servoperiode</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>Zyklisch synchrone Geschwindigkeit (CSV) bekommt ohne SYNC0 ihre Sollwerte in keinem festen Abstand zur Servoperiode und bewegt sich schlecht</translation>
    </message>
    <message>
        <source>Cyclic tasks</source>
        <translation>Zyklische Tasks</translation>
    </message>
    <message>
        <source>DC sync IO error</source>
        <translation>DC-Sync-Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>DC sync timeout</source>
        <translation>DC-Sync-Zeitüberschreitung</translation>
    </message>
    <message>
        <source>DCM error {code} {name}: {text} The drift is {drift} ppm</source>
        <translation>DCM-Fehler {code} {name}: {text} Die Drift ist {drift} ppm</translation>
    </message>
    <message>
        <source>Data are malformed</source>
        <translation>Daten sind fehlerhaft aufgebaut</translation>
    </message>
    <message>
        <source>Data link layer of the mailbox</source>
        <translation>Data Link Layer der Mailbox</translation>
    </message>
    <message>
        <source>Data types of many variables</source>
        <translation>Datentypen vieler Variablen</translation>
    </message>
    <message>
        <source>Delete it or choose another one.</source>
        <translation>Ihn löschen oder einen anderen wählen.</translation>
    </message>
    <message>
        <source>Describe the PDO, or take it out of the SyncManager's list</source>
        <translation>Das PDO beschreiben, oder es aus der Liste des SyncManagers nehmen</translation>
    </message>
    <message>
        <source>Destination address</source>
        <translation>Zieladresse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Distributed clocks</source>
        <translation>Distributed Clocks</translation>
    </message>
    <message>
        <source>Distributed clocks are initialised</source>
        <translation>Die Distributed Clocks sind eingerichtet</translation>
    </message>
    <message>
        <source>Distributed clocks are off for the whole bus</source>
        <translation>Verteilte Uhren sind für den ganzen Bus aus</translation>
    </message>
    <message>
        <source>Distributed clocks are off for the whole bus; the slaves' operation modes do not count.</source>
        <translation>Verteilte Uhren sind für den ganzen Bus aus; die Betriebsarten der Slaves zählen nicht.</translation>
    </message>
    <message>
        <source>Distributed clocks could not be set up</source>
        <translation>Distributed Clocks konnten nicht eingerichtet werden</translation>
    </message>
    <message>
        <source>Distributed clocks of {subject} could not be set up{because}.</source>
        <translation>Die Distributed Clocks von {subject} konnten nicht eingerichtet werden{because}.</translation>
    </message>
    <message>
        <source>EC-Master and others find variables by name: they find the first</source>
        <translation>EC-Master und andere finden Variablen nach dem Namen: sie finden die erste</translation>
    </message>
    <message>
        <source>EC-Master used to refuse such files, and cannot measure delays again while it runs</source>
        <translation>EC-Master lehnte solche Dateien früher ab und kann Laufzeiten im Betrieb nicht neu messen</translation>
    </message>
    <message>
        <source>EEPROM error</source>
        <translation>EEPROM-Fehler</translation>
    </message>
    <message>
        <source>EEPROM no access</source>
        <translation>kein Zugriff auf das EEPROM</translation>
    </message>
    <message>
        <source>ETG.2100 demands it; strict readers refuse the file, others take a default that need not fit</source>
        <translation>ETG.2100 verlangt es; strenge Leser lehnen die Datei ab, andere nehmen eine Vorgabe, die nicht passen muss</translation>
    </message>
    <message>
        <source>Each clock runs at its own speed: SYNC signals drift apart by some 10 us a second</source>
        <translation>Jede Uhr läuft mit eigener Geschwindigkeit: SYNC-Signale laufen um etwa 10 us je Sekunde auseinander</translation>
    </message>
    <message>
        <source>Elements stand in another order than ETG.2100's</source>
        <translation>Elemente stehen in einer anderen Reihenfolge als in ETG.2100</translation>
    </message>
    <message>
        <source>Elements that exclude each other</source>
        <translation>Elemente, die einander ausschließen</translation>
    </message>
    <message>
        <source>Enable of SM{manager} is off, and an init command switches it on</source>
        <translation>Enable von SM{manager} ist aus, und ein InitCmd schaltet ihn ein</translation>
    </message>
    <message>
        <source>Enable the SyncManager, or correct the physical address</source>
        <translation>Den SyncManager einschalten, oder die physikalische Adresse berichtigen</translation>
    </message>
    <message>
        <source>EoE switch</source>
        <translation>EoE-Switch</translation>
    </message>
    <message>
        <source>EoE switched off</source>
        <translation>EoE abgeschaltet</translation>
    </message>
    <message>
        <source>EtherType</source>
        <translation>EtherType</translation>
    </message>
    <message>
        <source>Ethernet over EtherCAT</source>
        <translation>Ethernet over EtherCAT</translation>
    </message>
    <message>
        <source>Events were lost, their queue was full</source>
        <translation>Ereignisse gingen verloren, ihre Warteschlange war voll</translation>
    </message>
    <message>
        <source>Every later command to PhysAddr reaches nobody</source>
        <translation>Jedes spätere Kommando an PhysAddr erreicht niemanden</translation>
    </message>
    <message>
        <source>Every tool known writes ARMW; readers that look for it alone see no distributed clocks</source>
        <translation>Alle bekannten Werkzeuge schreiben ARMW; Leser, die nur danach suchen, sehen keine verteilten Uhren</translation>
    </message>
    <message>
        <source>Every type is a sequence: readers that follow the schema refuse the file or skip what comes too late</source>
        <translation>Jeder Typ ist eine Folge: Leser, die sich an das Schema halten, lehnen die Datei ab oder überspringen, was zu spät kommt</translation>
    </message>
    <message>
        <source>Export the file again with init commands</source>
        <translation>Die Datei mit InitCmds neu exportieren</translation>
    </message>
    <message>
        <source>Export the file without signature</source>
        <translation>Die Datei ohne Signatur exportieren</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: bits are set that have to be 0</source>
        <translation>FMMU {fmmu}: es sind Bits gesetzt, die 0 sein müssen</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it gives bits that FMMU {number} of {other} gives, too</source>
        <translation>FMMU {fmmu}: sie liefert Bits, die auch FMMU {number} von {other} liefert</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it maps {bytes:# byte|# bytes} at {logical} and is not active</source>
        <translation>FMMU {fmmu}: sie bildet {bytes:# Byte|# Bytes} bei {logical} ab und ist nicht aktiv</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it maps {first} to {last}, SM{manager} is {begin} to {end}</source>
        <translation>FMMU {fmmu}: sie bildet {first} bis {last} ab, SM{manager} ist {begin} bis {end}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it takes bits that FMMU {number} of {other} takes, too</source>
        <translation>FMMU {fmmu}: sie nimmt Bits, die auch FMMU {number} von {other} nimmt</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it {does} SM{manager}, which is {kind}</source>
        <translation>FMMU {fmmu}: sie {does} SM{manager}, der {kind} ist</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: memory {first} to {last} belongs to no SyncManager that is on</source>
        <translation>FMMU {fmmu}: der Speicher {first} bis {last} gehört zu keinem eingeschalteten SyncManager</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command reads {first} to {last} in OP</source>
        <translation>FMMU {fmmu}: kein zyklisches Kommando liest {first} bis {last} in OP</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command reads {first} to {last} in SAFEOP</source>
        <translation>FMMU {fmmu}: kein zyklisches Kommando liest {first} bis {last} in SAFEOP</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command writes {first} to {last} in OP</source>
        <translation>FMMU {fmmu}: kein zyklisches Kommando schreibt {first} bis {last} in OP</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: {bytes:# byte|# bytes} from bit {first_bit} to bit {last_bit} at {logical}, {activity}</source>
        <translation>FMMU {fmmu}: {bytes:# Byte|# Bytes} von Bit {first_bit} bis Bit {last_bit} bei {logical}, {activity}</translation>
    </message>
    <message>
        <source>FMMUs (0x0600)</source>
        <translation>FMMUs (0x0600)</translation>
    </message>
    <message>
        <source>Find out what held the host.</source>
        <translation>Herausfinden, was den Rechner aufhielt.</translation>
    </message>
    <message>
        <source>Find out what held the host; its SYNC0 is not the reason.</source>
        <translation>Herausfinden, was den Rechner aufhielt; SYNC0 ist nicht der Grund.</translation>
    </message>
    <message>
        <source>Find out where the frames are lost; its SYNC0 is not the reason.</source>
        <translation>Herausfinden, wo die Frames verloren gehen; SYNC0 ist nicht der Grund.</translation>
    </message>
    <message>
        <source>Frames and SYNC0 wander through each other: now and then a set value is missed or used twice</source>
        <translation>Frames und SYNC0 wandern durcheinander: hin und wieder wird ein Sollwert verpasst oder doppelt benutzt</translation>
    </message>
    <message>
        <source>Frames are damaged on a cable</source>
        <translation>Frames werden auf einem Kabel beschädigt</translation>
    </message>
    <message>
        <source>Frames are lost behind a slave</source>
        <translation>Frames gehen hinter einem Slave verloren</translation>
    </message>
    <message>
        <source>Frames are lost by noise</source>
        <translation>Frames gehen durch Störungen verloren</translation>
    </message>
    <message>
        <source>Frames are lost by the host</source>
        <translation>Frames gehen durch den Host verloren</translation>
    </message>
    <message>
        <source>Frames came back after their deadline</source>
        <translation>Frames kamen nach ihrer Frist zurück</translation>
    </message>
    <message>
        <source>Frames come back after their cycle</source>
        <translation>Frames kommen nach ihrem Zyklus zurück</translation>
    </message>
    <message>
        <source>Frames come close to SYNC0</source>
        <translation>Frames kommen knapp vor SYNC0</translation>
    </message>
    <message>
        <source>Frames did not come back</source>
        <translation>Frames kamen nicht zurück</translation>
    </message>
    <message>
        <source>Frames do not come back</source>
        <translation>Frames kommen nicht zurück</translation>
    </message>
    <message>
        <source>Frames do not pass a port that has a link</source>
        <translation>Frames gehen nicht durch einen Port, der einen Link hat</translation>
    </message>
    <message>
        <source>Frames enter a slave by another port than A</source>
        <translation>Frames kommen über einen anderen Port als A in einen Slave</translation>
    </message>
    <message>
        <source>Frames enter it by another port than A. Swap its cables IN and OUT: until then slaves behind it stand in front of it, an ENI file cannot tell what hangs on its port A, and other masters take its propagation delay wrong.</source>
        <translation>Frames treten durch einen anderen Port als A ein. Seine Kabel IN und OUT tauschen: bis dahin stehen Slaves hinter ihm vor ihm, eine ENI-Datei kann nicht sagen, was an seinem Port A hängt, und andere Master berechnen seine Laufzeit falsch.</translation>
    </message>
    <message>
        <source>Frames enter {slave} by port {port} instead of port A.</source>
        <translation>Frames kommen in {slave} über Port {port} statt über Port A.</translation>
    </message>
    <message>
        <source>Frames meet those of the next cycle, requests to slaves find no room, and slaves do not reach OP or fall from it</source>
        <translation>Frames treffen die des nächsten Zyklus, Anfragen an Slaves finden keinen Platz, und Slaves erreichen OP nicht oder fallen daraus</translation>
    </message>
    <message>
        <source>Frames pass the slaves in the order of the file: so it can be only where frames enter that one by another port than A</source>
        <translation>Frames durchlaufen die Slaves in der Reihenfolge der Datei: so kann es nur sein, wo Frames in jenen durch einen anderen Port als A eintreten</translation>
    </message>
    <message>
        <source>Frames pass the slaves in the order of the file: the wiring told cannot exist</source>
        <translation>Frames durchlaufen die Slaves in der Reihenfolge der Datei: die genannte Verdrahtung kann es nicht geben</translation>
    </message>
    <message>
        <source>Frames were captured in part</source>
        <translation>Frames wurden nur zum Teil aufgezeichnet</translation>
    </message>
    <message>
        <source>Frames were captured in part only</source>
        <translation>Frames wurden nur teilweise mitgeschnitten</translation>
    </message>
    <message>
        <source>Frames were damaged or links lost at a port</source>
        <translation>An einem Port wurden Frames beschädigt oder Links verloren</translation>
    </message>
    <message>
        <source>Frames were lost by an interruption</source>
        <translation>Frames gingen durch eine Unterbrechung verloren</translation>
    </message>
    <message>
        <source>Give Adp the slave's PhysAddr (FPxx) or AutoIncAddr (APxx)</source>
        <translation>Adp die PhysAddr (FPxx) oder AutoIncAddr (APxx) des Slaves geben</translation>
    </message>
    <message>
        <source>Give PreviousPort the PhysAddr of the slave in front</source>
        <translation>PreviousPort die PhysAddr des Slaves davor geben</translation>
    </message>
    <message>
        <source>Give Validate a Timeout in ms</source>
        <translation>Validate einen Timeout in ms geben</translation>
    </message>
    <message>
        <source>Give each command bytes of its own</source>
        <translation>Jedem Kommando eigene Bytes geben</translation>
    </message>
    <message>
        <source>Give each head an alias of its own, in the file and in the device</source>
        <translation>Jedem Kopf einen eigenen Alias geben, in der Datei und im Gerät</translation>
    </message>
    <message>
        <source>Give each mailbox a StatusBitAddr of its own</source>
        <translation>Jeder Mailbox eine eigene StatusBitAddr geben</translation>
    </message>
    <message>
        <source>Give each slave a PhysAddr of its own</source>
        <translation>Jedem Slave eine eigene PhysAddr geben</translation>
    </message>
    <message>
        <source>Give each slave a name of its own</source>
        <translation>Jedem Slave einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>Give each slave an address of its own.</source>
        <translation>Jedem Slave eine eigene Adresse geben.</translation>
    </message>
    <message>
        <source>Give each slave bits of its own</source>
        <translation>Jedem Slave eigene Bits geben</translation>
    </message>
    <message>
        <source>Give each variable a name of its own</source>
        <translation>Jeder Variablen einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>Give it Data or DataLength</source>
        <translation>Ihm Data oder DataLength geben</translation>
    </message>
    <message>
        <source>Give it a longer cycle, or fewer objects and functions in each.</source>
        <translation>Einen längeren Zyklus geben, oder weniger Objekte und Funktionen in jedem.</translation>
    </message>
    <message>
        <source>Give it an address from 1 on.</source>
        <translation>Ihm eine Adresse ab 1 geben.</translation>
    </message>
    <message>
        <source>Give it an address from 1 on; tools start at 1001</source>
        <translation>Ihm eine Adresse ab 1 geben; Werkzeuge beginnen bei 1001</translation>
    </message>
    <message>
        <source>Give it data, or disable it</source>
        <translation>Ihm Daten geben oder es abschalten</translation>
    </message>
    <message>
        <source>Give it the Adp of the ARMW, or remove it</source>
        <translation>Ihm Adp des ARMW geben, oder es entfernen</translation>
    </message>
    <message>
        <source>Give one of them another alias.</source>
        <translation>Einem von ihnen einen anderen Alias geben.</translation>
    </message>
    <message>
        <source>Give the FMMU start and length of the SyncManager</source>
        <translation>Der FMMU Anfang und Länge des SyncManagers geben</translation>
    </message>
    <message>
        <source>Give the head an IdentifyCmd with Validate (alias 0x0012 or the device's ID)</source>
        <translation>Dem Kopf ein IdentifyCmd mit Validate geben (Alias 0x0012 oder die ID des Geräts)</translation>
    </message>
    <message>
        <source>Give the master a processor of its own and real-time priority, or increase the set value.</source>
        <translation>Dem Master einen eigenen Prozessor und Echtzeitpriorität geben, oder den Sollwert erhöhen.</translation>
    </message>
    <message>
        <source>Give the master real-time priority above what else runs on this host, or a processor of its own.</source>
        <translation>Dem Master eine Echtzeitpriorität über allem anderen auf diesem Rechner geben, oder einen Prozessor für sich allein.</translation>
    </message>
    <message>
        <source>Give the slave a DC element and the write of 0x0980, or neither</source>
        <translation>Dem Slave ein Element DC und das Schreiben von 0x0980 geben, oder keins von beiden</translation>
    </message>
    <message>
        <source>Give them logical addresses that do not meet, or states that exclude each other</source>
        <translation>Ihnen logische Adressen geben, die sich nicht treffen, oder Zustände, die einander ausschließen</translation>
    </message>
    <message>
        <source>Grant it once with: {detail}</source>
        <translation>Einmalig erteilen mit: {detail}</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>Hängt an</translation>
    </message>
    <message>
        <source>Host and reference clock drift apart by more than 600 ppm; look at the host's timer or choose another reference clock.</source>
        <translation>Host und Referenzuhr laufen um mehr als 600 ppm auseinander; nach dem Timer des Hosts sehen oder eine andere Referenzuhr wählen.</translation>
    </message>
    <message>
        <source>Hot-connect group</source>
        <translation>Hot-Connect-Gruppe</translation>
    </message>
    <message>
        <source>How the mailbox is polled is not said</source>
        <translation>Wie die Mailbox abgefragt wird, ist nicht gesagt</translation>
    </message>
    <message>
        <source>INIT, PREOP, SAFEOP or OP</source>
        <translation>INIT, PREOP, SAFEOP oder OP</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Identification of the hot-connect group</source>
        <translation>Kennung der Hot-Connect-Gruppe</translation>
    </message>
    <message>
        <source>Image offsets in the way of TwinCAT</source>
        <translation>Offsets des Abbilds nach der Art von TwinCAT</translation>
    </message>
    <message>
        <source>Import the whole file.</source>
        <translation>Die ganze Datei importieren.</translation>
    </message>
    <message>
        <source>Import with the ESI of the device's revision.</source>
        <translation>Mit der ESI der Revision des Geräts importieren.</translation>
    </message>
    <message>
        <source>In INIT and BOOT there is no CoE: the command fails and the transition with it</source>
        <translation>In INIT und BOOT gibt es kein CoE: das Kommando scheitert und mit ihm der Übergang</translation>
    </message>
    <message>
        <source>In SAFEOP inputs are valid already; the application sees zeros until OP</source>
        <translation>In SAFEOP sind Eingänge schon gültig; die Anwendung sieht bis OP Nullen</translation>
    </message>
    <message>
        <source>Increase the set value by {more} or more, or make the host less late.</source>
        <translation>Den Sollwert um {more} oder mehr erhöhen, oder den Rechner pünktlicher machen.</translation>
    </message>
    <message>
        <source>Increase the set value by {more} or more.</source>
        <translation>Den Sollwert um {more} oder mehr erhöhen.</translation>
    </message>
    <message>
        <source>Init command</source>
        <translation>Init-Kommando</translation>
    </message>
    <message>
        <source>Init commands</source>
        <translation>Init-Kommandos</translation>
    </message>
    <message>
        <source>InputOffs and OutputOffs count datagram headers, the data stand {bytes:# byte|# bytes} behind</source>
        <translation>InputOffs und OutputOffs zählen Datagrammköpfe mit, die Daten stehen {bytes:# Byte|# Bytes} dahinter</translation>
    </message>
    <message>
        <source>InputOffs counts datagram headers, the data stand 10 bytes behind; EC-Engineer writes the offsets of the data</source>
        <translation>InputOffs zählt Datagrammköpfe mit, die Daten stehen 10 Bytes dahinter; EC-Engineer schreibt die Offsets der Daten</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Inputs are latched too late</source>
        <translation>Eingänge werden zu spät übernommen</translation>
    </message>
    <message>
        <source>Inputs are not read in SAFEOP</source>
        <translation>Eingänge werden in SAFEOP nicht gelesen</translation>
    </message>
    <message>
        <source>Inputs overwrite each other, or both slaves get the same outputs</source>
        <translation>Eingänge überschreiben einander, oder beide Slaves bekommen dieselben Ausgänge</translation>
    </message>
    <message>
        <source>Integers are signed decimals (xs:int), booleans 0, 1, true or false: strict readers refuse 0x..., #x..., numbers above 2147483647 and blanks between bytes</source>
        <translation>Ganze Zahlen sind Dezimalzahlen mit Vorzeichen (xs:int), Wahrheitswerte 0, 1, true oder false: strenge Leser lehnen 0x..., #x..., Zahlen über 2147483647 und Leerzeichen zwischen Bytes ab</translation>
    </message>
    <message>
        <source>Interpolated position mode 1 needs SYNC0; only its mode 2 works without</source>
        <translation>Die Betriebsart Interpolated Position 1 braucht SYNC0; nur ihre Art 2 geht ohne</translation>
    </message>
    <message>
        <source>It cannot be sent</source>
        <translation>Es kann nicht gesendet werden</translation>
    </message>
    <message>
        <source>It cannot be set: {reason}.</source>
        <translation>Sie lässt sich nicht setzen: {reason}.</translation>
    </message>
    <message>
        <source>It fails or changes nothing, and the transition ends there</source>
        <translation>Es schlägt fehl oder ändert nichts, und der Übergang endet dort</translation>
    </message>
    <message>
        <source>It fails unless the first answer fits; other masters take 0 for a default of their own</source>
        <translation>Sie scheitert, wenn nicht schon die erste Antwort passt; andere Master nehmen 0 als ihre eigene Vorgabe</translation>
    </message>
    <message>
        <source>It had no outputs for longer than its watchdog time.</source>
        <translation>Er hatte länger als seine Watchdog-Zeit keine Ausgänge.</translation>
    </message>
    <message>
        <source>It has no effect</source>
        <translation>Sie hat keine Wirkung</translation>
    </message>
    <message>
        <source>It is another kind of file</source>
        <translation>Es ist eine andere Art von Datei</translation>
    </message>
    <message>
        <source>It is not known whether slaves are in sync</source>
        <translation>Es ist nicht bekannt, ob die Slaves synchron sind</translation>
    </message>
    <message>
        <source>It is open which of the two mappings counts</source>
        <translation>Es ist offen, welches der beiden Mappings gilt</translation>
    </message>
    <message>
        <source>It maps nothing, and the slave's data never move</source>
        <translation>Sie bildet nichts ab, und die Daten des Slaves bewegen sich nie</translation>
    </message>
    <message>
        <source>It protects registers or nothing, and the slave refuses it</source>
        <translation>Er schützt Register oder nichts, und der Slave lehnt ihn ab</translation>
    </message>
    <message>
        <source>It starts its CAN cycles with other frames than meant</source>
        <translation>Es beginnt seine CAN-Zyklen mit anderen Frames als gemeint</translation>
    </message>
    <message>
        <source>It writes {object}, and a setting writes another value there ({command}).</source>
        <translation>Es schreibt {object}, und eine Einstellung schreibt dort einen anderen Wert ({command}).</translation>
    </message>
    <message>
        <source>Its bytes are not those that were written: a disk, a copy or another program has changed them. What is left out was recorded, and nothing is known of it any more.</source>
        <translation>Ihre Bytes sind nicht die, die geschrieben wurden: Ein Datenträger, eine Kopie oder ein anderes Programm hat sie verändert. Was fehlt, war aufgezeichnet, und nichts ist mehr davon bekannt.</translation>
    </message>
    <message>
        <source>Its clock stepped or lost its reference; switch sync-window monitoring on to be told at once.</source>
        <translation>Die Uhr ist gesprungen oder hat ihre Referenz verloren; Sync-Window-Überwachung einschalten, um es sofort zu erfahren.</translation>
    </message>
    <message>
        <source>Its data come every {cycle}, {least} is the shortest cycle that its object 0x1C32:05 names.</source>
        <translation>Seine Daten kommen alle {cycle}, {least} ist der kürzeste Zyklus, den sein Objekt 0x1C32:05 nennt.</translation>
    </message>
    <message>
        <source>Its description is what its EEPROM says.</source>
        <translation>Beschrieben ist er durch sein EEPROM.</translation>
    </message>
    <message>
        <source>Its firmware is busy or stopped; the counters that it keeps in objects are as old as that.</source>
        <translation>Seine Firmware ist beschäftigt oder steht; die Zähler in seinen Objekten sind so alt wie das.</translation>
    </message>
    <message>
        <source>Its firmware takes longer than the cycle: look for what else it has to do, give it a longer cycle, or fewer objects.</source>
        <translation>Seine Firmware braucht länger als den Zyklus: nach dem suchen, was sie sonst zu tun hat, einen längeren Zyklus geben oder weniger Objekte.</translation>
    </message>
    <message>
        <source>Its outputs and inputs are older than the cycle.</source>
        <translation>Seine Ausgänge und Eingänge sind älter als der Zyklus.</translation>
    </message>
    <message>
        <source>Its outputs and inputs stood still meanwhile. Look for what stops it: an interrupt storm, a debugger, a crash.</source>
        <translation>Ausgänge und Eingänge standen währenddessen still. Suchen, was sie anhält: ein Interrupt-Sturm, ein Debugger, ein Absturz.</translation>
    </message>
    <message>
        <source>Its outputs come nominally {margin} before SYNC0, and it needs {need} for them; look at its firmware's load, or at frames that are damaged in front of it.</source>
        <translation>Die Ausgänge kommen nominell {margin} vor SYNC0, und er braucht {need} für sie; die Last seiner Firmware ansehen, oder Frames, die vor ihm beschädigt werden.</translation>
    </message>
    <message>
        <source>Its propagation delay is measured wrong by many masters.</source>
        <translation>Viele Master messen seine Laufzeit falsch.</translation>
    </message>
    <message>
        <source>Its serial number is to be compared at start-up, but the project has none (0 stands for any): nothing is compared.</source>
        <translation>Seine Seriennummer soll beim Hochlauf verglichen werden, das Projekt hat aber keine (0 steht für jede): Es wird nichts verglichen.</translation>
    </message>
    <message>
        <source>Its start time (0x0990) had passed when it was taken, or its SYNC unit was not switched on (0x0981). Let the start times begin later (master.dc.start_time_safety_us), or look at who else writes its registers.</source>
        <translation>Seine Startzeit (0x0990) war vorbei, als sie übernommen wurde, oder seine SYNC-Einheit wurde nicht eingeschaltet (0x0981). Lassen Sie die Startzeiten später beginnen (master.dc.start_time_safety_us), oder sehen Sie nach, wer sonst seine Register schreibt.</translation>
    </message>
    <message>
        <source>Its start time (0x0990) was not taken as it was written. Start it anew; if it stays, look at the slave's firmware, or at who else writes its registers.</source>
        <translation>Seine Startzeit (0x0990) wurde nicht so übernommen, wie sie geschrieben wurde. Starten Sie ihn neu; bleibt es dabei, sehen Sie nach der Firmware des Slaves, oder wer sonst seine Register schreibt.</translation>
    </message>
    <message>
        <source>Its working counter stays 0 in each cycle</source>
        <translation>Sein Working Counter bleibt in jedem Zyklus 0</translation>
    </message>
    <message>
        <source>Keep one of the two</source>
        <translation>Eins von beiden behalten</translation>
    </message>
    <message>
        <source>Keep the ESI's mapping.</source>
        <translation>Das Mapping der ESI behalten.</translation>
    </message>
    <message>
        <source>Keep the default assignment.</source>
        <translation>Die Standardzuordnung behalten.</translation>
    </message>
    <message>
        <source>Latch them earlier: a smaller input shift time.</source>
        <translation>Früher einlesen: eine kleinere Input Shift Time.</translation>
    </message>
    <message>
        <source>Leave ReferenceClock on at the slave that the ARMW addresses</source>
        <translation>ReferenceClock nur bei dem Slave lassen, den das ARMW anspricht</translation>
    </message>
    <message>
        <source>Lengthen the cycle, exchange less, or let slow slaves run in a task of their own</source>
        <translation>Den Zyklus verlängern, weniger austauschen, oder langsame Slaves in einer eigenen Task laufen lassen</translation>
    </message>
    <message>
        <source>Lengthen the cycle, or exchange less</source>
        <translation>Den Zyklus verlängern, oder weniger austauschen</translation>
    </message>
    <message>
        <source>Let 0x09A0 have CycleTime0 and CycleTime1</source>
        <translation>0x09A0 dieselben Werte wie CycleTime0 und CycleTime1 geben</translation>
    </message>
    <message>
        <source>Let Adp of the ARMW and ReferenceClock name the same slave</source>
        <translation>Adp des ARMW und ReferenceClock denselben Slave nennen lassen</translation>
    </message>
    <message>
        <source>Let Enable and the command say the same</source>
        <translation>Enable und Kommando dasselbe sagen lassen</translation>
    </message>
    <message>
        <source>Let SYNC1 come at SYNC0 or after it.</source>
        <translation>SYNC1 bei SYNC0 oder danach kommen lassen.</translation>
    </message>
    <message>
        <source>Let a command cover the FMMU's logical addresses, or correct the FMMU</source>
        <translation>Ein Kommando die logischen Adressen der FMMU abdecken lassen, oder die FMMU berichtigen</translation>
    </message>
    <message>
        <source>Let a read of 0x0508 follow each request to 0x0502 (0x0100 and the address of the word)</source>
        <translation>Auf jede Anforderung an 0x0502 (0x0100 und die Adresse des Worts) ein Lesen von 0x0508 folgen lassen</translation>
    </message>
    <message>
        <source>Let a slave that is always there come first.</source>
        <translation>Einen Slave nach vorn stellen, der immer da ist.</translation>
    </message>
    <message>
        <source>Let its SYNC0 come {more} later: a shift of {shift}.</source>
        <translation>SYNC0 um {more} später legen: eine Verschiebung von {shift}.</translation>
    </message>
    <message>
        <source>Let the application copy the data.</source>
        <translation>Die Anwendung die Daten kopieren lassen.</translation>
    </message>
    <message>
        <source>Let the attribute Sm name the SyncManager whose list has the PDO, or leave it out</source>
        <translation>Das Attribut Sm den SyncManager nennen lassen, dessen Liste das PDO hat, oder es weglassen</translation>
    </message>
    <message>
        <source>Let the command have PREOP, SAFEOP and OP</source>
        <translation>Dem Kommando PREOP, SAFEOP und OP geben</translation>
    </message>
    <message>
        <source>Let the data of 0x0990 be ShiftTime</source>
        <translation>Die Daten von 0x0990 gleich ShiftTime setzen</translation>
    </message>
    <message>
        <source>Line {line} is not read: a Slave without address, commands and data, as tools write end caps.</source>
        <translation>Zeile {line} wird nicht gelesen: ein Slave ohne Adresse, Kommandos und Daten, wie Werkzeuge Endkappen schreiben.</translation>
    </message>
    <message>
        <source>Line {line} is not read: {what}.</source>
        <translation>Zeile {line} wird nicht gelesen: {what}.</translation>
    </message>
    <message>
        <source>Line {line}, the last one, has no end: its last cell may be cut off.</source>
        <translation>Zeile {line}, die letzte, hat kein Ende: Ihre letzte Zelle ist womöglich abgeschnitten.</translation>
    </message>
    <message>
        <source>Line {line}, the last one, is cut off and left out.</source>
        <translation>Zeile {line}, die letzte, ist abgeschnitten und fehlt.</translation>
    </message>
    <message>
        <source>List them with "synclinectl adapters".</source>
        <translation>"synclinectl adapters" listet sie auf.</translation>
    </message>
    <message>
        <source>Load its ESI file.</source>
        <translation>Seine ESI-Datei laden.</translation>
    </message>
    <message>
        <source>Logical address of the mailbox state bits</source>
        <translation>Logische Adresse der Zustandsbits der Mailboxen</translation>
    </message>
    <message>
        <source>Look at the cables and plugs behind it, and at the way back: the network card and its driver receive there.</source>
        <translation>Sehen Sie nach Kabeln und Steckern dahinter und nach dem Rückweg: dort empfangen die Netzwerkkarte und ihr Treiber.</translation>
    </message>
    <message>
        <source>Look at the deviations of the single slaves.</source>
        <translation>Die Abweichungen der einzelnen Slaves ansehen.</translation>
    </message>
    <message>
        <source>Look at the device behind it.</source>
        <translation>Nach dem Gerät dahinter sehen.</translation>
    </message>
    <message>
        <source>Look for what makes frames late, in the host or behind it: the frame behind a late one comes sooner after it. Its firmware is not the reason.</source>
        <translation>Suchen Sie, was Frames verspätet, im Rechner oder dahinter: Der Frame nach einem späten folgt ihm zu bald. Die Firmware ist nicht der Grund.</translation>
    </message>
    <message>
        <source>Look for what stops it: an interrupt storm, a debugger, a crash.</source>
        <translation>Suchen, was sie anhält: ein Interrupt-Sturm, ein Debugger, ein Absturz.</translation>
    </message>
    <message>
        <source>Lost on the bus and lost by who captured look alike. A mirror port of a switch passes over frames when both ways together are more than it carries, and gives no two frames their true distance.</source>
        <translation>Auf dem Bus verloren und beim Aufzeichnen verloren sieht gleich aus. Ein Spiegelport eines Switches lässt Frames aus, wenn beide Richtungen zusammen mehr sind, als er trägt, und gibt keinen zwei Frames ihren wahren Abstand.</translation>
    </message>
    <message>
        <source>Mend the clock; neither the slave's firmware nor its shift is the reason.</source>
        <translation>Bringen Sie die Uhr in Ordnung; weder die Firmware des Slaves noch seine Verschiebung ist der Grund.</translation>
    </message>
    <message>
        <source>Names of many variables</source>
        <translation>Namen vieler Variablen</translation>
    </message>
    <message>
        <source>Only frames on their way back were captured: round trips and lost frames are not known.</source>
        <translation>Nur Frames auf dem Rückweg wurden aufgezeichnet: Umlaufzeiten und verlorene Frames sind nicht bekannt.</translation>
    </message>
    <message>
        <source>Read it from another copy; what is shown beside it is as it was written.</source>
        <translation>Aus einer anderen Kopie lesen; was daneben gezeigt wird, ist wie geschrieben.</translation>
    </message>
    <message>
        <source>Replies are missing in an imported capture</source>
        <translation>In einer importierten Aufzeichnung fehlen Antworten</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged and left out</source>
        <translation>Zeile {row} der Tabelle {table} ist beschädigt und fehlt</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged: cycles {first} to {last} are a gap</source>
        <translation>Zeile {row} der Tabelle {table} ist beschädigt: Die Zyklen {first} bis {last} sind eine Lücke</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged: {signal} is not known in cycles {first} to {last}</source>
        <translation>Zeile {row} der Tabelle {table} ist beschädigt: {signal} ist in den Zyklen {first} bis {last} nicht bekannt</translation>
    </message>
    <message>
        <source>SM2 events were missed because a clock had moved</source>
        <translation>SM2-Ereignisse fehlten, weil eine Uhr verrückt war</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} comes {off} before its place in the cycle: its outputs are there {margin} before it, and it needs {need} for them.</source>
        <translation>SYNC0 von {slave} kommt {off} vor seinem Platz im Zyklus: seine Ausgänge sind {margin} davor da, und er braucht {need} für sie.</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} comes {off} behind its place in the cycle: its outputs are there {margin} before it, and it needs {need} for them.</source>
        <translation>SYNC0 von {slave} kommt {off} hinter seinem Platz im Zyklus: seine Ausgänge sind {margin} davor da, und er braucht {need} für sie.</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} will not come: it has no start time ahead of it.</source>
        <translation>SYNC0 von {slave} wird nicht kommen: es hat keine Startzeit vor sich.</translation>
    </message>
    <message>
        <source>See that nobody stops the program: a debugger, SIGSTOP. Else look below the operating system: the host of a virtual machine, firmware (system management interrupts), power states, drivers that hold interrupts off. Run the master on a machine of its own.</source>
        <translation>Sicherstellen, dass niemand das Programm anhält: ein Debugger, SIGSTOP. Sonst unter dem Betriebssystem suchen: der Wirt einer virtuellen Maschine, Firmware (System Management Interrupts), Energiezustände, Treiber, die Interrupts sperren. Den Master auf einer eigenen Maschine betreiben.</translation>
    </message>
    <message>
        <source>Look for a busy host or a clock that stepped; if neither is there, choose the other shift mode.</source>
        <translation>Nach einem beschäftigten Rechner oder einer gesprungenen Uhr suchen; ist beides nicht da, die andere Art der Synchronisation wählen.</translation>
    </message>
    <message>
        <source>Look for a cable back to the master, or a device that is no slave.</source>
        <translation>Nach einem Kabel zurück zum Master suchen, oder nach einem Gerät, das kein Slave ist.</translation>
    </message>
    <message>
        <source>Look for what held it: another process of higher priority, power management, the virtual machine's host.</source>
        <translation>Suchen, was ihn aufhielt: ein anderer Prozess mit höherer Priorität, Energiesparen, der Wirt der virtuellen Maschine.</translation>
    </message>
    <message>
        <source>Slaves followed with delays that were not theirs</source>
        <translation>Slaves folgten mit Verzögerungen, die nicht ihre waren</translation>
    </message>
    <message>
        <source>Slaves were up to {deviation} off the reference clock, {slave}, at {since}, at once and to the same side, and nobody monitors them. It is that clock which moved{led}.</source>
        <translation>Slaves wichen bei {since} um bis zu {deviation} von der Referenzuhr ab, {slave}, zugleich und zur selben Seite, und niemand überwacht das. Es ist diese Uhr, die sich bewegt hat{led}.</translation>
    </message>
    <message>
        <source>SyncManager of PDO {pdo}</source>
        <translation>SyncManager des PDO {pdo}</translation>
    </message>
    <message>
        <source>The capture breaks off behind {frames:# frame|# frames} ({reason}): what came before is imported.</source>
        <translation>Der Mitschnitt bricht nach {frames:# Frame|# Frames} ab ({reason}): Was davor kam, ist importiert.</translation>
    </message>
    <message>
        <source>The file ends in the middle of a line: whoever has written or copied it did not come to its end.</source>
        <translation>Die Datei endet mitten in einer Zeile: Wer sie geschrieben oder kopiert hat, kam nicht bis ans Ende.</translation>
    </message>
    <message>
        <source>The frames' way to slaves has changed</source>
        <translation>Der Weg der Frames zu Slaves hat sich geändert</translation>
    </message>
    <message>
        <source>Their own readings (0x092C) do not show it for long. Where delays were not measured anew, a device that nobody knows stands on the bus: set it up or take it away, before positions are compared across it.</source>
        <translation>Ihre eigenen Ablesungen (0x092C) zeigen es nicht lange. Wo die Verzögerungen nicht neu gemessen wurden, steht ein Gerät am Bus, das niemand kennt: Richten Sie es ein oder entfernen Sie es, ehe Positionen über es hinweg verglichen werden.</translation>
    </message>
    <message>
        <source>Times are software stamps of the host that captured.</source>
        <translation>Zeiten sind Software-Stempel des Rechners, der aufgezeichnet hat.</translation>
    </message>
    <message>
        <source>Times are the hardware stamps of a probe, which the frames carry; dated by the first frame.</source>
        <translation>Zeiten sind die Hardware-Stempel einer Sonde, die die Frames tragen; datiert nach dem ersten Frame.</translation>
    </message>
    <message>
        <source>Times of a probe are good to nanoseconds. Those of a host hold its interrupts and its clock, too: what is in the lateness or the round trip of a few microseconds may be its own.</source>
        <translation>Zeiten einer Sonde stimmen auf Nanosekunden. Die eines Rechners enthalten auch seine Interrupts und seine Uhr: einige Mikrosekunden in Verspätung oder Umlaufzeit können seine eigenen sein.</translation>
    </message>
    <message>
        <source>Who stamped the frames of an imported capture</source>
        <translation>Wer die Frames einer importierten Aufzeichnung gestempelt hat</translation>
    </message>
    <message>
        <source>Write it as SerialNo of the device's Type into the project file, or switch check.serial off.</source>
        <translation>Tragen Sie sie als SerialNo im Type des Geräts in die Projektdatei ein oder schalten Sie check.serial aus.</translation>
    </message>
    <message>
        <source>a signal ended the waiting for its content</source>
        <translation>ein Signal beendete das Warten auf ihren Inhalt</translation>
    </message>
    <message>
        <source>a signal ended the waiting for its reader</source>
        <translation>ein Signal beendete das Warten auf ihren Leser</translation>
    </message>
    <message>
        <source>is missing, as stamp_error and stalls are: a host profile has times for one of them</source>
        <translation>fehlt, ebenso stamp_error und stalls: ein Host-Profil hat Zeiten für eines davon</translation>
    </message>
    <message>
        <source>it follows this host's clock, which a time service may have moved</source>
        <translation>sie folgt der Uhr dieses Rechners, die ein Zeitdienst verstellt haben kann</translation>
    </message>
    <message>
        <source>it was led back to this host's clock after the network adapter had been away</source>
        <translation>sie wurde zur Uhr dieses Rechners zurückgeführt, nachdem der Netzwerkadapter weg gewesen war</translation>
    </message>
    <message>
        <source>overlaps the {fault} from {time} ms to {other} ms</source>
        <translation>überschneidet sich mit {fault} von {time} ms bis {other} ms</translation>
    </message>
    <message>
        <source>the file {file} cannot be read: {reason}</source>
        <translation>die Datei {file} kann nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <source>there is no file {file}</source>
        <translation>es gibt keine Datei {file}</translation>
    </message>
    <message>
        <source>what else is told of that moment</source>
        <translation>was sonst von diesem Zeitpunkt gemeldet ist</translation>
    </message>
    <message>
        <source>{count:# cyclic frame has|# cyclic frames have} no reply in the capture, of {frames}: lost on the bus, or by who captured.</source>
        <translation>{count:# zyklischer Frame hat|# zyklische Frames haben} in der Aufzeichnung keine Antwort, von {frames}: auf dem Bus verloren, oder beim Aufzeichnen.</translation>
    </message>
    <message>
        <source>{count:# frame has|# frames have} hardware stamps of a probe, the others of {frames} are stamped by the host that captured them: times between the two do not compare.</source>
        <translation>{count:# Frame trägt|# Frames tragen} Hardware-Stempel einer Sonde, die übrigen von {frames} hat der aufzeichnende Rechner gestempelt: Zeiten zwischen beiden sind nicht vergleichbar.</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: its firmware had stood still, its PDI watchdog expired at {stopped} (0x0443), and its SYNC0 went on without it.</source>
        <translation>{slave} fiel bei {since} nach {state} mit AL-Statuscode {alcode}{alarm}: seine Firmware hatte stillgestanden, ihr PDI-Watchdog lief bei {stopped} ab (0x0443), und sein SYNC0 lief ohne sie weiter.</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: its SYNC0 had not come where its outputs are meant for, {why}.</source>
        <translation>{slave} fiel bei {since} nach {state} mit AL-Statuscode {alcode}{alarm}: sein SYNC0 war nicht dort gekommen, wofür seine Ausgänge bestimmt sind, {why}.</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), and was led up again; just before: {why}.</source>
        <translation>{slave} war bei {since} nach {state} mit AL-Statuscode {alcode}{alarm} gefallen ({count} insgesamt) und wurde wieder hochgeführt; kurz davor: {why}.</translation>
    </message>
    <message>
        <source>{slave} went or came at {since}, and those behind it were off by up to {deviation}, until delays (0x0928) were measured anew at {renewed}.</source>
        <translation>{slave} ging oder kam bei {since}, und die dahinter waren bis zu {deviation} daneben, bis die Verzögerungen (0x0928) bei {renewed} neu gemessen wurden.</translation>
    </message>
    <message>
        <source>A recording is cut off</source>
        <translation>Eine Aufzeichnung ist abgeschnitten</translation>
    </message>
    <message>
        <source>The file is shorter than it was: a copy, a transfer or a full disk ended within it. What is shown is as it was written; of what is lost nothing is known any more.</source>
        <translation>Die Datei ist kürzer, als sie war: Eine Kopie, eine Übertragung oder ein voller Datenträger endete mitten in ihr. Was gezeigt wird, ist so, wie es geschrieben wurde; vom Verlorenen ist nichts mehr bekannt.</translation>
    </message>
    <message>
        <source>Copy the whole file once more, from where it was written.</source>
        <translation>Kopieren Sie die ganze Datei noch einmal von dort, wo sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>An imported capture was taken through a switch</source>
        <translation>Ein importierter Mitschnitt lief über einen Switch</translation>
    </message>
    <message>
        <source>A switch holds frames back, one behind the other, and stamps none: distances, round trips and jitter are its own as well, and what a mirror port cannot carry is missing.</source>
        <translation>Ein Switch hält Frames zurück, einen hinter dem anderen, und stempelt keinen: Abstände, Umlaufzeiten und Jitter sind auch seine, und was ein Spiegelport nicht fasst, fehlt.</translation>
    </message>
    <message>
        <source>Capture with a probe in the line, or on the master's own adapter.</source>
        <translation>Schneiden Sie mit einer Sonde in der Leitung mit oder auf dem Adapter des Masters.</translation>
    </message>
    <message>
        <source>{count:# frame is|# frames are} of a switch itself (spanning tree, neighbour discovery).</source>
        <translation>{count:# Frame ist|# Frames sind} von einem Switch selbst (Spanning Tree, Nachbarsuche).</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame has|# EtherCAT frames have} a VLAN tag (802.1Q), which a switch has put on.</source>
        <translation>{count:# EtherCAT-Frame hat|# EtherCAT-Frames haben} ein VLAN-Tag (802.1Q), das ein Switch angebracht hat.</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame came|# EtherCAT frames came} twice, byte for byte, as a mirror port sends what enters and leaves.</source>
        <translation>{count:# EtherCAT-Frame kam|# EtherCAT-Frames kamen} Byte für Byte zweimal, wie ein Spiegelport sendet, was hinein- und hinausgeht.</translation>
    </message>
    <message>
        <source>An imported capture was taken in a virtual machine</source>
        <translation>Ein importierter Mitschnitt stammt aus einer virtuellen Maschine</translation>
    </message>
    <message>
        <source>A hypervisor passes frames on when it gets to it, and its clock is not the host's: times are off by milliseconds at any moment.</source>
        <translation>Ein Hypervisor reicht Frames weiter, wenn er dazu kommt, und seine Uhr ist nicht die des Rechners: Zeiten liegen jederzeit um Millisekunden daneben.</translation>
    </message>
    <message>
        <source>Capture on a machine of its own, whose adapter stands at the bus.</source>
        <translation>Schneiden Sie auf einem eigenen Rechner mit, dessen Adapter am Bus hängt.</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame was|# EtherCAT frames were} sent by {address}, the adapter of a virtual machine.</source>
        <translation>{count:# EtherCAT-Frame wurde|# EtherCAT-Frames wurden} von {address} gesendet, dem Adapter einer virtuellen Maschine.</translation>
    </message>
    <message>
        <source>The file is cut off: {there} of {all} KiB are there, with {cycles:# cycle|# cycles}; {count:# block|# blocks} of values, about a second each, {count:is|are} lost</source>
        <translation>Die Datei ist abgeschnitten: {there} von {all} KiB sind da, mit {cycles:# Zyklus|# Zyklen}; {count:# Block|# Blöcke} Werte von je etwa einer Sekunde {count:ist|sind} verloren</translation>
    </message>
    <message>
        <source>SQLite refuses the file: what is shown was found page by page, with {cycles:# cycle|# cycles}; {count:# block|# blocks} of values, about a second each, {count:is|are} lost</source>
        <translation>SQLite weist die Datei ab: Was gezeigt wird, wurde Seite für Seite gefunden, mit {cycles:# Zyklus|# Zyklen}; {count:# Block|# Blöcke} Werte von je etwa einer Sekunde {count:ist|sind} verloren</translation>
    </message>
    <message>
        <source>no whole cycle of it is left</source>
        <translation>kein ganzer Zyklus von ihr ist übrig</translation>
    </message>
    <message>
        <source>The log of a recording is missing</source>
        <translation>Das Protokoll einer Aufzeichnung fehlt</translation>
    </message>
    <message>
        <source>The recording is of version {version}, whose rows carry no checks: damage in their values may not be seen.</source>
        <translation>Die Aufzeichnung hat die Version {version}, deren Zeilen keine Prüfsummen tragen: Schäden in ihren Werten bleiben womöglich unbemerkt.</translation>
    </message>
    <message>
        <source>The recording was cut short, and its log {file} is not beside it: what that held, the end of the run, is missing unless another program has taken it over.</source>
        <translation>Die Aufzeichnung wurde abgebrochen, und ihr Protokoll {file} liegt nicht daneben: Was es enthielt, das Ende des Laufs, fehlt, falls nicht ein anderes Programm es übernommen hat.</translation>
    </message>
    <message>
        <source>The rows of a recording carry no checks</source>
        <translation>Die Zeilen einer Aufzeichnung tragen keine Prüfsummen</translation>
    </message>
    <message>
        <source>The rows of block {block} contradict each other: cycles {first} to {last} are a gap</source>
        <translation>Die Zeilen des Blocks {block} widersprechen einander: Die Zyklen {first} bis {last} sind eine Lücke</translation>
    </message>
    <message>
        <source>Their own readings (0x092C) do not show it. Go online anew without the slave, or bring it back, before positions are compared across it.</source>
        <translation>Ihre eigenen Ablesungen (0x092C) zeigen es nicht. Gehen Sie ohne den Slave neu online, oder bringen Sie ihn zurück, ehe Positionen über ihn hinweg verglichen werden.</translation>
    </message>
    <message>
        <source>To change nothing on it, only look.</source>
        <translation>Um nichts an ihr zu ändern, nur ansehen.</translation>
    </message>
    <message>
        <source>MBoxOut, MBoxIn, Outputs or Inputs</source>
        <translation>MBoxOut, MBoxIn, Outputs oder Inputs</translation>
    </message>
    <message>
        <source>Mailbox</source>
        <translation>Mailbox</translation>
    </message>
    <message>
        <source>Mailbox for answers</source>
        <translation>Mailbox für Antworten</translation>
    </message>
    <message>
        <source>Mailbox for requests</source>
        <translation>Mailbox für Anfragen</translation>
    </message>
    <message>
        <source>Mailbox poll time</source>
        <translation>Abfragezeit der Mailbox</translation>
    </message>
    <message>
        <source>Mailbox protocols</source>
        <translation>Protokolle der Mailbox</translation>
    </message>
    <message>
        <source>Mailbox state bit</source>
        <translation>Zustandsbit der Mailbox</translation>
    </message>
    <message>
        <source>Mailbox state bits</source>
        <translation>Zustandsbits der Mailboxen</translation>
    </message>
    <message>
        <source>Mailbox, delays of the slaves and jitter of the master do not fit beside them</source>
        <translation>Mailbox, Laufzeiten der Slaves und Jitter des Masters passen nicht daneben</translation>
    </message>
    <message>
        <source>MailboxStates must count the bit, an FMMU on IP map it and a command read it from PREOP on</source>
        <translation>MailboxStates muss das Bit zählen, eine FMMU auf IP es abbilden und ein Kommando es ab PREOP lesen</translation>
    </message>
    <message>
        <source>Make the CAN cycle a multiple of the bus cycle</source>
        <translation>Den CAN-Zyklus zu einem Vielfachen des Buszyklus machen</translation>
    </message>
    <message>
        <source>Make the first slave with distributed clocks the reference clock</source>
        <translation>Den ersten Slave mit verteilter Uhr zur Referenzuhr machen</translation>
    </message>
    <message>
        <source>Many things in other places</source>
        <translation>Vieles an anderen Plätzen</translation>
    </message>
    <message>
        <source>Map both time stamps, or choose another mode.</source>
        <translation>Beide Zeitstempel mappen, oder eine andere Art wählen.</translation>
    </message>
    <message>
        <source>Map fewer entries.</source>
        <translation>Weniger Einträge mappen.</translation>
    </message>
    <message>
        <source>Map fewer objects and exchange the slow ones by SDO</source>
        <translation>Weniger Objekte mappen und die langsamen per SDO austauschen</translation>
    </message>
    <message>
        <source>Map fewer, or use another PDO for the rest.</source>
        <translation>Weniger mappen, oder für den Rest ein anderes PDO verwenden.</translation>
    </message>
    <message>
        <source>Map it again.</source>
        <translation>Ihn wieder mappen.</translation>
    </message>
    <message>
        <source>Mapping of a PDO</source>
        <translation>Belegung eines PDOs</translation>
    </message>
    <message>
        <source>Master and reference clock run at their own rates</source>
        <translation>Master und Referenzuhr laufen in eigenem Takt</translation>
    </message>
    <message>
        <source>Master and reference clock run at their own rates: the frame wanders through the cycle and meets SYNC0 now and then.</source>
        <translation>Master und Referenzuhr laufen in eigenem Takt: der Frame wandert durch den Zyklus und trifft hin und wieder SYNC0.</translation>
    </message>
    <message>
        <source>Master and slaves follow different clocks</source>
        <translation>Master und Slaves folgen verschiedenen Uhren</translation>
    </message>
    <message>
        <source>Masters do not use the mailbox at all</source>
        <translation>Master benutzen die Mailbox überhaupt nicht</translation>
    </message>
    <message>
        <source>Masters find the write of bus shift behind the ARMW: before it they steer by the time of the cycle before, or take it for something else</source>
        <translation>Master suchen das Schreiben des Bus-Shifts hinter dem ARMW: davor stellen sie nach der Zeit des Zyklus zuvor oder halten es für etwas anderes</translation>
    </message>
    <message>
        <source>Masters of other makers ignore it, so whatever it sets is lost there</source>
        <translation>Master anderer Hersteller übergehen es, so dass dort verloren ist, was es einstellt</translation>
    </message>
    <message>
        <source>Masters run slower tasks in every n-th cycle of the first one</source>
        <translation>Master führen langsamere Tasks in jedem n-ten Zyklus der ersten aus</translation>
    </message>
    <message>
        <source>Masters skip them, or give up when the slave refuses the protocol</source>
        <translation>Master überspringen sie, oder geben auf, wenn der Slave das Protokoll ablehnt</translation>
    </message>
    <message>
        <source>Masters take the shift from the one or from the other</source>
        <translation>Master nehmen die Verschiebung vom einen oder vom anderen</translation>
    </message>
    <message>
        <source>Masters that go by the element set the slave up in another way than those that go by the commands</source>
        <translation>Master, die nach dem Element gehen, richten den Slave anders ein als solche, die nach den Kommandos gehen</translation>
    </message>
    <message>
        <source>Mend the lock first.</source>
        <translation>Zuerst das Einrasten in Ordnung bringen.</translation>
    </message>
    <message>
        <source>Mend the value at the line named, then check again</source>
        <translation>Den Wert in der genannten Zeile berichtigen, dann neu prüfen</translation>
    </message>
    <message>
        <source>Mend what is found about that port.</source>
        <translation>Beheben, was zu diesem Port gefunden ist.</translation>
    </message>
    <message>
        <source>Messages do not fit, into the mailbox or into a frame, and every object access fails</source>
        <translation>Nachrichten passen nicht, in die Mailbox oder in einen Frame, und jeder Objektzugriff scheitert</translation>
    </message>
    <message>
        <source>Module {module} does not fit into place {place}.</source>
        <translation>Modul {module} passt nicht auf Platz {place}.</translation>
    </message>
    <message>
        <source>Module {module} in place {place} demands the operation mode {mode}.</source>
        <translation>Modul {module} auf Platz {place} verlangt die Betriebsart {mode}.</translation>
    </message>
    <message>
        <source>More PDOs are assigned than an object takes</source>
        <translation>Es sind mehr PDOs zugeordnet, als ein Objekt annimmt</translation>
    </message>
    <message>
        <source>More entries are mapped than an object takes</source>
        <translation>Es sind mehr Einträge gemappt, als ein Objekt annimmt</translation>
    </message>
    <message>
        <source>More entries are mapped than the device has room for</source>
        <translation>Es sind mehr Einträge gemappt, als das Gerät Platz hat</translation>
    </message>
    <message>
        <source>More objects are mapped than the device takes</source>
        <translation>Es sind mehr Objekte gemappt, als das Gerät annimmt</translation>
    </message>
    <message>
        <source>More than one reference clock</source>
        <translation>Mehr als eine Referenzuhr</translation>
    </message>
    <message>
        <source>Move commands to another frame; 1498 bytes of datagrams fit into one, 12 of each are its own</source>
        <translation>Kommandos in einen anderen Frame legen; 1498 Bytes Datagramme passen in einen, je 12 davon sind ihre eigenen</translation>
    </message>
    <message>
        <source>Move it to IP, PS or SO</source>
        <translation>Es nach IP, PS oder SO legen</translation>
    </message>
    <message>
        <source>Move one of them to logical addresses of its own</source>
        <translation>Eine davon auf eigene logische Adressen legen</translation>
    </message>
    <message>
        <source>Move one of them to logical addresses of its own, unless both shall do the same</source>
        <translation>Eine davon auf eigene logische Adressen legen, wenn nicht beide dasselbe tun sollen</translation>
    </message>
    <message>
        <source>Move the command before the AL control write</source>
        <translation>Das Kommando vor das Schreiben von AL Control setzen</translation>
    </message>
    <message>
        <source>Move the element to its place</source>
        <translation>Das Element an seinen Platz setzen</translation>
    </message>
    <message>
        <source>Move the write of 0x0980 before the AL control write</source>
        <translation>Das Schreiben von 0x0980 vor das Schreiben von AL Control setzen</translation>
    </message>
    <message>
        <source>Name the protocols that the device has</source>
        <translation>Die Protokolle nennen, die das Gerät hat</translation>
    </message>
    <message>
        <source>Neither can be known by it.</source>
        <translation>Keinen von beiden kann man daran erkennen.</translation>
    </message>
    <message>
        <source>No ESI file describes a device</source>
        <translation>Keine ESI-Datei beschreibt ein Gerät</translation>
    </message>
    <message>
        <source>No ESI file describes a slave</source>
        <translation>Keine ESI-Datei beschreibt einen Slave</translation>
    </message>
    <message>
        <source>No ESI file describes {slave} ({identity}).</source>
        <translation>Keine ESI-Datei beschreibt {slave} ({identity}).</translation>
    </message>
    <message>
        <source>No ESI file describes {subject}.</source>
        <translation>Keine ESI-Datei beschreibt {subject}.</translation>
    </message>
    <message>
        <source>No ESI of the device is at hand</source>
        <translation>Keine ESI des Geräts ist zur Hand</translation>
    </message>
    <message>
        <source>No ESI of {identity} is at hand: the device is described by what the ENI uses of it; other PDOs, operation modes and objects are unknown.</source>
        <translation>Keine ESI von {identity} ist zur Hand: das Gerät wird durch das beschrieben, was die ENI von ihm benutzt; andere PDOs, Betriebsarten und Objekte sind unbekannt.</translation>
    </message>
    <message>
        <source>No SyncManager can carry PDO {pdo}.</source>
        <translation>Kein SyncManager kann das PDO {pdo} tragen.</translation>
    </message>
    <message>
        <source>No SyncManager can carry a PDO</source>
        <translation>Kein SyncManager kann ein PDO tragen</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>No answer from {slaves} from {since} on, for {length} ({count} in all).</source>
        <translation>Keine Antwort von {slaves} ab {since}, {length} lang ({count} insgesamt).</translation>
    </message>
    <message>
        <source>No answer from {slaves} since {since}: nothing comes back over the cable at {near} port {port}.</source>
        <translation>Keine Antwort von {slaves} seit {since}: über das Kabel an {near} Port {port} kommt nichts zurück.</translation>
    </message>
    <message>
        <source>No answer from {slaves} since {since}; {near} is the last that answers.</source>
        <translation>Keine Antwort von {slaves} seit {since}; {near} ist der letzte, der antwortet.</translation>
    </message>
    <message>
        <source>No answer from {subject}.</source>
        <translation>Keine Antwort von {subject}.</translation>
    </message>
    <message>
        <source>No command enables a SyncManager that has PDOs</source>
        <translation>Kein Kommando schaltet einen SyncManager ein, der PDOs hat</translation>
    </message>
    <message>
        <source>No command enables a mailbox SyncManager</source>
        <translation>Kein Kommando schaltet einen Mailbox-SyncManager ein</translation>
    </message>
    <message>
        <source>No command requests a state on the way to OP</source>
        <translation>Kein Kommando fordert einen Zustand auf dem Weg nach OP an</translation>
    </message>
    <message>
        <source>No cyclic command carries what an FMMU maps in OP</source>
        <translation>Kein zyklisches Kommando trägt, was eine FMMU in OP abbildet</translation>
    </message>
    <message>
        <source>No external clock was found; look at the bridge device and at the network on its other side.</source>
        <translation>Keine externe Uhr gefunden; nach dem Brückengerät und dem Netz auf seiner anderen Seite sehen.</translation>
    </message>
    <message>
        <source>No master can send them in time</source>
        <translation>Kein Master kann sie rechtzeitig senden</translation>
    </message>
    <message>
        <source>No operation mode fits the ENI's clocks</source>
        <translation>Keine Betriebsart passt zu den Uhren der ENI</translation>
    </message>
    <message>
        <source>No operation mode of {type} has the AssignActivate {activation} of the ENI: DC is off.</source>
        <translation>Keine Betriebsart von {type} hat das AssignActivate {activation} der ENI: DC ist aus.</translation>
    </message>
    <message>
        <source>No permission to send raw frames</source>
        <translation>Keine Berechtigung für rohe Frames</translation>
    </message>
    <message>
        <source>No permission to send raw frames on {subject}.</source>
        <translation>Keine Berechtigung für rohe Frames auf {subject}.</translation>
    </message>
    <message>
        <source>No slave brings the time of an external clock</source>
        <translation>Kein Slave bringt die Zeit einer externen Uhr</translation>
    </message>
    <message>
        <source>No slave follows the reference clock ({clocks} with a system time behind it), so there is no deviation to watch.</source>
        <translation>Kein Slave folgt der Referenzuhr ({clocks} mit Systemzeit hinter ihr), also gibt es keine Abweichung zu überwachen.</translation>
    </message>
    <message>
        <source>No start time is written</source>
        <translation>Es wird keine Startzeit geschrieben</translation>
    </message>
    <message>
        <source>No wiring puts a slave in front of the one that it hangs on here.</source>
        <translation>Keine Verdrahtung stellt einen Slave vor den, an dem er hier hängt.</translation>
    </message>
    <message>
        <source>Nobody looks whether slaves are in sync</source>
        <translation>Niemand sieht nach, ob die Slaves synchron sind</translation>
    </message>
    <message>
        <source>Nobody watches the slaves' deviation</source>
        <translation>Niemand überwacht die Abweichung der Slaves</translation>
    </message>
    <message>
        <source>Noise on that cable, a bad plug or a bad shield: change the cable, keep it away from motor cables.</source>
        <translation>Störungen auf diesem Kabel, ein schlechter Stecker oder Schirm: Kabel tauschen, von Motorleitungen fernhalten.</translation>
    </message>
    <message>
        <source>Not read from {subject}: {detail}.</source>
        <translation>Nicht gelesen von {subject}: {detail}.</translation>
    </message>
    <message>
        <source>Nothing answers behind an open port</source>
        <translation>Hinter einem offenen Port antwortet nichts</translation>
    </message>
    <message>
        <source>Nothing comes back over a cable</source>
        <translation>Über ein Kabel kommt nichts zurück</translation>
    </message>
    <message>
        <source>Nothing is written, or the slave aborts for a wrong length (0x06070010)</source>
        <translation>Es wird nichts geschrieben, oder der Slave bricht wegen falscher Länge ab (0x06070010)</translation>
    </message>
    <message>
        <source>Nothing waits for the state requested</source>
        <translation>Nichts wartet auf den angeforderten Zustand</translation>
    </message>
    <message>
        <source>Nothing, unless the application uses them</source>
        <translation>Nichts, solange die Anwendung sie nicht benutzt</translation>
    </message>
    <message>
        <source>Nothing, unless the application uses them with another master</source>
        <translation>Nichts, solange die Anwendung sie nicht mit einem anderen Master benutzt</translation>
    </message>
    <message>
        <source>Nothing, unless the file has to carry the setting to another maker's master</source>
        <translation>Nichts, wenn nicht die Datei die Einstellung zum Master eines anderen Herstellers tragen soll</translation>
    </message>
    <message>
        <source>Nothing, unless your master needs it.</source>
        <translation>Nichts, wenn nicht Ihr Master es braucht.</translation>
    </message>
    <message>
        <source>Nothing: readers should go by BitStart and BitOffs</source>
        <translation>Nichts: Leser sollten nach BitStart und BitOffs gehen</translation>
    </message>
    <message>
        <source>Object 0x60C2 cannot express a cycle of {cycle}; the ESI's value is kept.</source>
        <translation>Objekt 0x60C2 kann einen Zyklus von {cycle} nicht ausdrücken; der Wert der ESI bleibt.</translation>
    </message>
    <message>
        <source>Old station addresses, FMMUs or SyncManagers answer beside the new ones until a slave is switched off</source>
        <translation>Alte Stationsadressen, FMMUs oder SyncManager antworten neben den neuen, bis ein Slave ausgeschaltet wird</translation>
    </message>
    <message>
        <source>One overwrites the other's data; a buffered SyncManager takes three times its length</source>
        <translation>Einer überschreibt die Daten des anderen; ein gepufferter SyncManager belegt das Dreifache seiner Länge</translation>
    </message>
    <message>
        <source>Only masters of the maker who signed the file take it</source>
        <translation>Nur Master des Herstellers, der die Datei signiert hat, nehmen sie an</translation>
    </message>
    <message>
        <source>Only one clock can lead; masters take the first or the last</source>
        <translation>Nur eine Uhr kann führen; Master nehmen die erste oder die letzte</translation>
    </message>
    <message>
        <source>The host&apos;s kernel held the processor</source>
        <translation>Der Kernel des Rechners hielt den Prozessor</translation>
    </message>
    <message>
        <source>Real-time priority does not interrupt a thread of the kernel where the kernel is not preemptible.</source>
        <translation>Echtzeitpriorität unterbricht einen Thread des Kernels nicht, wenn der Kernel nicht unterbrechbar ist.</translation>
    </message>
    <message>
        <source>Boot this kernel with preempt=full, or take one with PREEMPT_RT; or keep a processor for the master alone (isolcpus) and bind it to that.</source>
        <translation>Starten Sie diesen Kernel mit preempt=full oder nehmen Sie einen mit PREEMPT_RT; oder halten Sie einen Prozessor für den Master allein frei (isolcpus) und binden Sie ihn daran.</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}. Of the kernel&apos;s threads {thread} kept a processor longest, {slice} at a time.</source>
        <translation>Der Rechner stand {times} still, zuerst bei {since}: er sendete bis zu {longest} lang nichts, und {count:# Zyklus wurde|# Zyklen wurden} ausgelassen. Von {held}, die der Master zu spät kam, war er {waited} lang bereit. Von den Threads des Kernels behielt {thread} einen Prozessor am längsten, {slice} am Stück.</translation>
    </message>
    <message>
        <source>Another program with real-time priority held the host</source>
        <translation>Ein anderes Programm mit Echtzeitpriorität hielt den Rechner</translation>
    </message>
    <message>
        <source>It has at least the priority of the master, which waits for it.</source>
        <translation>Es hat mindestens die Priorität des Masters, und der wartet darauf.</translation>
    </message>
    <message>
        <source>Give it less priority than the master, or bind it to another processor.</source>
        <translation>Geben Sie ihm weniger Priorität als dem Master oder binden Sie es an einen anderen Prozessor.</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}. Of the programs with as much priority {thread} kept a processor longest, {slice} at a time.</source>
        <translation>Der Rechner stand {times} still, zuerst bei {since}: er sendete bis zu {longest} lang nichts, und {count:# Zyklus wurde|# Zyklen wurden} ausgelassen. Von {held}, die der Master zu spät kam, war er {waited} lang bereit. Von den Programmen mit gleicher oder höherer Priorität behielt {thread} einen Prozessor am längsten, {slice} am Stück.</translation>
    </message>
    <message>
        <source>Other threads held the host</source>
        <translation>Andere Threads hielten den Rechner auf</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Outputs come too late for SYNC0</source>
        <translation>Ausgänge kommen zu spät für SYNC0</translation>
    </message>
    <message>
        <source>PDO {pdo}</source>
        <translation>PDO {pdo}</translation>
    </message>
    <message>
        <source>PDO {pdo} excludes {other}, and both are assigned</source>
        <translation>PDO {pdo} schließt {other} aus, und beide sind zugeordnet</translation>
    </message>
    <message>
        <source>PDO {pdo} excludes {other}; only one of them can be assigned.</source>
        <translation>PDO {pdo} schließt {other} aus; nur eins davon kann zugeordnet werden.</translation>
    </message>
    <message>
        <source>PDO {pdo} is assigned twice.</source>
        <translation>PDO {pdo} ist doppelt zugeordnet.</translation>
    </message>
    <message>
        <source>PDO {pdo} is described more than once</source>
        <translation>PDO {pdo} ist mehr als einmal beschrieben</translation>
    </message>
    <message>
        <source>PDO {pdo} is mandatory and assigned to no SyncManager</source>
        <translation>PDO {pdo} ist Pflicht und keinem SyncManager zugeordnet</translation>
    </message>
    <message>
        <source>PDO {pdo} is mandatory and not assigned.</source>
        <translation>PDO {pdo} ist Pflicht und nicht zugeordnet.</translation>
    </message>
    <message>
        <source>PDO {pdo} must not lie in SyncManager {manager} (ESI ExcludedSm).</source>
        <translation>PDO {pdo} darf nicht in SyncManager {manager} liegen (ESI ExcludedSm).</translation>
    </message>
    <message>
        <source>PDO {pdo} says {said}, the SyncManagers' lists say {assigned}</source>
        <translation>PDO {pdo} sagt {said}, die Listen der SyncManager sagen {assigned}</translation>
    </message>
    <message>
        <source>PDO {pdo} takes {least} to {most:# sample|# samples} a cycle, not {factor}.</source>
        <translation>PDO {pdo} nimmt {least} bis {most:# Abtastung|# Abtastungen} je Zyklus, nicht {factor}.</translation>
    </message>
    <message>
        <source>PDOs that exclude each other are both assigned</source>
        <translation>PDOs, die einander ausschließen, sind beide zugeordnet</translation>
    </message>
    <message>
        <source>PLL error</source>
        <translation>PLL-Fehler</translation>
    </message>
    <message>
        <source>PREOP is requested while the EEPROM belongs to the master (0x0500 = 0)</source>
        <translation>PREOP wird angefordert, während das EEPROM dem Master gehört (0x0500 = 0)</translation>
    </message>
    <message>
        <source>PREOP is requested while the master has the EEPROM</source>
        <translation>PREOP wird angefordert, während der Master das EEPROM hat</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Place of a command's data in the image</source>
        <translation>Platz der Daten eines Kommandos im Abbild</translation>
    </message>
    <message>
        <source>Place {place} must have a module.</source>
        <translation>Platz {place} muss ein Modul haben.</translation>
    </message>
    <message>
        <source>Place {place}, {name}, must have a module.</source>
        <translation>Platz {place}, {name}, muss ein Modul haben.</translation>
    </message>
    <message>
        <source>Places of slaves' data in the image</source>
        <translation>Plätze der Daten von Slaves im Abbild</translation>
    </message>
    <message>
        <source>Plug a module in.</source>
        <translation>Ein Modul einstecken.</translation>
    </message>
    <message>
        <source>Port {port} of {slave} has a link, but frames do not pass it.</source>
        <translation>Port {port} von {slave} hat einen Link, aber Frames gehen nicht hindurch.</translation>
    </message>
    <message>
        <source>Port {port} of {slave} is open, but no slave answers behind it.</source>
        <translation>Port {port} von {slave} ist offen, aber dahinter antwortet kein Slave.</translation>
    </message>
    <message>
        <source>Possible reference clock</source>
        <translation>Mögliche Referenzuhr</translation>
    </message>
    <message>
        <source>Process data and mailbox states share logical addresses</source>
        <translation>Prozessdaten und Mailbox-Zustände teilen sich logische Adressen</translation>
    </message>
    <message>
        <source>Process data that no FMMU maps</source>
        <translation>Prozessdaten, die keine FMMU abbildet</translation>
    </message>
    <message>
        <source>Programs that look a slave or its variables up by name find the first one</source>
        <translation>Programme, die einen Slave oder seine Variablen nach Namen suchen, finden den ersten</translation>
    </message>
    <message>
        <source>Propagation delays were measured again</source>
        <translation>Die Laufzeiten wurden erneut gemessen</translation>
    </message>
    <message>
        <source>Pulses come one cycle later than meant, since the shift counts modulo the cycle</source>
        <translation>Pulse kommen einen Zyklus später als gemeint, da die Verschiebung modulo Zyklus zählt</translation>
    </message>
    <message>
        <source>Put the APWR of 0x0910 behind the ARMW</source>
        <translation>Das APWR von 0x0910 hinter das ARMW setzen</translation>
    </message>
    <message>
        <source>Put the vendor's ESI file into the ESI folder that you use and scan again.</source>
        <translation>Die ESI-Datei des Herstellers in den benutzten ESI-Ordner legen und neu suchen.</translation>
    </message>
    <message>
        <source>Put the vendor's ESI file into the ESI folder {detail} and scan again.</source>
        <translation>Die ESI-Datei des Herstellers in den ESI-Ordner {detail} legen und neu suchen.</translation>
    </message>
    <message>
        <source>Raise the timeout or check what the slave waits for.</source>
        <translation>Die Zeitgrenze erhöhen oder prüfen, worauf der Slave wartet.</translation>
    </message>
    <message>
        <source>Raise watchdog.process_data, or 0 switches it off.</source>
        <translation>watchdog.process_data erhöhen, oder mit 0 abschalten.</translation>
    </message>
    <message>
        <source>Readers disagree on other values: 1 is the download that all tools write</source>
        <translation>Bei anderen Werten sind sich Leser nicht einig: 1 ist der Download, den alle Werkzeuge schreiben</translation>
    </message>
    <message>
        <source>Readers refuse the file, or take the value for 0</source>
        <translation>Leser lehnen die Datei ab, oder nehmen den Wert als 0</translation>
    </message>
    <message>
        <source>Readers take the first or the last, and not all the same one</source>
        <translation>Leser nehmen das erste oder das letzte, und nicht alle dasselbe</translation>
    </message>
    <message>
        <source>Readers that go by Enable leave the data out, those that go by the commands do not</source>
        <translation>Leser, die nach Enable gehen, lassen die Daten weg, solche, die nach den Kommandos gehen, nicht</translation>
    </message>
    <message>
        <source>Readers use the one or the other and come to different process images</source>
        <translation>Leser benutzen das eine oder das andere und kommen zu verschiedenen Prozessabbildern</translation>
    </message>
    <message>
        <source>Reading EEPROMs takes them from their slaves for that time, and the DC receive times are latched.</source>
        <translation>EEPROMs werden zum Lesen so lange von ihren Slaves genommen, und die DC-Empfangszeiten werden festgehalten.</translation>
    </message>
    <message>
        <source>Recv has neither PollTime nor StatusBitAddr</source>
        <translation>Recv hat weder PollTime noch StatusBitAddr</translation>
    </message>
    <message>
        <source>Reference clock</source>
        <translation>Referenzuhr</translation>
    </message>
    <message>
        <source>Remove all but one</source>
        <translation>Alle bis auf eins entfernen</translation>
    </message>
    <message>
        <source>Remove one of the descriptions</source>
        <translation>Eine der Beschreibungen entfernen</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Eins davon entfernen.</translation>
    </message>
    <message>
        <source>Remove the BRD of 0x092C</source>
        <translation>Das BRD von 0x092C entfernen</translation>
    </message>
    <message>
        <source>Remove the command, or write a type that it supports</source>
        <translation>Das Kommando entfernen, oder eine Art schreiben, die es unterstützt</translation>
    </message>
    <message>
        <source>Remove what is set for it.</source>
        <translation>Entfernen, was dafür eingestellt ist.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Weggefallen</translation>
    </message>
    <message>
        <source>Request the state again and watch its AL status.</source>
        <translation>Den Zustand erneut anfordern und den AL-Status beobachten.</translation>
    </message>
    <message>
        <source>Request the state again when the cause is removed.</source>
        <translation>Den Zustand erneut anfordern, wenn die Ursache behoben ist.</translation>
    </message>
    <message>
        <source>Requesting it writes AL control, which an untouched machine must not see.</source>
        <translation>Sie anzufordern schreibt in AL Control, was eine unberührte Maschine nicht sehen soll.</translation>
    </message>
    <message>
        <source>Requests and answers overwrite each other</source>
        <translation>Anfragen und Antworten überschreiben einander</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Revision</translation>
    </message>
    <message>
        <source>SDO protocol timeout</source>
        <translation>Zeitgrenze des SDO-Protokolls</translation>
    </message>
    <message>
        <source>SII does not match the firmware</source>
        <translation>SII passt nicht zur Firmware</translation>
    </message>
    <message>
        <source>SM0 and SM1 against SII words 0x14 to 0x17</source>
        <translation>SM0 und SM1 gegen die SII-Wörter 0x14 bis 0x17</translation>
    </message>
    <message>
        <source>SM2 events were missed because frames came too late</source>
        <translation>SM2-Ereignisse fehlten, weil Frames zu spät kamen</translation>
    </message>
    <message>
        <source>SM2 events were missed because frames were lost</source>
        <translation>SM2-Ereignisse fehlten, weil Frames verloren gingen</translation>
    </message>
    <message>
        <source>A frame that was held up brought the reference clock an old time</source>
        <translation>Ein aufgehaltener Frame brachte der Referenzuhr eine alte Zeit</translation>
    </message>
    <message>
        <source>Look for what holds frames up behind the master: the network card, its driver, a switch, a busy host. In master shift nothing is written to the reference clock, and such a frame moves nobody.</source>
        <translation>Suchen, was Frames hinter dem Master aufhält: Netzwerkkarte, Treiber, Switch, ein ausgelasteter Rechner. Bei Master Shift wird nichts in die Referenzuhr geschrieben, und ein solcher Frame verschiebt niemanden.</translation>
    </message>
    <message>
        <source>A frame that was held up on its way brought the reference clock an old time at {since}: the slaves were up to {deviation} off it until they had followed.</source>
        <translation>Ein unterwegs aufgehaltener Frame brachte der Referenzuhr bei {since} eine alte Zeit: die Slaves lagen bis zu {deviation} daneben, bis sie gefolgt waren.</translation>
    </message>
    <message>
        <source>A frame that was held up on its way brought the reference clock an old time at {since}: the slaves followed, and the master found back to it.</source>
        <translation>Ein unterwegs aufgehaltener Frame brachte der Referenzuhr bei {since} eine alte Zeit: die Slaves folgten, und der Master fand zu ihr zurück.</translation>
    </message>
    <message>
        <source>Outputs came too late because frames were held up on their way</source>
        <translation>Ausgänge kamen zu spät, weil Frames unterwegs aufgehalten wurden</translation>
    </message>
    <message>
        <source>They were sent in time, and nothing was lost.</source>
        <translation>Sie wurden rechtzeitig gesendet, und verloren ging nichts.</translation>
    </message>
    <message>
        <source>Look for what holds frames up behind the master: the network card, its driver, a switch; its SYNC0 is not the reason.</source>
        <translation>Suchen, was Frames hinter dem Master aufhält: Netzwerkkarte, Treiber, Switch; sein SYNC0 ist nicht der Grund.</translation>
    </message>
    <message>
        <source>SM2 events were missed because the host left cycles out</source>
        <translation>SM2-Ereignisse fehlten, weil der Host Zyklen ausließ</translation>
    </message>
    <message>
        <source>SM2 events were missed in good cycles</source>
        <translation>SM2-Ereignisse fehlten in guten Zyklen</translation>
    </message>
    <message>
        <source>SM2 events were missed while the master was not locked</source>
        <translation>SM2-Ereignisse fehlten, während der Master nicht eingerastet war</translation>
    </message>
    <message>
        <source>SM{manager} carries PDO {pdo}, which the slave does not describe</source>
        <translation>SM{manager} trägt das PDO {pdo}, das der Slave nicht beschreibt</translation>
    </message>
    <message>
        <source>SM{manager} carries {bytes:# byte|# bytes} of process data that no FMMU maps</source>
        <translation>SM{manager} trägt {bytes:# Byte|# Bytes} Prozessdaten, die keine FMMU abbildet</translation>
    </message>
    <message>
        <source>SM{manager} has PDOs, and no init command on IP, PS or SO enables it</source>
        <translation>SM{manager} hat PDOs, und kein InitCmd auf IP, PS oder SO schaltet ihn ein</translation>
    </message>
    <message>
        <source>SM{manager} is on with {bytes:# byte|# bytes} at {start}</source>
        <translation>SM{manager} ist mit {bytes:# Byte|# Bytes} bei {start} eingeschaltet</translation>
    </message>
    <message>
        <source>SM{manager} is set to start at {start}, its element says {said}</source>
        <translation>SM{manager} wird auf den Anfang {start} gesetzt, sein Element sagt {said}</translation>
    </message>
    <message>
        <source>SM{manager} is set to {bytes:# byte|# bytes} at {start}, {element} says {said_bytes:# byte|# bytes} at {said_start}</source>
        <translation>SM{manager} wird auf {bytes:# Byte|# Bytes} bei {start} gesetzt, {element} sagt {said_bytes:# Byte|# Bytes} bei {said_start}</translation>
    </message>
    <message>
        <source>SM{manager} is set to {bytes:# byte|# bytes}, its PDOs have {expected}</source>
        <translation>SM{manager} wird auf {bytes:# Byte|# Bytes} gesetzt, seine PDOs haben {expected}</translation>
    </message>
    <message>
        <source>SM{manager} shares memory with SM{other}</source>
        <translation>SM{manager} teilt sich Speicher mit SM{other}</translation>
    </message>
    <message>
        <source>SM{manager} shares memory with SM{other}, whose three buffers reach that far</source>
        <translation>SM{manager} teilt sich Speicher mit SM{other}, dessen drei Puffer so weit reichen</translation>
    </message>
    <message>
        <source>SM{sm}</source>
        <translation>SM{sm}</translation>
    </message>
    <message>
        <source>SM{sm} PDOs</source>
        <translation>SM{sm} PDOs</translation>
    </message>
    <message>
        <source>SM{sm} control byte</source>
        <translation>SM{sm} Steuerbyte</translation>
    </message>
    <message>
        <source>SM{sm} enabled</source>
        <translation>SM{sm} eingeschaltet</translation>
    </message>
    <message>
        <source>SM{sm} only in OP</source>
        <translation>SM{sm} nur in OP</translation>
    </message>
    <message>
        <source>SM{sm} sizes</source>
        <translation>SM{sm} Größen</translation>
    </message>
    <message>
        <source>SM{sm} start</source>
        <translation>SM{sm} Anfang</translation>
    </message>
    <message>
        <source>SM{sm} type</source>
        <translation>SM{sm} Typ</translation>
    </message>
    <message>
        <source>SM{sm} watchdog</source>
        <translation>SM{sm} Watchdog</translation>
    </message>
    <message>
        <source>SYNC signals and cyclic frames; several sync errors came together</source>
        <translation>SYNC-Signale und zyklische Frames; mehrere Synchronisationsfehler kamen zusammen</translation>
    </message>
    <message>
        <source>SYNC signals go on when the slave has left OP, and the next start finds a running unit</source>
        <translation>SYNC-Signale laufen weiter, wenn der Slave OP verlassen hat, und der nächste Start findet eine laufende Einheit</translation>
    </message>
    <message>
        <source>SYNC0 and frames do not keep step</source>
        <translation>SYNC0 und Frames halten nicht Schritt</translation>
    </message>
    <message>
        <source>SYNC0 comes before the frames</source>
        <translation>SYNC0 kommt vor den Frames</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {family} {devices} need multiples of {step}; {otherwise}. Next to it: {nearest}.</source>
        <translation>SYNC0 kommt alle {cycle}: {family} {devices} brauchen Vielfache von {step}; {otherwise}. Am nächsten: {nearest}.</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {family} {devices} take multiples of {step}. Next to it: {nearest}.</source>
        <translation>SYNC0 kommt alle {cycle}: {family} {devices} nehmen Vielfache von {step}. Am nächsten: {nearest}.</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {limit} is the longest cycle that {family} {devices} take. Next to it: {nearest}.</source>
        <translation>SYNC0 kommt alle {cycle}: {limit} ist der längste Zyklus, den {family} {devices} annehmen. Am nächsten: {nearest}.</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {limit} is the shortest cycle that {family} {devices} take. Next to it: {nearest}.</source>
        <translation>SYNC0 kommt alle {cycle}: {limit} ist der kürzeste Zyklus, den {family} {devices} annehmen. Am nächsten: {nearest}.</translation>
    </message>
    <message>
        <source>SYNC0 comes, and the slave works without it</source>
        <translation>SYNC0 kommt, und der Slave arbeitet ohne es</translation>
    </message>
    <message>
        <source>SYNC0 cycle</source>
        <translation>SYNC0-Zyklus</translation>
    </message>
    <message>
        <source>SYNC0 does not come with the frames</source>
        <translation>SYNC0 kommt nicht mit den Frames</translation>
    </message>
    <message>
        <source>SYNC0 every {sync0} and a frame every {cycle}: neither is a multiple of the other.</source>
        <translation>SYNC0 alle {sync0} und ein Frame alle {cycle}: keins ist ein Vielfaches des anderen.</translation>
    </message>
    <message>
        <source>SYNC0 is never switched off</source>
        <translation>SYNC0 wird nie ausgeschaltet</translation>
    </message>
    <message>
        <source>SYNC0 is on, and {object}:01 = {type} does not use it: {consequence}. Set it to 2.</source>
        <translation>SYNC0 ist an, und {object}:01 = {type} benutzt es nicht: {consequence}. Es auf 2 setzen.</translation>
    </message>
    <message>
        <source>SYNC0 is started behind the request for SAFEOP</source>
        <translation>SYNC0 wird hinter der Anforderung von SAFEOP gestartet</translation>
    </message>
    <message>
        <source>SYNC0 is switched on (0x0980) before its cycle time is set (0x09A0)</source>
        <translation>SYNC0 wird eingeschaltet (0x0980), bevor seine Zykluszeit gesetzt ist (0x09A0)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on (0x0980) before its start time is set (0x0990)</source>
        <translation>SYNC0 wird eingeschaltet (0x0980), bevor seine Startzeit gesetzt ist (0x0990)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on before its times are set</source>
        <translation>SYNC0 wird eingeschaltet, bevor seine Zeiten gesetzt sind</translation>
    </message>
    <message>
        <source>SYNC0 is switched on with a cycle time of 0</source>
        <translation>SYNC0 wird mit einer Zykluszeit von 0 eingeschaltet</translation>
    </message>
    <message>
        <source>SYNC0 is switched on without a cycle</source>
        <translation>SYNC0 wird ohne Zyklus eingeschaltet</translation>
    </message>
    <message>
        <source>SYNC0 is switched on without a cycle time</source>
        <translation>SYNC0 wird ohne Zykluszeit eingeschaltet</translation>
    </message>
    <message>
        <source>SYNC0 is switched on, and nothing writes its cycle time (0x09A0)</source>
        <translation>SYNC0 wird eingeschaltet, und nichts schreibt seine Zykluszeit (0x09A0)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on, and nothing writes its start time (0x0990)</source>
        <translation>SYNC0 wird eingeschaltet, und nichts schreibt seine Startzeit (0x0990)</translation>
    </message>
    <message>
        <source>SYNC0 shift</source>
        <translation>SYNC0-Verschiebung</translation>
    </message>
    <message>
        <source>SYNC1 behind SYNC0</source>
        <translation>SYNC1 nach SYNC0</translation>
    </message>
    <message>
        <source>SYNC1 cannot come before SYNC0</source>
        <translation>SYNC1 kann nicht vor SYNC0 kommen</translation>
    </message>
    <message>
        <source>SYNC1 is derived from SYNC0 and never comes</source>
        <translation>SYNC1 wird von SYNC0 abgeleitet und kommt nie</translation>
    </message>
    <message>
        <source>SYNC1 is switched on without SYNC0</source>
        <translation>SYNC1 wird ohne SYNC0 eingeschaltet</translation>
    </message>
    <message>
        <source>SYNC1 would come {time} before SYNC0; register 0x09A4 holds only a delay after it.</source>
        <translation>SYNC1 käme {time} vor SYNC0; Register 0x09A4 fasst nur eine Verzögerung danach.</translation>
    </message>
    <message>
        <source>Say which slave and port it hangs on.</source>
        <translation>Angeben, an welchem Slave und Port er hängt.</translation>
    </message>
    <message>
        <source>Scan again or exchange the device.</source>
        <translation>Neu suchen oder das Gerät tauschen.</translation>
    </message>
    <message>
        <source>Scan again or take it off the bus.</source>
        <translation>Neu suchen oder es vom Bus nehmen.</translation>
    </message>
    <message>
        <source>See in the device's manual whether it has one.</source>
        <translation>Im Handbuch des Geräts nachsehen, ob es eine hat.</translation>
    </message>
    <message>
        <source>See that at it and its neighbours the cable from the master is in IN (port A) and not in OUT.</source>
        <translation>Bei ihm und seinen Nachbarn dafür sorgen, dass das Kabel vom Master in IN (Port A) steckt und nicht in OUT.</translation>
    </message>
    <message>
        <source>See what else happened then: a clock that stepped, cycles left out, a reference clock that was lost.</source>
        <translation>Sehen, was dann noch geschah: eine gesprungene Uhr, ausgelassene Zyklen, eine verlorene Referenzuhr.</translation>
    </message>
    <message>
        <source>Send ({send}, {send_bytes:# byte|# bytes}) and Recv ({receive}, {receive_bytes:# byte|# bytes}) share memory</source>
        <translation>Send ({send}, {send_bytes:# Byte|# Bytes}) und Recv ({receive}, {receive_bytes:# Byte|# Bytes}) teilen sich Speicher</translation>
    </message>
    <message>
        <source>Send or Recv has another size than the assigned PDOs</source>
        <translation>Send oder Recv hat eine andere Größe als die zugeordneten PDOs</translation>
    </message>
    <message>
        <source>Send or Recv is not where the frames put the data</source>
        <translation>Send oder Recv liegt nicht dort, wohin die Frames die Daten legen</translation>
    </message>
    <message>
        <source>Import with an ESI that has the protocol.</source>
        <translation>Mit einer ESI importieren, die das Protokoll hat.</translation>
    </message>
    <message>
        <source>Sending or receiving failed</source>
        <translation>Senden oder Empfangen schlug fehl</translation>
    </message>
    <message>
        <source>Sending or receiving on {subject} failed{because}.</source>
        <translation>Senden oder Empfangen auf {subject} ist fehlgeschlagen{because}.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Set 0x0010 first, or address the slave by its position</source>
        <translation>Erst 0x0010 setzen, oder den Slave über seine Position ansprechen</translation>
    </message>
    <message>
        <source>Set 0x60C2 to the cycle in which set values come</source>
        <translation>0x60C2 auf den Zyklus setzen, in dem Sollwerte kommen</translation>
    </message>
    <message>
        <source>Set BitLength to the bits of the PDOs</source>
        <translation>BitLength auf die Bits der PDOs setzen</translation>
    </message>
    <message>
        <source>Set Cnt to 1, or 3 where it reads and writes</source>
        <translation>Cnt auf 1 setzen, oder auf 3, wo gelesen und geschrieben wird</translation>
    </message>
    <message>
        <source>Set Cnt to reading slaves, plus writing slaves (twice with LRW)</source>
        <translation>Cnt auf lesende Slaves plus schreibende Slaves setzen (doppelt bei LRW)</translation>
    </message>
    <message>
        <source>Set Cnt to the number of slaves</source>
        <translation>Cnt auf die Zahl der Slaves setzen</translation>
    </message>
    <message>
        <source>Set GroupMemberCnt to the number of slaves from the head of the group on</source>
        <translation>GroupMemberCnt auf die Zahl der Slaves ab dem Kopf der Gruppe setzen</translation>
    </message>
    <message>
        <source>Set SubIndex to 0, or CompleteAccess off</source>
        <translation>SubIndex auf 0 setzen oder CompleteAccess ausschalten</translation>
    </message>
    <message>
        <source>Set a cycle or a factor.</source>
        <translation>Einen Zyklus oder einen Faktor einstellen.</translation>
    </message>
    <message>
        <source>Set mode and direction in the control byte by the Type: outputs 0x64 or 0x24, inputs 0x20 or 0x00</source>
        <translation>Art und Richtung im Steuerbyte nach dem Type setzen: Ausgänge 0x64 oder 0x24, Eingänge 0x20 oder 0x00</translation>
    </message>
    <message>
        <source>Set the cycle in the master, or add CycleTime in microseconds</source>
        <translation>Den Zyklus im Master setzen, oder CycleTime in Mikrosekunden hinzufügen</translation>
    </message>
    <message>
        <source>Set the length to the bytes of the assigned PDOs</source>
        <translation>Die Länge auf die Bytes der zugeordneten PDOs setzen</translation>
    </message>
    <message>
        <source>Set the machine's cycle time.</source>
        <translation>Die Zykluszeit der Maschine einstellen.</translation>
    </message>
    <message>
        <source>Set the switches of one of them to another number.</source>
        <translation>Die Schalter des einen auf eine andere Zahl stellen.</translation>
    </message>
    <message>
        <source>ShiftTime is {shift}, the SYNC0 cycle {cycle}</source>
        <translation>ShiftTime ist {shift}, der SYNC0-Zyklus {cycle}</translation>
    </message>
    <message>
        <source>Size of the inputs</source>
        <translation>Größe der Eingänge</translation>
    </message>
    <message>
        <source>Size of the outputs</source>
        <translation>Größe der Ausgänge</translation>
    </message>
    <message>
        <source>Slave-to-slave copies cannot be kept</source>
        <translation>Kopien von Slave zu Slave lassen sich nicht behalten</translation>
    </message>
    <message>
        <source>Slaves are in sync</source>
        <translation>Die Slaves sind synchron</translation>
    </message>
    <message>
        <source>Slaves are out of sync</source>
        <translation>Slaves sind nicht synchron</translation>
    </message>
    <message>
        <source>Slaves do not answer it, and its working counter stays 0</source>
        <translation>Slaves antworten ihm nicht, und sein Working Counter bleibt 0</translation>
    </message>
    <message>
        <source>Slaves may need 100 ms and more, and the start fails now and then</source>
        <translation>Slaves brauchen womöglich 100 ms und mehr, und der Anlauf scheitert hin und wieder</translation>
    </message>
    <message>
        <source>Slaves use distributed clocks, and nothing distributes the time</source>
        <translation>Slaves benutzen verteilte Uhren, und nichts verteilt die Zeit</translation>
    </message>
    <message>
        <source>So the cause is in the slave: its application needed longer than the cycle, or than the time between its outputs and SYNC0. Give it a longer cycle or more time before SYNC0, or look for what slows its firmware.</source>
        <translation>Also liegt die Ursache im Slave: seine Anwendung brauchte länger als den Zyklus oder als die Zeit zwischen Ausgängen und SYNC0. Längeren Zyklus oder mehr Zeit vor SYNC0 geben, oder suchen, was seine Firmware aufhält.</translation>
    </message>
    <message>
        <source>Some slave did not take or give its process data in this cycle.</source>
        <translation>Ein Slave hat in diesem Zyklus seine Prozessdaten nicht genommen oder gegeben.</translation>
    </message>
    <message>
        <source>Something is not supported</source>
        <translation>Etwas wird nicht unterstützt</translation>
    </message>
    <message>
        <source>Something took too long</source>
        <translation>Etwas dauerte zu lange</translation>
    </message>
    <message>
        <source>Something was not read</source>
        <translation>Etwas wurde nicht gelesen</translation>
    </message>
    <message>
        <source>Source address</source>
        <translation>Quelladresse</translation>
    </message>
    <message>
        <source>Split into frames</source>
        <translation>Aufteilung in Frames</translation>
    </message>
    <message>
        <source>Start-up commands cannot be kept</source>
        <translation>Startkommandos lassen sich nicht behalten</translation>
    </message>
    <message>
        <source>Start-up commands come in another order</source>
        <translation>Die Startkommandos kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>Start-up commands of a protocol that the mailbox does not name</source>
        <translation>Startkommandos eines Protokolls, das die Mailbox nicht nennt</translation>
    </message>
    <message>
        <source>Start-up commands of {protocol} cannot be kept ({commands}): the device's ESI does not know this protocol.</source>
        <translation>Startkommandos für {protocol} lassen sich nicht übernehmen ({commands}): die ESI des Geräts kennt dieses Protokoll nicht.</translation>
    </message>
    <message>
        <source>Station address</source>
        <translation>Stationsadresse</translation>
    </message>
    <message>
        <source>Station address 0 is that of a slave without address.</source>
        <translation>Stationsadresse 0 ist die eines Slaves ohne Adresse.</translation>
    </message>
    <message>
        <source>Station address {address} is that of {name} too.</source>
        <translation>Stationsadresse {address} ist auch die von {name}.</translation>
    </message>
    <message>
        <source>Swap its cables IN and OUT, or correct PhysAddr of PreviousPort</source>
        <translation>Seine Kabel IN und OUT tauschen, oder PhysAddr von PreviousPort berichtigen</translation>
    </message>
    <message>
        <source>Swap its cables IN and OUT, or what hangs at its port A stands in front of it.</source>
        <translation>Seine Kabel IN und OUT tauschen; oder was an seinem Port A hängt, steht vor ihm.</translation>
    </message>
    <message>
        <source>Swap their cables, or their positions in the configuration.</source>
        <translation>Ihre Kabel tauschen, oder ihre Positionen in der Konfiguration.</translation>
    </message>
    <message>
        <source>Switch SYNC0 on, or start in a profile mode (0x6060)</source>
        <translation>SYNC0 einschalten, oder in einer Profil-Betriebsart beginnen (0x6060)</translation>
    </message>
    <message>
        <source>Switch distributed clocks on, or clear the operation modes.</source>
        <translation>Verteilte Uhren einschalten, oder die Betriebsarten leeren.</translation>
    </message>
    <message>
        <source>Switch sync-window monitoring on to prove that they are in sync.</source>
        <translation>Sync-Window-Überwachung einschalten, um zu beweisen, dass sie synchron sind.</translation>
    </message>
    <message>
        <source>Switch the monitoring off, or give more slaves an operation mode with DC.</source>
        <translation>Die Überwachung ausschalten, oder mehr Slaves eine Betriebsart mit DC geben.</translation>
    </message>
    <message>
        <source>Switch the slave off and on.</source>
        <translation>Den Slave aus- und einschalten.</translation>
    </message>
    <message>
        <source>Sync Unit "{unit}" is to run in task "{task}", which does not exist; it stays in the base task.</source>
        <translation>Sync Unit "{unit}" soll in der Task "{task}" laufen, die es nicht gibt; sie bleibt in der Basis-Task.</translation>
    </message>
    <message>
        <source>Sync window monitoring compares slaves with the reference clock; {slaves:# slave with DC leaves|# slaves with DC leave} nothing to compare.</source>
        <translation>Die Überwachung des Sync-Fensters vergleicht Slaves mit der Referenzuhr; {slaves:# Slave mit DC lässt|# Slaves mit DC lassen} nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>SyncManager watchdog</source>
        <translation>SyncManager-Watchdog</translation>
    </message>
    <message>
        <source>SyncManager {manager} needs at least {least:# byte|# bytes}, the PDOs have {bytes}.</source>
        <translation>SyncManager {manager} braucht mindestens {least:# Byte|# Bytes}, die PDOs haben {bytes}.</translation>
    </message>
    <message>
        <source>SyncManagers (0x0800)</source>
        <translation>die SyncManager (0x0800)</translation>
    </message>
    <message>
        <source>Take another ESI or revision of the device.</source>
        <translation>Eine andere ESI oder Revision des Geräts nehmen.</translation>
    </message>
    <message>
        <source>Take it out of the assignment, or use another PDO.</source>
        <translation>Es aus der Zuordnung nehmen, oder ein anderes PDO verwenden.</translation>
    </message>
    <message>
        <source>Take it out of the assignment.</source>
        <translation>Es aus der Zuordnung nehmen.</translation>
    </message>
    <message>
        <source>Take one of the modules out, or another revision of the ESI.</source>
        <translation>Eins der Module herausnehmen, oder eine andere Revision der ESI nehmen.</translation>
    </message>
    <message>
        <source>Take one of them out of the assignment</source>
        <translation>Eins davon aus der Zuordnung nehmen</translation>
    </message>
    <message>
        <source>Take one of them out of the assignment.</source>
        <translation>Eins davon aus der Zuordnung nehmen.</translation>
    </message>
    <message>
        <source>Take the module out.</source>
        <translation>Das Modul herausnehmen.</translation>
    </message>
    <message>
        <source>The CAN cycle of {can} ({object}) is no multiple of the bus cycle of {cycle}: the gateway refuses SAFEOP.</source>
        <translation>Der CAN-Zyklus von {can} ({object}) ist kein Vielfaches des Buszyklus von {cycle}: das Gateway lehnt SAFEOP ab.</translation>
    </message>
    <message>
        <source>The DC element and the commands contradict each other</source>
        <translation>Das Element DC und die Kommandos widersprechen einander</translation>
    </message>
    <message>
        <source>The EEPROM has another alias than the ESC</source>
        <translation>Das EEPROM hat einen anderen Alias als der ESC</translation>
    </message>
    <message>
        <source>The EEPROM is asked and not read, or read and not asked</source>
        <translation>Das EEPROM wird gefragt und nicht gelesen, oder gelesen und nicht gefragt</translation>
    </message>
    <message>
        <source>The EEPROM is read before it belongs to the master</source>
        <translation>Das EEPROM wird gelesen, bevor es dem Master gehört</translation>
    </message>
    <message>
        <source>The EEPROM of {slave} has the alias {written}, its ESC has {taken} until the next power-on.</source>
        <translation>Das EEPROM von {slave} hat den Alias {written}, sein ESC hat {taken} bis zum nächsten Einschalten.</translation>
    </message>
    <message>
        <source>The ENI has no cycle time</source>
        <translation>Die ENI hat keine Zykluszeit</translation>
    </message>
    <message>
        <source>The ENI has no cycle time; {cycle} is taken.</source>
        <translation>Die ENI hat keine Zykluszeit; {cycle} wird genommen.</translation>
    </message>
    <message>
        <source>The ESC did not take its configuration from it.</source>
        <translation>Der ESC hat seine Konfiguration nicht daraus genommen.</translation>
    </message>
    <message>
        <source>The ESC refuses the access: the working counter stays too low</source>
        <translation>Der ESC lehnt den Zugriff ab: der Working Counter bleibt zu klein</translation>
    </message>
    <message>
        <source>The ESC refuses the read while the slave's controller has the EEPROM</source>
        <translation>Der ESC lehnt das Lesen ab, solange der Controller des Slaves das EEPROM hat</translation>
    </message>
    <message>
        <source>The ESC takes the time over only when all its bytes are accessed</source>
        <translation>Der ESC übernimmt die Zeit nur, wenn alle ihre Bytes zugegriffen werden</translation>
    </message>
    <message>
        <source>The ESI does not fit what the ENI uses</source>
        <translation>Die ESI passt nicht zu dem, was die ENI benutzt</translation>
    </message>
    <message>
        <source>The ESI does not say that the device has an explicit device ID; it is asked by the request bit of AL control all the same.</source>
        <translation>Die ESI sagt nicht, dass das Gerät eine explizite Geräte-ID hat; es wird trotzdem mit dem Anforderungsbit von AL Control gefragt.</translation>
    </message>
    <message>
        <source>The ESI gives the mailbox no usable size.</source>
        <translation>Die ESI gibt der Mailbox keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The ESI has no operation mode "{mode}".</source>
        <translation>Die ESI hat keine Betriebsart "{mode}".</translation>
    </message>
    <message>
        <source>The ESI has no such operation mode</source>
        <translation>Die ESI hat keine solche Betriebsart</translation>
    </message>
    <message>
        <source>The ESI knows of no explicit device ID</source>
        <translation>Die ESI kennt keine explizite Geräte-ID</translation>
    </message>
    <message>
        <source>The ESI names mailbox protocols, but no pair of mailbox SyncManagers.</source>
        <translation>Die ESI nennt Mailbox-Protokolle, aber kein Paar von Mailbox-SyncManagern.</translation>
    </message>
    <message>
        <source>The ESI's {type} was not taken, {reason}: the device is described by what the ENI uses of it.</source>
        <translation>{type} der ESI wurde nicht genommen, {reason}: das Gerät wird durch das beschrieben, was die ENI von ihm benutzt.</translation>
    </message>
    <message>
        <source>The NOP to 0x0900 is missing before the drift compensation</source>
        <translation>Vor dem Driftausgleich fehlt das NOP auf 0x0900</translation>
    </message>
    <message>
        <source>The PDO assignment of the device cannot be changed</source>
        <translation>Die PDO-Zuordnung des Geräts lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>The PDO assignment written is another than the SyncManager lists</source>
        <translation>Die geschriebene PDO-Zuordnung ist eine andere als die Liste des SyncManagers</translation>
    </message>
    <message>
        <source>The PDOs do not fit between MinSize and MaxSize</source>
        <translation>Die PDOs passen nicht zwischen MinSize und MaxSize</translation>
    </message>
    <message>
        <source>The SII (EEPROM) of {subject} cannot be used{because}.</source>
        <translation>Das SII (EEPROM) von {subject} ist nicht verwendbar{because}.</translation>
    </message>
    <message>
        <source>The SYNC cycle is no whole number of nanoseconds</source>
        <translation>Der SYNC-Zyklus ist keine ganze Zahl von Nanosekunden</translation>
    </message>
    <message>
        <source>The SYNC0 cycle does not fit the cycle of the frames</source>
        <translation>Der SYNC0-Zyklus passt nicht zum Zyklus der Frames</translation>
    </message>
    <message>
        <source>The answer to an init command is not what it demands</source>
        <translation>Die Antwort auf ein Init-Kommando ist nicht die verlangte</translation>
    </message>
    <message>
        <source>The application reads or writes memory that is not there</source>
        <translation>Die Anwendung liest oder schreibt Speicher, den es nicht gibt</translation>
    </message>
    <message>
        <source>The application reads the data of another slave</source>
        <translation>Die Anwendung liest die Daten eines anderen Slaves</translation>
    </message>
    <message>
        <source>The application reads too many bits or too few</source>
        <translation>Die Anwendung liest zu viele oder zu wenige Bits</translation>
    </message>
    <message>
        <source>The auto-increment address is not that of the slave's place</source>
        <translation>Die Auto-Increment-Adresse ist nicht die des Platzes des Slaves</translation>
    </message>
    <message>
        <source>The bring-up begins again</source>
        <translation>Der Hochlauf beginnt noch einmal</translation>
    </message>
    <message>
        <source>The bus cycle is not divisible by the factor; the SYNC cycle is cut to whole nanoseconds and drifts against the frame.</source>
        <translation>Der Buszyklus ist nicht durch den Faktor teilbar; der SYNC-Zyklus wird auf ganze Nanosekunden gekürzt und läuft dem Frame davon.</translation>
    </message>
    <message>
        <source>The bus has another number of slaves</source>
        <translation>Der Bus hat eine andere Zahl von Slaves</translation>
    </message>
    <message>
        <source>The bus has {received:# slave|# slaves} where {expected} {expected:was|were} expected.</source>
        <translation>Der Bus hat {received:# Slave|# Slaves} statt {expected}.</translation>
    </message>
    <message>
        <source>The bus shift has no effect, or disturbs a clock that follows another</source>
        <translation>Der Bus-Shift wirkt nicht oder stört eine Uhr, die einer anderen folgt</translation>
    </message>
    <message>
        <source>The catalogue has the device in another revision</source>
        <translation>Der Katalog hat das Gerät in einer anderen Revision</translation>
    </message>
    <message>
        <source>The cause of {part} of the missed events: {cause}.</source>
        <translation>Die Ursache von {part} der fehlenden Ereignisse: {cause}.</translation>
    </message>
    <message>
        <source>The checksum of the configuration area in the EEPROM of {slave} is wrong.</source>
        <translation>Die Prüfsumme des Konfigurationsbereichs im EEPROM von {slave} ist falsch.</translation>
    </message>
    <message>
        <source>The clocks drift too fast</source>
        <translation>Die Uhren laufen zu schnell auseinander</translation>
    </message>
    <message>
        <source>The command fails though the slave has answered</source>
        <translation>Das Kommando scheitert, obwohl der Slave geantwortet hat</translation>
    </message>
    <message>
        <source>The command reaches nobody, and the transition fails</source>
        <translation>Das Kommando erreicht niemanden, und der Übergang scheitert</translation>
    </message>
    <message>
        <source>The configuration does not hold what this mode needs.</source>
        <translation>Die Konfiguration enthält nicht, was diese Betriebsart braucht.</translation>
    </message>
    <message>
        <source>The configuration of {subject} does not work out{because}.</source>
        <translation>Die Konfiguration von {subject} geht nicht auf{because}.</translation>
    </message>
    <message>
        <source>The control byte contradicts the type of the SyncManager</source>
        <translation>Das Steuerbyte widerspricht der Art des SyncManagers</translation>
    </message>
    <message>
        <source>The control byte does not make a mailbox of SyncManager 0 or 1</source>
        <translation>Das Steuerbyte macht aus SyncManager 0 oder 1 keine Mailbox</translation>
    </message>
    <message>
        <source>The control error left its limit; look at the host's jitter, lost frames and the reference clock.</source>
        <translation>Der Regelfehler verließ seine Grenze; nach Jitter des Hosts, verlorenen Frames und der Referenzuhr sehen.</translation>
    </message>
    <message>
        <source>The cycle is shorter than the device says it can</source>
        <translation>Der Zyklus ist kürzer, als das Gerät zu können angibt</translation>
    </message>
    <message>
        <source>The cycle of a task is no multiple of the first one's</source>
        <translation>Der Zyklus einer Task ist kein Vielfaches von dem der ersten</translation>
    </message>
    <message>
        <source>The cycle of a task is no multiple of the first task's</source>
        <translation>Der Zyklus einer Task ist kein Vielfaches des Zyklus der ersten Task</translation>
    </message>
    <message>
        <source>The cycle of task {task}, {cycle}, is no multiple of {first}: its slaves were put into the base task.</source>
        <translation>Der Zyklus von Task {task}, {cycle}, ist kein Vielfaches von {first}: ihre Slaves kamen in die Basis-Task.</translation>
    </message>
    <message>
        <source>The cycle of {cycle} is too short: until its frames are back it takes {needed}, {wire} on the wire and {travel} on their way through {slaves:# slave|# slaves}. {late:# frame|# frames} came back too late.</source>
        <translation>Der Zyklus von {cycle} ist zu kurz: bis seine Frames zurück sind, vergehen {needed}, {wire} auf der Leitung und {travel} auf dem Weg durch {slaves:# Slave|# Slaves}. {late:# Frame kam|# Frames kamen} zu spät zurück.</translation>
    </message>
    <message>
        <source>The cycle time is no whole number of microseconds</source>
        <translation>Die Zykluszeit ist keine ganze Zahl von Mikrosekunden</translation>
    </message>
    <message>
        <source>The cycle time written is another than the DC element says</source>
        <translation>Die geschriebene Zykluszeit ist eine andere als die des Elements DC</translation>
    </message>
    <message>
        <source>The cycles do not come with the configured cycle time.</source>
        <translation>Die Zyklen kommen nicht mit der eingestellten Zykluszeit.</translation>
    </message>
    <message>
        <source>The cyclic frames need about {needed} of a cycle of {cycle}: {wire} on the wire and {travel} on their way through {slaves:# slave|# slaves}.</source>
        <translation>Die zyklischen Frames brauchen etwa {needed} eines Zyklus von {cycle}: {wire} auf der Leitung und {travel} auf dem Weg durch {slaves:# Slave|# Slaves}.</translation>
    </message>
    <message>
        <source>The cyclic frames take {wire} of wire time, the cycle is {cycle}.</source>
        <translation>Die zyklischen Frames brauchen {wire} Leitungszeit, der Zyklus ist {cycle}.</translation>
    </message>
    <message>
        <source>The cyclic frames take {wire} of {cycle} of wire time; mailbox traffic has little room.</source>
        <translation>Die zyklischen Frames belegen {wire} von {cycle} Leitungszeit; für die Mailbox bleibt wenig Platz.</translation>
    </message>
    <message>
        <source>The cyclic thread runs on another processor than it is bound to.</source>
        <translation>Der zyklische Thread läuft auf einem anderen Prozessor als dem, an den er gebunden ist.</translation>
    </message>
    <message>
        <source>The data are not consistent, and the slave never sees them</source>
        <translation>Die Daten sind nicht konsistent, und der Slave sieht sie nie</translation>
    </message>
    <message>
        <source>The data of one overwrite those of the other</source>
        <translation>Die Daten des einen überschreiben die des anderen</translation>
    </message>
    <message>
        <source>The delay measurement stumbled</source>
        <translation>Die Laufzeitmessung stieß auf etwas</translation>
    </message>
    <message>
        <source>The device ID of {slave} was not requested, which would write AL control.</source>
        <translation>Die Gerätekennung von {slave} wurde nicht angefordert, das hätte in AL Control geschrieben.</translation>
    </message>
    <message>
        <source>The device cannot be told another PDO assignment than its ESI's default.</source>
        <translation>Dem Gerät lässt sich keine andere PDO-Zuordnung als die Vorgabe seiner ESI mitteilen.</translation>
    </message>
    <message>
        <source>The device catalogue cannot be used</source>
        <translation>Der Gerätekatalog kann nicht benutzt werden</translation>
    </message>
    <message>
        <source>The device catalogue {file} cannot be used{because}.</source>
        <translation>Der Gerätekatalog {file} kann nicht benutzt werden{because}.</translation>
    </message>
    <message>
        <source>The device does not take so many samples a cycle</source>
        <translation>Das Gerät nimmt nicht so viele Abtastungen je Zyklus</translation>
    </message>
    <message>
        <source>The device has no AoE; its AMS Net ID is not written.</source>
        <translation>Das Gerät hat kein AoE; seine AMS Net ID wird nicht geschrieben.</translation>
    </message>
    <message>
        <source>The device has no EoE; its addresses are not set.</source>
        <translation>Das Gerät hat kein EoE; seine Adressen werden nicht gesetzt.</translation>
    </message>
    <message>
        <source>The device has no PDO {pdo} in this direction.</source>
        <translation>Das Gerät hat in dieser Richtung kein PDO {pdo}.</translation>
    </message>
    <message>
        <source>The device has no PDO {pdo}.</source>
        <translation>Das Gerät hat kein PDO {pdo}.</translation>
    </message>
    <message>
        <source>The device {subject} is not known{because}.</source>
        <translation>Das Gerät {subject} ist nicht bekannt{because}.</translation>
    </message>
    <message>
        <source>The device's reaction to missed SM events is switched off</source>
        <translation>Die Reaktion des Geräts auf verpasste SM-Ereignisse ist abgeschaltet</translation>
    </message>
    <message>
        <source>The drive does not execute the mode, or moves badly</source>
        <translation>Der Antrieb führt die Betriebsart nicht aus oder bewegt sich schlecht</translation>
    </message>
    <message>
        <source>The error limit 0x10F1:02 is 0: the slave never stops for missed SM events, the application has to watch their counter.</source>
        <translation>Die Fehlergrenze 0x10F1:02 ist 0: der Slave hält wegen verpasster SM-Ereignisse nie an, die Anwendung muss auf ihren Zähler achten.</translation>
    </message>
    <message>
        <source>The error limit 0x10F1:02 is set to {limit}, {family} {devices} take 0 to {most} and refuse the download.</source>
        <translation>Die Fehlergrenze 0x10F1:02 wird auf {limit} gesetzt, {family} {devices} nehmen 0 bis {most} und lehnen den Download ab.</translation>
    </message>
    <message>
        <source>The file cannot be taken in</source>
        <translation>Die Datei lässt sich nicht aufnehmen</translation>
    </message>
    <message>
        <source>The file {file} cannot be read{because}.</source>
        <translation>Die Datei {file} kann nicht gelesen werden{because}.</translation>
    </message>
    <message>
        <source>The file {file} cannot be written{because}.</source>
        <translation>Die Datei {file} kann nicht geschrieben werden{because}.</translation>
    </message>
    <message>
        <source>The file {file} does not exist.</source>
        <translation>Die Datei {file} gibt es nicht.</translation>
    </message>
    <message>
        <source>The firmware of {slave} was silent at {since}: its PDI watchdog expired {count} (0x0443).</source>
        <translation>Die Firmware von {slave} schwieg bei {since}: ihr PDI-Watchdog lief {count} ab (0x0443).</translation>
    </message>
    <message>
        <source>The first frames of the new state find no data, and working counters are too low</source>
        <translation>Die ersten Frames des neuen Zustands finden keine Daten, und Working Counter sind zu klein</translation>
    </message>
    <message>
        <source>The first slave of a hot-connect group</source>
        <translation>Der erste Slave einer Hot-Connect-Gruppe</translation>
    </message>
    <message>
        <source>The first slave of the bus cannot be optional</source>
        <translation>Der erste Slave des Busses kann nicht wahlweise sein</translation>
    </message>
    <message>
        <source>The frame passes it before it carries the time of this cycle, so that it is given the last one, or 0, and stays off</source>
        <translation>Der Frame kommt an ihm vorbei, bevor er die Zeit dieses Zyklus trägt, so dass er die des letzten oder 0 bekommt und daneben bleibt</translation>
    </message>
    <message>
        <source>The frames and their way through the slaves take longer than the cycle</source>
        <translation>Die Frames und ihr Weg durch die Slaves brauchen länger als den Zyklus</translation>
    </message>
    <message>
        <source>The frames cannot steer the reference clock</source>
        <translation>Die Frames können die Referenzuhr nicht stellen</translation>
    </message>
    <message>
        <source>The frames do not fit into the cycle</source>
        <translation>Die Frames passen nicht in den Zyklus</translation>
    </message>
    <message>
        <source>The frames fill most of the cycle</source>
        <translation>Die Frames füllen den größten Teil des Zyklus</translation>
    </message>
    <message>
        <source>The frames reach {slave} nominally {margin} before its SYNC0, and one in a thousand is {lateness} late.</source>
        <translation>Die Frames erreichen {slave} nominell {margin} vor SYNC0, und einer von tausend kommt {lateness} zu spät.</translation>
    </message>
    <message>
        <source>The frames reach {slave} nominally {margin} before its SYNC0, and it needs {need} for its outputs (0x1C32:06); one in a thousand is {lateness} late.</source>
        <translation>Die Frames erreichen {slave} nominell {margin} vor SYNC0, und er braucht {need} für seine Ausgänge (0x1C32:06); einer von tausend kommt {lateness} zu spät.</translation>
    </message>
    <message>
        <source>The frames take longer on the wire than the cycle</source>
        <translation>Die Frames brauchen auf der Leitung länger als den Zyklus</translation>
    </message>
    <message>
        <source>The frames take over 80 % of the cycle</source>
        <translation>Die Frames belegen über 80 % des Zyklus</translation>
    </message>
    <message>
        <source>The gateway is told a bus cycle of {told} (0x1C32:02), frames come every {cycle}.</source>
        <translation>Dem Gateway wird ein Buszyklus von {told} gesagt (0x1C32:02), Frames kommen alle {cycle}.</translation>
    </message>
    <message>
        <source>The gateway refuses SAFEOP (AL status code 0x0026 or 0x0035)</source>
        <translation>Das Gateway lehnt SAFEOP ab (AL-Statuscode 0x0026 oder 0x0035)</translation>
    </message>
    <message>
        <source>The host left cycles out</source>
        <translation>Der Host ließ Zyklen aus</translation>
    </message>
    <message>
        <source>The host&apos;s jitter reaches the reference clock</source>
        <translation>Der Jitter des Rechners erreicht die Referenzuhr</translation>
    </message>
    <message>
        <source>In this mode of the master synchronisation the reference clock is told the host&apos;s time as it is, without a control loop in front of it.</source>
        <translation>In dieser Art der Mastersynchronisation wird der Referenzuhr die Zeit des Rechners mitgeteilt, wie sie ist, ohne einen Regelkreis davor.</translation>
    </message>
    <message>
        <source>Choose bus shift or master shift, which keep the host&apos;s jitter away from the clocks; else a host with a more exact timer, or a wider sync window.</source>
        <translation>Bus Shift oder Master Shift wählen, die den Jitter des Rechners von den Uhren fernhalten; sonst einen Rechner mit genauerem Zeitgeber oder ein weiteres Synchronfenster.</translation>
    </message>
    <message>
        <source>The reference clock is told the host&apos;s time as it is (master-ref-clock): each frame that leaves later or earlier than the host believes shakes it, and all slaves with it.</source>
        <translation>Der Referenzuhr wird die Zeit des Rechners mitgeteilt, wie sie ist (master-ref-clock): jedes Frame, das später oder früher abgeht, als der Rechner glaubt, erschüttert sie und mit ihr alle Slaves.</translation>
    </message>
    <message>
        <source>The reference clock is told the host&apos;s time as it is (master-ref-clock): each frame that leaves later or earlier than the host believes shakes it, and all slaves with it. Half of the frames left up to {p50} late, one in a hundred {p99} or more, one in a thousand {p999}, at most {largest}.</source>
        <translation>Der Referenzuhr wird die Zeit des Rechners mitgeteilt, wie sie ist (master-ref-clock): jedes Frame, das später oder früher abgeht, als der Rechner glaubt, erschüttert sie und mit ihr alle Slaves. Die Hälfte der Frames ging bis zu {p50} zu spät ab, eines von hundert {p99} oder mehr, eines von tausend {p999}, höchstens {largest}.</translation>
    </message>
    <message>
        <source>The host sends late</source>
        <translation>Der Host sendet zu spät</translation>
    </message>
    <message>
        <source>The host sends late: half of the frames by {p50}, one in a hundred by {p99}, one in a thousand by {p999}, at most {largest}; the frames may be {margin} late.</source>
        <translation>Der Rechner sendet spät: die Hälfte der Frames um {p50}, einer von hundert um {p99}, einer von tausend um {p999}, höchstens {largest}; um {margin} dürfen sie es sein.</translation>
    </message>
    <message>
        <source>The host stood still</source>
        <translation>Der Host stand still</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out.</source>
        <translation>Der Rechner stand {times} still, zuerst bei {since}: er sendete bis zu {longest} lang nichts, und {count:# Zyklus wurde|# Zyklen wurden} ausgelassen.</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}, and other threads had its processor.</source>
        <translation>Der Rechner stand {times} still, zuerst bei {since}: er sendete bis zu {longest} lang nichts, und {count:# Zyklus wurde|# Zyklen wurden} ausgelassen. Von {held}, die der Master zu spät kam, war er {waited} lang bereit, und andere Threads hatten seinen Prozessor.</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. The master came {held} too late, and other threads had its processor for {waited} of that only: it was stopped, or its timer came late.</source>
        <translation>Der Rechner stand {times} still, zuerst bei {since}: er sendete bis zu {longest} lang nichts, und {count:# Zyklus wurde|# Zyklen wurden} ausgelassen. Der Master kam {held} zu spät, und nur {waited} davon hatten andere Threads seinen Prozessor: er war angehalten, oder sein Zeitgeber kam zu spät.</translation>
    </message>
    <message>
        <source>The host's clock and the reference clock drift by {drift}; no controller balances more than 600 ppm.</source>
        <translation>Die Uhr des Rechners und die Referenzuhr laufen um {drift} auseinander; mehr als 600 ppm gleicht kein Regler aus.</translation>
    </message>
    <message>
        <source>The host's cycle has stopped.</source>
        <translation>Der Zyklus des Hosts steht.</translation>
    </message>
    <message>
        <source>Nothing woke the master in time</source>
        <translation>Nichts weckte den Master rechtzeitig</translation>
    </message>
    <message>
        <source>The host's timer cannot be adjusted as far as the controller demands.</source>
        <translation>Der Timer des Hosts lässt sich nicht so weit stellen, wie der Regler verlangt.</translation>
    </message>
    <message>
        <source>The identity of a slave is not checked</source>
        <translation>Die Identität eines Slaves wird nicht geprüft</translation>
    </message>
    <message>
        <source>The identity that a command expects is not the one of Info</source>
        <translation>Die Identität, die ein Kommando erwartet, ist nicht die von Info</translation>
    </message>
    <message>
        <source>The interpolation time cannot be the cycle</source>
        <translation>Die Interpolationszeit kann nicht der Zyklus sein</translation>
    </message>
    <message>
        <source>The interpolation time is not the cycle</source>
        <translation>Die Interpolationszeit ist nicht der Zyklus</translation>
    </message>
    <message>
        <source>The link cannot put its send time into the frames.</source>
        <translation>Der Link kann seine Sendezeit nicht in die Frames eintragen.</translation>
    </message>
    <message>
        <source>The link {subject} is down{because}.</source>
        <translation>Der Link {subject} ist nicht verbunden{because}.</translation>
    </message>
    <message>
        <source>The mailboxes of a slave share memory</source>
        <translation>Die Mailboxen eines Slaves teilen sich Speicher</translation>
    </message>
    <message>
        <source>The mapping of PDO {pdo} is fixed.</source>
        <translation>Das Mapping von PDO {pdo} ist fest.</translation>
    </message>
    <message>
        <source>The mapping of a PDO cannot be changed</source>
        <translation>Das Mapping eines PDOs lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>The mapping written is another than the PDO lists</source>
        <translation>Das geschriebene Mapping ist ein anderes als das des PDOs</translation>
    </message>
    <message>
        <source>The master cannot check the wiring, and takes every line for a wrong one or none</source>
        <translation>Der Master kann die Verdrahtung nicht prüfen und hält jede Linie für falsch oder keine</translation>
    </message>
    <message>
        <source>The master copies from or to memory that is not there</source>
        <translation>Der Master kopiert aus oder in Speicher, den es nicht gibt</translation>
    </message>
    <message>
        <source>The master copies too little or too much between image and slave</source>
        <translation>Der Master kopiert zu wenig oder zu viel zwischen Abbild und Slave</translation>
    </message>
    <message>
        <source>The master does not clear what an earlier run left</source>
        <translation>Der Master räumt nicht auf, was ein früherer Lauf hinterließ</translation>
    </message>
    <message>
        <source>The master does not notice when slaves fall out and uses old inputs</source>
        <translation>Der Master merkt nicht, wenn Slaves ausfallen, und benutzt alte Eingänge</translation>
    </message>
    <message>
        <source>The master has no command to put the start time into, and SYNC0 may start in the past, which is never</source>
        <translation>Der Master hat kein Kommando für die Startzeit, und SYNC0 soll womöglich in der Vergangenheit beginnen, also nie</translation>
    </message>
    <message>
        <source>The master has to ask for it apart, and learns of errors later</source>
        <translation>Der Master muss eigens danach fragen und erfährt von Fehlern später</translation>
    </message>
    <message>
        <source>The master has to guess how often to look for answers and emergencies</source>
        <translation>Der Master muss raten, wie oft er nach Antworten und Emergencies sehen soll</translation>
    </message>
    <message>
        <source>The master is in sync</source>
        <translation>Der Master ist synchron</translation>
    </message>
    <message>
        <source>The master is not in sync</source>
        <translation>Der Master ist nicht synchron</translation>
    </message>
    <message>
        <source>The master is not in sync with the reference clock (schedule error {error}){obstacle}.</source>
        <translation>Der Master ist nicht synchron mit der Referenzuhr (Fehler des Zeitplans {error}){obstacle}.</translation>
    </message>
    <message>
        <source>The master is out of sync</source>
        <translation>Der Master ist nicht synchron</translation>
    </message>
    <message>
        <source>The master looks into the wrong mailbox</source>
        <translation>Der Master sieht in die falsche Mailbox</translation>
    </message>
    <message>
        <source>The master never sees that the mailbox is full, and answers are lost</source>
        <translation>Der Master sieht nie, dass die Mailbox voll ist, und Antworten gehen verloren</translation>
    </message>
    <message>
        <source>The master or a slave is in another state</source>
        <translation>Der Master oder ein Slave ist in einem anderen Zustand</translation>
    </message>
    <message>
        <source>The master runs a configuration</source>
        <translation>Der Master führt eine Konfiguration aus</translation>
    </message>
    <message>
        <source>The master runs nothing</source>
        <translation>Der Master führt nichts aus</translation>
    </message>
    <message>
        <source>The master stopped by something that should not have happened</source>
        <translation>Der Master hielt an, weil etwas geschah, was nicht geschehen darf</translation>
    </message>
    <message>
        <source>The master synchronisation failed.</source>
        <translation>Die Master-Synchronisation ist gescheitert.</translation>
    </message>
    <message>
        <source>The master synchronisation gave up</source>
        <translation>Die Master-Synchronisation gab auf</translation>
    </message>
    <message>
        <source>The master synchronisation is not running; bring the bus to PREOP first.</source>
        <translation>Die Master-Synchronisation läuft nicht; den Bus erst nach PREOP bringen.</translation>
    </message>
    <message>
        <source>The master synchronisation reports an error</source>
        <translation>Die Master-Synchronisation meldet einen Fehler</translation>
    </message>
    <message>
        <source>The master synchronisation reports {code}: {meaning}</source>
        <translation>Die Master-Synchronisation meldet {code}: {meaning}</translation>
    </message>
    <message>
        <source>The master takes one group for the other</source>
        <translation>Der Master verwechselt die Gruppen</translation>
    </message>
    <message>
        <source>The master takes slaves of the fixed line for members, or misses some</source>
        <translation>Der Master hält Slaves der festen Linie für Mitglieder, oder vermisst einige</translation>
    </message>
    <message>
        <source>The master takes the answer of every cycle for a missing slave</source>
        <translation>Der Master hält die Antwort jedes Zyklus für einen fehlenden Slave</translation>
    </message>
    <message>
        <source>The master takes the data of every cycle for invalid</source>
        <translation>Der Master hält die Daten jedes Zyklus für ungültig</translation>
    </message>
    <message>
        <source>The master was out of sync for a while</source>
        <translation>Der Master war eine Weile nicht synchron</translation>
    </message>
    <message>
        <source>The master was out of sync with the reference clock {count}, first at {since}{obstacle}; it found back.</source>
        <translation>Der Master war {count} nicht synchron mit der Referenzuhr, zuerst bei {since}{obstacle}; er fand zurück.</translation>
    </message>
    <message>
        <source>The master writes its messages beside the mailbox, and the slave refuses PREOP</source>
        <translation>Der Master schreibt seine Nachrichten neben die Mailbox, und der Slave lehnt PREOP ab</translation>
    </message>
    <message>
        <source>The master's DCM error is beyond its limit</source>
        <translation>Der DCM-Fehler des Masters überschreitet seine Grenze</translation>
    </message>
    <message>
        <source>The network adapter is away</source>
        <translation>Der Netzwerkadapter ist weg</translation>
    </message>
    <message>
        <source>The network adapter is back</source>
        <translation>Die Netzwerkkarte ist wieder da</translation>
    </message>
    <message>
        <source>The network adapter was away for a while</source>
        <translation>Der Netzwerkadapter war eine Weile weg</translation>
    </message>
    <message>
        <source>The network adapter {adapter} is down, gone or without carrier since {since}.</source>
        <translation>Die Netzwerkkarte {adapter} ist seit {since} abgeschaltet, fort oder ohne Verbindung.</translation>
    </message>
    <message>
        <source>The network adapter {adapter} was down, gone or without carrier from {since} on, for {length} ({count} in all); the bus came back with it.</source>
        <translation>Die Netzwerkkarte {adapter} war ab {since} für {length} abgeschaltet, fort oder ohne Verbindung ({count} insgesamt); der Bus kam mit ihr zurück.</translation>
    </message>
    <message>
        <source>The next commands reach the slave before it is ready</source>
        <translation>Die nächsten Kommandos erreichen den Slave, bevor er bereit ist</translation>
    </message>
    <message>
        <source>The open ports do not explain a slave's place</source>
        <translation>Die offenen Ports erklären den Platz eines Slaves nicht</translation>
    </message>
    <message>
        <source>The open ports of the slaves before {slave} do not explain its place.</source>
        <translation>Die offenen Ports der Slaves vor {slave} erklären seinen Platz nicht.</translation>
    </message>
    <message>
        <source>The process data do not fit</source>
        <translation>Die Prozessdaten passen nicht</translation>
    </message>
    <message>
        <source>The process data lie over the mailbox states at 0x09000000.</source>
        <translation>Die Prozessdaten liegen über den Mailbox-Zuständen bei 0x09000000.</translation>
    </message>
    <message>
        <source>The process data need more FMMUs than the device has</source>
        <translation>Die Prozessdaten brauchen mehr FMMUs, als das Gerät hat</translation>
    </message>
    <message>
        <source>The process data need {fmmus:# FMMU|# FMMUs}, the device has {available}.</source>
        <translation>Die Prozessdaten brauchen {fmmus:# FMMU|# FMMUs}, das Gerät hat {available}.</translation>
    </message>
    <message>
        <source>The process data of a slave lie outside the image</source>
        <translation>Die Prozessdaten eines Slaves liegen außerhalb des Abbilds</translation>
    </message>
    <message>
        <source>The process data watchdog is shorter than two cycles</source>
        <translation>Der Prozessdaten-Watchdog ist kürzer als zwei Zyklen</translation>
    </message>
    <message>
        <source>The process data watchdog of {slave} expired {count} (0x0442), last at {last}.</source>
        <translation>Der Prozessdaten-Watchdog von {slave} lief {count} ab (0x0442), zuletzt bei {last}.</translation>
    </message>
    <message>
        <source>The process data watchdog runs out after {time}, outputs come every {cycle}: one lost frame stops the slave.</source>
        <translation>Der Prozessdaten-Watchdog läuft nach {time} ab, Ausgänge kommen alle {cycle}: ein verlorener Frame hält den Slave an.</translation>
    </message>
    <message>
        <source>The project cannot be compiled: {reason}</source>
        <translation>Das Projekt lässt sich nicht übersetzen: {reason}</translation>
    </message>
    <message>
        <source>The recovered project cannot be compiled</source>
        <translation>Das wiederhergestellte Projekt lässt sich nicht übersetzen</translation>
    </message>
    <message>
        <source>The reference clock does not answer</source>
        <translation>Die Referenzuhr antwortet nicht</translation>
    </message>
    <message>
        <source>The reference clock has no distributed clock</source>
        <translation>Die Referenzuhr hat keine verteilte Uhr</translation>
    </message>
    <message>
        <source>The reference clock is no slave of the bus</source>
        <translation>Die Referenzuhr ist kein Slave des Busses</translation>
    </message>
    <message>
        <source>The reference clock is steered before its time is read</source>
        <translation>Die Referenzuhr wird gestellt, bevor ihre Zeit gelesen ist</translation>
    </message>
    <message>
        <source>The reference clock is there</source>
        <translation>Die Referenzuhr ist da</translation>
    </message>
    <message>
        <source>The root element is not EtherCATConfig</source>
        <translation>Das Wurzelelement ist nicht EtherCATConfig</translation>
    </message>
    <message>
        <source>Save the file as UTF-8, and have its first line say so</source>
        <translation>Die Datei als UTF-8 speichern und das in ihrer ersten Zeile angeben</translation>
    </message>
    <message>
        <source>Names and comments come out as other letters, here or in the next program</source>
        <translation>Namen und Kommentare erscheinen mit anderen Buchstaben, hier oder im nächsten Programm</translation>
    </message>
    <message>
        <source>The text is not in the encoding that the file names</source>
        <translation>Der Text steht nicht in der Kodierung, die die Datei nennt</translation>
    </message>
    <message>
        <source>{count:# finding more is|# findings more are} not listed</source>
        <translation>{count:# weiterer Befund ist|# weitere Befunde sind} nicht aufgeführt</translation>
    </message>
    <message>
        <source>Mend what is listed, then check again</source>
        <translation>Das Aufgeführte berichtigen, dann noch einmal prüfen</translation>
    </message>
    <message>
        <source>What is wrong in each of thousands of elements is one mistake: the first 1,000 findings of a rule are listed, and 10,000 in all</source>
        <translation>Was in jedem von Tausenden Elementen falsch ist, ist ein einziger Fehler: Aufgeführt sind die ersten 1.000 Befunde einer Regel, und 10.000 insgesamt</translation>
    </message>
    <message>
        <source>There are more findings than are listed</source>
        <translation>Es gibt mehr Befunde, als aufgeführt sind</translation>
    </message>
    <message>
        <source>The second overwrites the data of the first; buffers change twice a cycle</source>
        <translation>Das zweite überschreibt die Daten des ersten; Puffer wechseln zweimal je Zyklus</translation>
    </message>
    <message>
        <source>The set value is too small: at SYNC0 the frame is still on its way; raise it above frame time plus propagation delay, below the cycle.</source>
        <translation>Der Sollwert ist zu klein: bei SYNC0 ist der Frame noch unterwegs; ihn über Framezeit plus Laufzeit heben, unter den Zyklus.</translation>
    </message>
    <message>
        <source>The shift is longer than the cycle</source>
        <translation>Die Verschiebung ist länger als der Zyklus</translation>
    </message>
    <message>
        <source>The signals start at once with old values</source>
        <translation>Die Signale beginnen sofort mit alten Werten</translation>
    </message>
    <message>
        <source>The size of the data and the variables in them are unknown</source>
        <translation>Die Größe der Daten und die Variablen darin sind unbekannt</translation>
    </message>
    <message>
        <source>The slave aborts it (0x06070010, 0x06070012 or 0x06070013) and the transition fails</source>
        <translation>Der Slave bricht ihn ab (0x06070010, 0x06070012 oder 0x06070013), und der Übergang scheitert</translation>
    </message>
    <message>
        <source>The slave cannot read its own settings and may refuse PREOP (AL status code 0x0051)</source>
        <translation>Der Slave kann seine eigenen Einstellungen nicht lesen und lehnt PREOP womöglich ab (AL-Statuscode 0x0051)</translation>
    </message>
    <message>
        <source>The slave checks it while it changes its state and refuses</source>
        <translation>Der Slave prüft ihn beim Zustandswechsel und lehnt ab</translation>
    </message>
    <message>
        <source>The slave comes to OP, and a part of it is not synchronised</source>
        <translation>Der Slave kommt nach OP, und ein Teil von ihm ist nicht synchronisiert</translation>
    </message>
    <message>
        <source>The slave exchanges other data than the master expects, or refuses SAFEOP (AL status code 0x001D or 0x001E)</source>
        <translation>Der Slave tauscht andere Daten aus, als der Master erwartet, oder lehnt SAFEOP ab (AL-Statuscode 0x001D oder 0x001E)</translation>
    </message>
    <message>
        <source>The slave farther down the line overwrites the data of the other</source>
        <translation>Der Slave weiter hinten in der Linie überschreibt die Daten des anderen</translation>
    </message>
    <message>
        <source>The slave gets one pulse and no more, and refuses SAFEOP or OP (AL status code 0x002D or 0x0035)</source>
        <translation>Der Slave bekommt einen einzigen Puls und lehnt SAFEOP oder OP ab (AL-Statuscode 0x002D oder 0x0035)</translation>
    </message>
    <message>
        <source>The slave goes elsewhere, or refuses the request (AL status code 0x0011)</source>
        <translation>Der Slave geht anderswohin oder lehnt die Anforderung ab (AL-Statuscode 0x0011)</translation>
    </message>
    <message>
        <source>The slave goes on with old outputs, however many are missed</source>
        <translation>Der Slave fährt mit alten Ausgängen fort, wie viele auch fehlen</translation>
    </message>
    <message>
        <source>The slave got no outputs for too long.</source>
        <translation>Der Slave bekam zu lange keine Ausgänge.</translation>
    </message>
    <message>
        <source>The slave may be busy or its mailbox is set up wrongly.</source>
        <translation>Der Slave ist beschäftigt oder seine Mailbox falsch eingerichtet.</translation>
    </message>
    <message>
        <source>The slave may refuse to go to SAFEOP without it</source>
        <translation>Der Slave geht ohne es womöglich nicht nach SAFEOP</translation>
    </message>
    <message>
        <source>The slave refuses PREOP with AL status code 0x0016</source>
        <translation>Der Slave lehnt PREOP mit AL-Statuscode 0x0016 ab</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x001D or 0x001E)</source>
        <translation>Der Slave lehnt SAFEOP ab (AL-Statuscode 0x001D oder 0x001E)</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x001D or 0x001E), as it has no process data</source>
        <translation>Der Slave lehnt SAFEOP ab (AL-Statuscode 0x001D oder 0x001E), da er keine Prozessdaten hat</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x0035, 0x0036 or 0x002E)</source>
        <translation>Der Slave lehnt SAFEOP ab (AL-Statuscode 0x0035, 0x0036 oder 0x002E)</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP with an invalid SyncManager configuration, or overwrites its memory</source>
        <translation>Der Slave lehnt SAFEOP wegen ungültiger SyncManager-Konfiguration ab oder überschreibt seinen Speicher</translation>
    </message>
    <message>
        <source>The slave refuses the SyncManager, or data flow in the wrong direction</source>
        <translation>Der Slave lehnt den SyncManager ab, oder Daten fließen in die falsche Richtung</translation>
    </message>
    <message>
        <source>The slave refuses the SyncManager, or data land where it does not look for them</source>
        <translation>Der Slave lehnt den SyncManager ab, oder Daten landen, wo er sie nicht sucht</translation>
    </message>
    <message>
        <source>The slave refuses the assignment (AL status code 0x0024 or 0x0025)</source>
        <translation>Der Slave lehnt die Zuordnung ab (AL-Statuscode 0x0024 oder 0x0025)</translation>
    </message>
    <message>
        <source>The slave refuses the assignment or the mapping</source>
        <translation>Der Slave lehnt die Zuordnung oder das Mapping ab</translation>
    </message>
    <message>
        <source>The slave refuses the download to 0x10F1:02, which ends the start-up</source>
        <translation>Der Slave lehnt den Download nach 0x10F1:02 ab, was den Anlauf beendet</translation>
    </message>
    <message>
        <source>The slave refuses the download to 0x1C32:01 or 0x1C33:01, or SAFEOP</source>
        <translation>Der Slave lehnt den Download nach 0x1C32:01 oder 0x1C33:01 ab, oder SAFEOP</translation>
    </message>
    <message>
        <source>The slave runs with the one, the master plans with the other</source>
        <translation>Der Slave läuft mit der einen, der Master plant mit der anderen</translation>
    </message>
    <message>
        <source>The slave stays where it is and the bus never reaches OP</source>
        <translation>Der Slave bleibt, wo er ist, und der Bus kommt nie nach OP</translation>
    </message>
    <message>
        <source>The slave that Info describes fails the check: the bus does not leave INIT</source>
        <translation>Der Slave, den Info beschreibt, besteht die Prüfung nicht: der Bus verlässt INIT nicht</translation>
    </message>
    <message>
        <source>The slave's data never move: outputs stay 0 and its watchdog expires, inputs stay old</source>
        <translation>Die Daten des Slaves bewegen sich nie: Ausgänge bleiben 0 und sein Watchdog läuft ab, Eingänge bleiben alt</translation>
    </message>
    <message>
        <source>The slave's firmware does not serve its ESC any more.</source>
        <translation>Die Firmware des Slaves bedient ihren ESC nicht mehr.</translation>
    </message>
    <message>
        <source>The slaves are not in sync</source>
        <translation>Die Slaves sind nicht synchron</translation>
    </message>
    <message>
        <source>The slaves are not in sync within {limit} since {since}.</source>
        <translation>Die Slaves sind seit {since} nicht innerhalb von {limit} synchron.</translation>
    </message>
    <message>
        <source>its SYNC0 was started at another place</source>
        <translation>sein SYNC0 wurde an anderer Stelle gestartet</translation>
    </message>
    <message>
        <source>What they carry is not known: a cycle without its frame is missing, or counts as one whose frame was lost.</source>
        <translation>Was sie enthalten, ist nicht bekannt: Ein Zyklus ohne seinen Frame fehlt oder zählt als einer, dessen Frame verloren ging.</translation>
    </message>
    <message>
        <source>Whoever has written or copied it did not come to its end.</source>
        <translation>Wer ihn geschrieben oder kopiert hat, kam nicht bis ans Ende.</translation>
    </message>
    <message>
        <source>a recording that is shown here</source>
        <translation>eine Aufzeichnung, die hier gezeigt wird</translation>
    </message>
    <message>
        <source>its cycle {cycle} does not come behind that of the line before</source>
        <translation>ihr Zyklus {cycle} folgt nicht auf den der Zeile davor</translation>
    </message>
    <message>
        <source>of {other} cells it has only {count}</source>
        <translation>von {other} Zellen hat sie nur {count}</translation>
    </message>
    <message>
        <source>it is {what}, which would be lost: choose another name</source>
        <translation>sie ist {what} und ginge verloren: einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>its own clock was out of its place</source>
        <translation>seine eigene Uhr war nicht an ihrem Platz</translation>
    </message>
    <message>
        <source>the frames' way behind {subject} has changed: {slaves:# slave there is|# slaves there are} at once off by {deviation}, with delays that were measured before</source>
        <translation>der Weg der Frames hinter {subject} hat sich geändert: {slaves:# Slave dort ist|# Slaves dort sind} auf einmal {deviation} daneben, mit vorher gemessenen Verzögerungen</translation>
    </message>
    <message>
        <source>its tables are not those of version {version}</source>
        <translation>ihre Tabellen sind nicht die der Version {version}</translation>
    </message>
    <message>
        <source>the frames' way behind {subject} has changed: {slaves:# slave that follows|all # slaves that follow} at once off by {deviation}, with a delay that was measured before</source>
        <translation>der Weg der Frames hinter {subject} hat sich geändert: {slaves:# folgender Slave|alle # folgenden Slaves} auf einmal {deviation} daneben, mit einer vorher gemessenen Verzögerung</translation>
    </message>
    <message>
        <source>the project that is open here</source>
        <translation>das Projekt, das hier offen ist</translation>
    </message>
    <message>
        <source>the recording that is being written</source>
        <translation>die Aufzeichnung, die gerade geschrieben wird</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} captured in part only and passed over.</source>
        <translation>{count:# Frame wurde|# Frames wurden} nur teilweise mitgeschnitten und übergangen.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and {slave} had its outputs all the same: they had passed it, and no slave counted an error at its ports.</source>
        <translation>{count:# Frame|# Frames} kamen nicht zurück (bis zu {most} dicht beieinander, zuerst bei {since}), und {slave} hatte seine Ausgänge trotzdem: sie waren bei ihm vorbei, und kein Slave zählte einen Fehler an seinen Ports.</translation>
    </message>
    <message>
        <source>{count:# row|# rows} of the table {table} {count:is|are} missing</source>
        <translation>{count:# Zeile|# Zeilen} der Tabelle {table} {count:fehlt|fehlen}</translation>
    </message>
    <message>
        <source>{count:# row|# rows} of the table {table} {count:is|are} missing: cycles {first} to {last} are a gap</source>
        <translation>{count:# Zeile|# Zeilen} der Tabelle {table} {count:fehlt|fehlen}: Die Zyklen {first} bis {last} sind eine Lücke</translation>
    </message>
    <message>
        <source>{file} is an ENI, which holds one alone: leave the network out</source>
        <translation>{file} ist eine ENI, die nur eines enthält: das Netzwerk weglassen</translation>
    </message>
    <message>
        <source>{slave} left the sync window at {since} ({deviation}, limit {limit}). No reading is outside any more, but not for the settle time yet.</source>
        <translation>{slave} hat das Sync-Fenster bei {since} verlassen ({deviation}, Grenze {limit}). Kein Messwert liegt mehr außerhalb, aber noch nicht für die Einschwingzeit.</translation>
    </message>
    <message>
        <source>Whether the slaves are in sync is not known</source>
        <translation>Ob die Slaves synchron sind, ist nicht bekannt</translation>
    </message>
    <message>
        <source>Mend first what keeps the readings away: a reference clock that is gone, frames that are lost, the adapter.</source>
        <translation>Zuerst beheben, was die Messwerte fernhält: eine fehlende Referenzuhr, verlorene Frames, den Adapter.</translation>
    </message>
    <message>
        <source>Nobody knows since {since} whether the slaves are in sync within {limit}: not all of their deviations can be read.</source>
        <translation>Seit {since} ist nicht bekannt, ob die Slaves innerhalb von {limit} synchron sind: Nicht alle ihre Abweichungen lassen sich lesen.</translation>
    </message>
    <message>
        <source>The slaves are not in sync: {slave} is {deviation} off its reference clock, the limit is {limit}.</source>
        <translation>Die Slaves sind nicht synchron: {slave} weicht um {deviation} von der Referenzuhr ab, die Grenze ist {limit}.</translation>
    </message>
    <message>
        <source>The slaves' deviation is not monitored.</source>
        <translation>Die Abweichung der Slaves wird nicht überwacht.</translation>
    </message>
    <message>
        <source>The start-time command carries another shift than the DC element</source>
        <translation>Das Startzeit-Kommando trägt eine andere Verschiebung als das Element DC</translation>
    </message>
    <message>
        <source>The state of the slaves is not read cyclically</source>
        <translation>Der Zustand der Slaves wird nicht zyklisch gelesen</translation>
    </message>
    <message>
        <source>The status bit of a mailbox is not wired up</source>
        <translation>Das Statusbit einer Mailbox ist nicht verdrahtet</translation>
    </message>
    <message>
        <source>The sync window has nothing to compare</source>
        <translation>Das Sync-Fenster hat nichts zu vergleichen</translation>
    </message>
    <message>
        <source>The sync window is monitored with fewer than two clocks</source>
        <translation>Das Sync-Fenster wird mit weniger als zwei Uhren überwacht</translation>
    </message>
    <message>
        <source>The time distributed is not that of the reference clock</source>
        <translation>Die verteilte Zeit ist nicht die der Referenzuhr</translation>
    </message>
    <message>
        <source>The time is distributed by FRMW</source>
        <translation>Die Zeit wird mit FRMW verteilt</translation>
    </message>
    <message>
        <source>The time is not distributed in all states from PREOP on</source>
        <translation>Die Zeit wird nicht in allen Zuständen ab PREOP verteilt</translation>
    </message>
    <message>
        <source>The time-out of a change of state is very short</source>
        <translation>Die Zeitgrenze eines Zustandswechsels ist sehr kurz</translation>
    </message>
    <message>
        <source>The transition ends in a time-out though the slave is right</source>
        <translation>Der Übergang endet mit Zeitüberschreitung, obwohl der Slave richtig ist</translation>
    </message>
    <message>
        <source>The value of {subject} cannot be used{because}.</source>
        <translation>Der Wert von {subject} ist nicht verwendbar{because}.</translation>
    </message>
    <message>
        <source>The way through the network card takes too long now and then: interrupt moderation, a switch, or a busy host.</source>
        <translation>Der Weg durch die Netzwerkkarte dauert hin und wieder zu lange: Interrupt-Moderation, ein Switch oder ein beschäftigter Rechner.</translation>
    </message>
    <message>
        <source>The wiring is unknown: propagation delays will be measured as if in a line.</source>
        <translation>Die Verdrahtung ist unbekannt: Laufzeiten werden wie in einer Linie gemessen.</translation>
    </message>
    <message>
        <source>The wiring of a slave is unknown</source>
        <translation>Die Verdrahtung eines Slaves ist unbekannt</translation>
    </message>
    <message>
        <source>The working counter of a broadcast does not fit the number of slaves</source>
        <translation>Der Working Counter eines Broadcasts passt nicht zur Zahl der Slaves</translation>
    </message>
    <message>
        <source>The working counter of a command to one slave is impossible</source>
        <translation>Der Working Counter eines Kommandos an einen Slave ist unmöglich</translation>
    </message>
    <message>
        <source>The working counter of a process-data command does not fit the FMMUs</source>
        <translation>Der Working Counter eines Prozessdatenkommandos passt nicht zu den FMMUs</translation>
    </message>
    <message>
        <source>The write that steers the reference clock does not reach it</source>
        <translation>Das Schreiben, das die Referenzuhr stellt, erreicht sie nicht</translation>
    </message>
    <message>
        <source>There is a device that is not in the configuration: {subject}{because}.</source>
        <translation>Am Bus ist ein Gerät, das nicht in der Konfiguration steht: {subject}{because}.</translation>
    </message>
    <message>
        <source>There is no Sync Unit "{unit}"; the unnamed one is used.</source>
        <translation>Es gibt keine Sync Unit "{unit}"; die namenlose wird verwendet.</translation>
    </message>
    <message>
        <source>There is no deviation to watch</source>
        <translation>Es gibt keine Abweichung zu überwachen</translation>
    </message>
    <message>
        <source>There is no network adapter or link "{subject}"{because}.</source>
        <translation>Es gibt keine Netzwerkkarte und keinen Link "{subject}"{because}.</translation>
    </message>
    <message>
        <source>There is no setting "{subject}"{because}.</source>
        <translation>Es gibt keine Einstellung "{subject}"{because}.</translation>
    </message>
    <message>
        <source>There is no slave at position {position}.</source>
        <translation>An Position {position} gibt es keinen Slave.</translation>
    </message>
    <message>
        <source>There is no such adapter or link</source>
        <translation>Eine solche Netzwerkkarte oder einen solchen Link gibt es nicht</translation>
    </message>
    <message>
        <source>There is no such setting</source>
        <translation>Eine solche Einstellung gibt es nicht</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Es ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is nothing to compare: EC-Master leaves the monitoring out</source>
        <translation>Es gibt nichts zu vergleichen: EC-Master lässt die Überwachung weg</translation>
    </message>
    <message>
        <source>A slave went down unasked</source>
        <translation>Ein Slave ging ungefragt in einen niedrigeren Zustand</translation>
    </message>
    <message>
        <source>{subject}: the receive time of its port {port} contradicts all others and is left out</source>
        <translation>{subject}: die Empfangszeit seines Ports {port} widerspricht allen anderen und bleibt außer Betracht</translation>
    </message>
    <message>
        <source>{subject}: the delay to it and to those behind it cannot be measured, because the slave at which their branch parts has no receive times; {delay} is taken, which is wrong by the cables of both branches (some 100 ns)</source>
        <translation>{subject}: Die Laufzeit dorthin und zu den Slaves dahinter ist nicht messbar, weil der Slave, an dem sich ihr Zweig teilt, keine Empfangszeiten hat; angenommen wird {delay}, falsch um die Kabel beider Zweige (einige 100 ns)</translation>
    </message>
    <message>
        <source>{subject}: {from} -&gt; {to} without an error, and not asked by this master</source>
        <translation>{subject}: {from} -&gt; {to} ohne Fehler und nicht von diesem Master verlangt</translation>
    </message>
    <message>
        <source>The bus was running already</source>
        <translation>Der Bus lief schon</translation>
    </message>
    <message>
        <source>slaves are in SAFEOP or OP already: another master operates this bus, or it was left so; they are taken to INIT</source>
        <translation>Slaves sind schon in SAFEOP oder OP: Ein anderer Master betreibt diesen Bus, oder er wurde so verlassen; sie werden nach INIT geführt</translation>
    </message>
    <message>
        <source>A slave went down without being asked</source>
        <translation>Ein Slave ging in einen niedrigeren Zustand, ohne gefragt zu sein</translation>
    </message>
    <message>
        <source>Look for another master on this bus, a second program or a second cable; or for a slave that begins anew by itself. What clocks and drives did since then is not this master's doing.</source>
        <translation>Suchen Sie einen anderen Master an diesem Bus, ein zweites Programm oder ein zweites Kabel; oder einen Slave, der von selbst neu beginnt. Was Uhren und Antriebe seitdem taten, ist nicht das Werk dieses Masters.</translation>
    </message>
    <message>
        <source>{slave} went from {from} to {to} at {since}, without an error, and this master had not asked it.</source>
        <translation>{slave} ging bei {since} von {from} nach {to}, ohne Fehler, und dieser Master hatte es nicht verlangt.</translation>
    </message>
    <message>
        <source>A slave had left OP with an error</source>
        <translation>Ein Slave hatte OP mit einem Fehler verlassen</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), and was led up again.</source>
        <translation>{slave} war bei {since} mit AL-Statuscode {alcode}{alarm} nach {state} gefallen ({count} insgesamt) und wurde wieder hochgeführt.</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), before it answered no more.</source>
        <translation>{slave} war bei {since} mit AL-Statuscode {alcode}{alarm} nach {state} gefallen ({count} insgesamt), bevor er nicht mehr antwortete.</translation>
    </message>
    <message>
        <source>A slave's firmware stands still</source>
        <translation>Die Firmware eines Slaves steht still</translation>
    </message>
    <message>
        <source>Its outputs and inputs stand still. Look for what stops it: an interrupt storm, a debugger, a crash; its power has to be switched off and on.</source>
        <translation>Seine Ausgänge und Eingänge stehen still. Suchen Sie, was sie anhält: eine Interruptflut, ein Debugger, ein Absturz; seine Versorgung muss aus- und eingeschaltet werden.</translation>
    </message>
    <message>
        <source>The firmware of {slave} is silent since {since}: its PDI watchdog expired {count} (0x0443).</source>
        <translation>Die Firmware von {slave} schweigt seit {since}: ihr PDI-Watchdog lief {count} ab (0x0443).</translation>
    </message>
    <message>
        <source>Nothing tells where. Look at the cables and plugs, and at the network card and its driver.</source>
        <translation>Nichts verrät, wo. Sehen Sie nach Kabeln und Steckern und nach der Netzwerkkarte und ihrem Treiber.</translation>
    </message>
    <message>
        <source>Frames are lost in front of a slave</source>
        <translation>Frames gehen vor einem Slave verloren</translation>
    </message>
    <message>
        <source>Look at the cables and plugs between the host and it, and at the network card and its driver.</source>
        <translation>Sehen Sie nach den Kabeln und Steckern zwischen dem Rechner und ihm und nach der Netzwerkkarte und ihrem Treiber.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and {slave}, the first that counts, missed its outputs with them: they had not got to it. No slave counted an error at its ports.</source>
        <translation>{count:# Frame kam|# Frames kamen} nicht zurück (bis zu {most} dicht beieinander, zuerst bei {since}), und {slave}, dem ersten, der zählt, fehlten damit seine Ausgänge: Sie waren nicht bis zu ihm gelangt. Kein Slave zählte einen Fehler an seinen Ports.</translation>
    </message>
    <message>
        <source>The working counter is never the expected one</source>
        <translation>Der Working Counter ist nie der erwartete</translation>
    </message>
    <message>
        <source>The configuration expects what this bus does not give: correct Cnt of the cyclic command, or export it anew for these slaves. A slave without LRW (0x0008 bit 9) needs LRD and LWR instead. Inputs are not taken meanwhile.</source>
        <translation>Die Konfiguration erwartet, was dieser Bus nicht gibt: Berichtigen Sie Cnt des zyklischen Befehls, oder exportieren Sie sie neu für diese Slaves. Ein Slave ohne LRW (0x0008 Bit 9) braucht stattdessen LRD und LWR. Eingänge werden solange nicht übernommen.</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter, all from {since} on ({received} instead of {expected}), although each slave answers and none has fallen.</source>
        <translation>{count:# Zyklus hatte|# Zyklen hatten} einen falschen Working Counter, alle ab {since} ({received} statt {expected}), obwohl jeder Slave antwortet und keiner gefallen ist.</translation>
    </message>
    <message>
        <source>A propagation delay could not be measured</source>
        <translation>Eine Laufzeit konnte nicht gemessen werden</translation>
    </message>
    <message>
        <source>Its receive times (0x0900 to 0x090C) and those of the slave before it contradict each other: one of the two does not latch them as it should. Until that is mended these clocks cannot be compared, whatever 0x092C says.</source>
        <translation>Seine Empfangszeiten (0x0900 bis 0x090C) und die des Slaves davor widersprechen sich: Einer der beiden hält sie nicht fest, wie er sollte. Bis das behoben ist, lassen sich diese Uhren nicht vergleichen, was immer 0x092C sagt.</translation>
    </message>
    <message>
        <source>{slave}: the way to it from the slave before it comes out as {delay}, which cannot be. 0 is taken (0x0928), and its clock and those behind it are off by what the way really takes; no reading shows it.</source>
        <translation>{slave}: Der Weg vom Slave davor zu ihm ergibt {delay}, was nicht sein kann. Genommen wird 0 (0x0928), und seine Uhr und die dahinter sind um das falsch, was der Weg wirklich dauert; keine Ablesung zeigt das.</translation>
    </message>
    <message>
        <source>They are part of the assignment and never exchanged</source>
        <translation>Sie gehören zur Zuordnung und werden nie ausgetauscht</translation>
    </message>
    <message>
        <source>Time-out back to INIT</source>
        <translation>Zeitgrenze zurück nach INIT</translation>
    </message>
    <message>
        <source>Time-out back to SAFEOP</source>
        <translation>Zeitgrenze zurück nach SAFEOP</translation>
    </message>
    <message>
        <source>Time-out to PREOP</source>
        <translation>Zeitgrenze nach PREOP</translation>
    </message>
    <message>
        <source>Time-out to SAFEOP and OP</source>
        <translation>Zeitgrenze nach SAFEOP und OP</translation>
    </message>
    <message>
        <source>TwinCAT gives several names to the state bits of its frames and slaves; other masters do not fill them</source>
        <translation>TwinCAT gibt den Zustandsbits seiner Frames und Slaves mehrere Namen; andere Master füllen sie nicht</translation>
    </message>
    <message>
        <source>TwinCAT takes the cycle from its own task; EC-Master and others use a default</source>
        <translation>TwinCAT nimmt den Zyklus von seiner eigenen Task; EC-Master und andere nehmen eine Vorgabe</translation>
    </message>
    <message>
        <source>TwinCAT writes the variables of its own diagnosis so; other masters have nothing there</source>
        <translation>TwinCAT schreibt die Variablen seiner eigenen Diagnose so; andere Master haben dort nichts</translation>
    </message>
    <message>
        <source>Two FMMUs give the same input bits</source>
        <translation>Zwei FMMUs liefern dieselben Eingangsbits</translation>
    </message>
    <message>
        <source>Two FMMUs take the same output bits</source>
        <translation>Zwei FMMUs nehmen dieselben Ausgangsbits</translation>
    </message>
    <message>
        <source>Two SyncManagers share memory</source>
        <translation>Zwei SyncManager teilen sich Speicher</translation>
    </message>
    <message>
        <source>Two commands carry the same process data</source>
        <translation>Zwei Kommandos tragen dieselben Prozessdaten</translation>
    </message>
    <message>
        <source>Two commands share bytes of the image</source>
        <translation>Zwei Kommandos teilen sich Bytes des Abbilds</translation>
    </message>
    <message>
        <source>Two hot-connect groups have the same identification</source>
        <translation>Zwei Hot-Connect-Gruppen haben dieselbe Kennung</translation>
    </message>
    <message>
        <source>Two mailboxes share a status bit</source>
        <translation>Zwei Mailboxen teilen sich ein Statusbit</translation>
    </message>
    <message>
        <source>Two modules bring PDO {pdo}; the ESI's SlotPdoIncrement does not part them.</source>
        <translation>Zwei Module bringen das PDO {pdo} mit; SlotPdoIncrement der ESI trennt sie nicht.</translation>
    </message>
    <message>
        <source>Two modules bring the same PDO</source>
        <translation>Zwei Module bringen dasselbe PDO mit</translation>
    </message>
    <message>
        <source>Two slaves hang on one port</source>
        <translation>Zwei Slaves hängen an einem Port</translation>
    </message>
    <message>
        <source>Two slaves have changed places</source>
        <translation>Zwei Slaves haben die Plätze getauscht</translation>
    </message>
    <message>
        <source>Two slaves have the same alias</source>
        <translation>Zwei Slaves haben denselben Alias</translation>
    </message>
    <message>
        <source>Two slaves have the same device ID</source>
        <translation>Zwei Slaves haben dieselbe Gerätekennung</translation>
    </message>
    <message>
        <source>Two slaves have the same name</source>
        <translation>Zwei Slaves haben denselben Namen</translation>
    </message>
    <message>
        <source>Two slaves have the same station address</source>
        <translation>Zwei Slaves haben dieselbe Stationsadresse</translation>
    </message>
    <message>
        <source>Two slaves share bits of the image</source>
        <translation>Zwei Slaves teilen sich Bits des Abbilds</translation>
    </message>
    <message>
        <source>Two variables have the same name</source>
        <translation>Zwei Variablen haben denselben Namen</translation>
    </message>
    <message>
        <source>Two variables share bits</source>
        <translation>Zwei Variablen teilen sich Bits</translation>
    </message>
    <message>
        <source>Use 0x0700 to activate both</source>
        <translation>Mit 0x0700 beide aktivieren</translation>
    </message>
    <message>
        <source>Use 0x26 for requests (SM0) and 0x22 for answers (SM1)</source>
        <translation>0x26 für Anfragen (SM0) und 0x22 für Antworten (SM1) verwenden</translation>
    </message>
    <message>
        <source>Use 4 or 8 bytes for 0x0910, 4 for 0x092C</source>
        <translation>4 oder 8 Bytes für 0x0910, 4 für 0x092C verwenden</translation>
    </message>
    <message>
        <source>Use ARMW with the auto-increment address of the reference clock</source>
        <translation>ARMW mit der Auto-Increment-Adresse der Referenzuhr verwenden</translation>
    </message>
    <message>
        <source>Use a longer bus cycle or a larger sync multiplier, or let its fieldbus carry less.</source>
        <translation>Einen längeren Buszyklus oder einen größeren Sync Multiplier nehmen, oder seinen Feldbus weniger übertragen lassen.</translation>
    </message>
    <message>
        <source>Use a multiple</source>
        <translation>Ein Vielfaches verwenden</translation>
    </message>
    <message>
        <source>Use a multiple or a whole fraction of the cycle</source>
        <translation>Ein Vielfaches oder einen ganzen Bruchteil des Zyklus verwenden</translation>
    </message>
    <message>
        <source>Use a shift within the cycle</source>
        <translation>Eine Verschiebung innerhalb des Zyklus verwenden</translation>
    </message>
    <message>
        <source>Use start and length of the ESI (16 to 1486 bytes in data memory)</source>
        <translation>Anfang und Länge der ESI verwenden (16 bis 1486 Bytes im Datenspeicher)</translation>
    </message>
    <message>
        <source>Use the time-outs of the ESI (3000 ms to PREOP, 10000 ms to SAFEOP and OP, 200 ms back to SAFEOP)</source>
        <translation>Die Zeitgrenzen der ESI verwenden (3000 ms nach PREOP, 10000 ms nach SAFEOP und OP, 200 ms zurück nach SAFEOP)</translation>
    </message>
    <message>
        <source>Variables lie behind the image</source>
        <translation>Variablen liegen hinter dem Abbild</translation>
    </message>
    <message>
        <source>Variables lie in other bytes than the process image says</source>
        <translation>Variablen liegen in anderen Bytes, als das Prozessabbild sagt</translation>
    </message>
    <message>
        <source>Variables of the diagnosis share bits</source>
        <translation>Variablen der Diagnose teilen sich Bits</translation>
    </message>
    <message>
        <source>Variables of the inputs</source>
        <translation>Variablen der Eingänge</translation>
    </message>
    <message>
        <source>Watch the counter in 0x1C32, or set a limit in 0x10F1:02</source>
        <translation>Den Zähler in 0x1C32 beobachten, oder in 0x10F1:02 eine Grenze setzen</translation>
    </message>
    <message>
        <source>What is compared is another word, or nothing</source>
        <translation>Verglichen wird ein anderes Wort, oder nichts</translation>
    </message>
    <message>
        <source>When all tasks are due in one cycle their frames take {wire} of {cycle} of wire time.</source>
        <translation>Wenn alle Tasks in einem Zyklus fällig sind, brauchen ihre Frames {wire} von {cycle} Leitungszeit.</translation>
    </message>
    <message>
        <source>Without SYNC0 the gateway knows its bus cycle from 0x1C32:02 only, which no start-up command writes: it starts a CAN cycle with each frame.</source>
        <translation>Ohne SYNC0 kennt das Gateway seinen Buszyklus nur aus 0x1C32:02, das kein Startkommando schreibt: es beginnt mit jedem Frame einen CAN-Zyklus.</translation>
    </message>
    <message>
        <source>Without a value to compare, the master cannot know which group has been plugged in</source>
        <translation>Ohne Vergleichswert kann der Master nicht wissen, welche Gruppe eingesteckt wurde</translation>
    </message>
    <message>
        <source>Working counters are wrong</source>
        <translation>Working Counter sind falsch</translation>
    </message>
    <message>
        <source>Working counters are wrong for a known reason</source>
        <translation>Working Counter sind aus bekanntem Grund falsch</translation>
    </message>
    <message>
        <source>Write 0 to 0x0500 first</source>
        <translation>Erst 0 nach 0x0500 schreiben</translation>
    </message>
    <message>
        <source>Write 0 to sub-index 0, then the entries, then their count</source>
        <translation>Erst 0 in den Subindex 0 schreiben, dann die Einträge, dann ihre Anzahl</translation>
    </message>
    <message>
        <source>Write 0, 65535, 65534 and so on in the order of the slaves</source>
        <translation>0, 65535, 65534 und so weiter in der Reihenfolge der Slaves schreiben</translation>
    </message>
    <message>
        <source>Write 0, the master's own time, or at least 20 ms</source>
        <translation>0 schreiben, die eigene Zeit des Masters, oder mindestens 20 ms</translation>
    </message>
    <message>
        <source>Write 0x09A0 and 0x0990 before 0x0980</source>
        <translation>0x09A0 und 0x0990 vor 0x0980 schreiben</translation>
    </message>
    <message>
        <source>Write 1 to 0x0500 before the request</source>
        <translation>Vor der Anforderung 1 nach 0x0500 schreiben</translation>
    </message>
    <message>
        <source>Write 2 to 0x1C32:01 and 0x1C33:01, or switch SYNC0 off</source>
        <translation>2 nach 0x1C32:01 und 0x1C33:01 schreiben, oder SYNC0 ausschalten</translation>
    </message>
    <message>
        <source>Write Ccs 1</source>
        <translation>Ccs 1 schreiben</translation>
    </message>
    <message>
        <source>Write a value of the type named</source>
        <translation>Einen Wert des genannten Typs schreiben</translation>
    </message>
    <message>
        <source>Write a value within the range</source>
        <translation>Einen Wert im Bereich schreiben</translation>
    </message>
    <message>
        <source>Write as many bytes as the object has</source>
        <translation>So viele Bytes schreiben, wie das Objekt hat</translation>
    </message>
    <message>
        <source>Write it as the schema does; numbers from 0x80000000 on as negative ones</source>
        <translation>Ihn schreiben wie das Schema; Zahlen ab 0x80000000 als negative</translation>
    </message>
    <message>
        <source>Write one to its EEPROM (page EEPROM, or synclinectl sii alias) and set it here, or set the device ID of its switches (check.device_id).</source>
        <translation>Einen in sein EEPROM schreiben (Seite EEPROM, oder synclinectl sii alias) und hier einstellen, oder die Geräte-ID seiner Schalter einstellen (check.device_id).</translation>
    </message>
    <message>
        <source>Write outputs and read inputs: correct type or physical address</source>
        <translation>Ausgänge schreiben und Eingänge lesen: Art oder physikalische Adresse berichtigen</translation>
    </message>
    <message>
        <source>Write the EEPROM of the device's ESI again.</source>
        <translation>Das EEPROM aus der ESI des Geräts neu schreiben.</translation>
    </message>
    <message>
        <source>Write the PDOs of the SyncManager's list to 0x1C1n, in its order</source>
        <translation>Die PDOs der Liste des SyncManagers in ihrer Reihenfolge nach 0x1C1n schreiben</translation>
    </message>
    <message>
        <source>Write the bus cycle to 0x1C32:02 on PS</source>
        <translation>Den Buszyklus auf PS nach 0x1C32:02 schreiben</translation>
    </message>
    <message>
        <source>Write the cycle time to 0x09A0 on PS</source>
        <translation>Die Zykluszeit auf PS nach 0x09A0 schreiben</translation>
    </message>
    <message>
        <source>Write the entries of the PDO, in its order, or correct the PDO</source>
        <translation>Die Einträge des PDOs in ihrer Reihenfolge schreiben, oder das PDO berichtigen</translation>
    </message>
    <message>
        <source>Writing the one changes the other</source>
        <translation>Wer die eine schreibt, ändert die andere</translation>
    </message>
    <message>
        <source>a buffer for inputs</source>
        <translation>einem Puffer für Eingänge</translation>
    </message>
    <message>
        <source>a buffer for outputs</source>
        <translation>einem Puffer für Ausgänge</translation>
    </message>
    <message>
        <source>a decimal number from -2147483648 to 2147483647</source>
        <translation>eine Dezimalzahl von -2147483648 bis 2147483647</translation>
    </message>
    <message>
        <source>a decimal number from 0 to 255</source>
        <translation>eine Dezimalzahl von 0 bis 255</translation>
    </message>
    <message>
        <source>a decimal number from 0 to 65535</source>
        <translation>eine Dezimalzahl von 0 bis 65535</translation>
    </message>
    <message>
        <source>a decimal number of 32 bits, negative from 2147483648 on</source>
        <translation>eine Dezimalzahl von 32 Bits, negativ ab 2147483648</translation>
    </message>
    <message>
        <source>a decimal number, or a hexadecimal one as #x1a00</source>
        <translation>eine Dezimalzahl, oder eine hexadezimale wie #x1a00</translation>
    </message>
    <message>
        <source>a frame was sent later than the set value allows</source>
        <translation>ein Frame wurde später gesendet, als der Sollwert erlaubt</translation>
    </message>
    <message>
        <source>a mailbox</source>
        <translation>eine Mailbox</translation>
    </message>
    <message>
        <source>a mailbox for answers</source>
        <translation>einer Mailbox für Antworten</translation>
    </message>
    <message>
        <source>a mailbox for requests</source>
        <translation>einer Mailbox für Anfragen</translation>
    </message>
    <message>
        <source>a running machine is touched: {running:# slave is|# slaves are} beyond INIT. States and station addresses stay; {eeproms:# EEPROM is taken from its PDI while it is|# EEPROMs are taken from their PDIs while they are} read, and the DC receive times are latched</source>
        <translation>eine laufende Maschine wird berührt: {running:# Slave ist|# Slaves sind} über INIT hinaus. Zustände und Stationsadressen bleiben; {eeproms:# EEPROM wird zum Lesen von seinem PDI|# EEPROMs werden zum Lesen von ihren PDIs} genommen, und die DC-Empfangszeiten werden festgehalten</translation>
    </message>
    <message>
        <source>a transition on which SoE is allowed: PS, SO, SP, OP or OS</source>
        <translation>ein Übergang, auf dem SoE erlaubt ist: PS, SO, SP, OP oder OS</translation>
    </message>
    <message>
        <source>a transition such as IP or PS</source>
        <translation>ein Übergang wie IP oder PS</translation>
    </message>
    <message>
        <source>access denied; is the password right?</source>
        <translation>Zugriff verweigert; stimmt das Passwort?</translation>
    </message>
    <message>
        <source>access to the object not supported</source>
        <translation>Zugriff auf das Objekt nicht unterstützt</translation>
    </message>
    <message>
        <source>activation (0x0980)</source>
        <translation>Aktivierung (0x0980)</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>active for neither reading nor writing</source>
        <translation>weder zum Lesen noch zum Schreiben aktiv</translation>
    </message>
    <message>
        <source>added</source>
        <translation>hinzugekommen</translation>
    </message>
    <message>
        <source>additional</source>
        <translation>zusätzlich</translation>
    </message>
    <message>
        <source>address, length and control byte of SM0 and SM1 and that both are enabled</source>
        <translation>Adresse, Länge und Steuerbyte von SM0 und SM1, und ob beide eingeschaltet sind</translation>
    </message>
    <message>
        <source>alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>alias {alias} identifies the group of {slave}, too</source>
        <translation>Alias {alias} kennzeichnet auch die Gruppe von {slave}</translation>
    </message>
    <message>
        <source>an init command writes {activation} to 0x0980, and there is no DC element</source>
        <translation>ein InitCmd schreibt {activation} nach 0x0980, und es gibt kein Element DC</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>application controller available</source>
        <translation>Applikations-Controller verfügbar</translation>
    </message>
    <message>
        <source>attribute {element} is "{value}" instead of {wanted}</source>
        <translation>Attribut {element} ist "{value}" statt {wanted}</translation>
    </message>
    <message>
        <source>attribute {element} of &lt;{parent}&gt;</source>
        <translation>Attribut {element} von &lt;{parent}&gt;</translation>
    </message>
    <message>
        <source>attribute {element} of &lt;{parent}&gt;, {count:# time|# times}</source>
        <translation>Attribut {element} von &lt;{parent}&gt;, {count}-mal</translation>
    </message>
    <message>
        <source>auto-increment address</source>
        <translation>Auto-Increment-Adresse</translation>
    </message>
    <message>
        <source>background watchdog</source>
        <translation>Hintergrund-Watchdog</translation>
    </message>
    <message>
        <source>before slave</source>
        <translation>vor dem Slave</translation>
    </message>
    <message>
        <source>bit of variable "{variable}"</source>
        <translation>Bit der Variablen "{variable}"</translation>
    </message>
    <message>
        <source>bits of variable "{variable}"</source>
        <translation>Bits der Variablen "{variable}"</translation>
    </message>
    <message>
        <source>block checksum wrong</source>
        <translation>Prüfsumme des Blocks falsch</translation>
    </message>
    <message>
        <source>block sequence number invalid</source>
        <translation>Blocknummer ungültig</translation>
    </message>
    <message>
        <source>block size invalid</source>
        <translation>Blockgröße ungültig</translation>
    </message>
    <message>
        <source>bootstrap mailbox for answers</source>
        <translation>Bootstrap-Mailbox für Antworten</translation>
    </message>
    <message>
        <source>bootstrap mailbox for requests</source>
        <translation>Bootstrap-Mailbox für Anfragen</translation>
    </message>
    <message>
        <source>bootstrap not supported</source>
        <translation>BOOT nicht unterstützt</translation>
    </message>
    <message>
        <source>bytes of two hexadecimal digits each</source>
        <translation>Bytes aus je zwei Hexadezimalziffern</translation>
    </message>
    <message>
        <source>cable between {subject} port {port} and {far}: NOTHING COMES BACK (pulled, broken, or no power behind it)</source>
        <translation>Kabel zwischen {subject} Port {port} und {far}: NICHTS KOMMT ZURÜCK (gezogen, gebrochen, oder dahinter fehlt die Versorgung)</translation>
    </message>
    <message>
        <source>cable between {subject} port {port} and {far}: healed</source>
        <translation>Kabel zwischen {subject} Port {port} und {far}: wieder heil</translation>
    </message>
    <message>
        <source>check time-out</source>
        <translation>Zeitgrenze der Prüfung</translation>
    </message>
    <message>
        <source>command specifier invalid or unknown</source>
        <translation>Kommando ungültig oder unbekannt</translation>
    </message>
    <message>
        <source>commands come in another order</source>
        <translation>die Kommandos kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>complete access not supported</source>
        <translation>Complete Access nicht unterstützt</translation>
    </message>
    <message>
        <source>configured modules differ from the detected ones</source>
        <translation>die eingestellten Module sind nicht die vorgefundenen</translation>
    </message>
    <message>
        <source>content and wiring of the EEPROM</source>
        <translation>Inhalt und Verdrahtung des EEPROMs</translation>
    </message>
    <message>
        <source>cycle time</source>
        <translation>Zykluszeit</translation>
    </message>
    <message>
        <source>cycle time too small (older slaves: invalid input FMMU)</source>
        <translation>Zykluszeit zu klein (ältere Slaves: ungültige Eingangs-FMMU)</translation>
    </message>
    <message>
        <source>cycles were left out, the host came too late</source>
        <translation>Zyklen wurden ausgelassen, der Host kam zu spät</translation>
    </message>
    <message>
        <source>cyclic frames and the device's inputs before OP is requested</source>
        <translation>zyklische Frames und die Eingänge des Geräts, bevor OP angefordert wird</translation>
    </message>
    <message>
        <source>cyclic tasks</source>
        <translation>zyklische Tasks</translation>
    </message>
    <message>
        <source>data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>data cannot be transferred or stored</source>
        <translation>Daten können nicht übertragen oder gespeichert werden</translation>
    </message>
    <message>
        <source>data link layer of the mailbox</source>
        <translation>Data Link Layer der Mailbox</translation>
    </message>
    <message>
        <source>data too long</source>
        <translation>Daten zu lang</translation>
    </message>
    <message>
        <source>data too short</source>
        <translation>Daten zu kurz</translation>
    </message>
    <message>
        <source>data type of variable "{variable}"</source>
        <translation>Datentyp der Variablen "{variable}"</translation>
    </message>
    <message>
        <source>data type or length does not match</source>
        <translation>Datentyp oder Länge passt nicht</translation>
    </message>
    <message>
        <source>dcx follows an external clock, but no slave maps both time stamps of the external synchronisation (0x10F4:11 and :12) into its inputs.</source>
        <translation>dcx folgt einer externen Uhr, aber kein Slave mappt beide Zeitstempel der externen Synchronisation (0x10F4:11 und :12) in seine Eingänge.</translation>
    </message>
    <message>
        <source>destination address</source>
        <translation>Zieladresse</translation>
    </message>
    <message>
        <source>detected modules differ from the configured ones</source>
        <translation>erkannte Module weichen von den konfigurierten ab</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>device identification value updated</source>
        <translation>Wert der Geräteidentifikation geändert</translation>
    </message>
    <message>
        <source>distributed clocks</source>
        <translation>Distributed Clocks</translation>
    </message>
    <message>
        <source>distributed clocks initialised: {slaves:# slave|# slaves}, no reference clock</source>
        <translation>Distributed Clocks eingerichtet: {slaves:# Slave|# Slaves}, keine Referenzuhr</translation>
    </message>
    <message>
        <source>distributed clocks initialised: {slaves:# slave|# slaves}, reference clock is {clock}</source>
        <translation>Distributed Clocks eingerichtet: {slaves:# Slave|# Slaves}, Referenzuhr ist {clock}</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>expected bytes</source>
        <translation>erwartete Bytes</translation>
    </message>
    <message>
        <source>expected mask</source>
        <translation>erwartete Maske</translation>
    </message>
    <message>
        <source>external hardware not ready</source>
        <translation>externe Hardware nicht bereit</translation>
    </message>
    <message>
        <source>fatal sync error</source>
        <translation>schwerer Synchronisationsfehler</translation>
    </message>
    <message>
        <source>file not found</source>
        <translation>Datei nicht gefunden</translation>
    </message>
    <message>
        <source>firmware update not successful</source>
        <translation>Firmware-Aktualisierung nicht gelungen</translation>
    </message>
    <message>
        <source>for inputs</source>
        <translation>für Eingänge</translation>
    </message>
    <message>
        <source>for outputs</source>
        <translation>für Ausgänge</translation>
    </message>
    <message>
        <source>frame or cycle</source>
        <translation>frame oder cycle</translation>
    </message>
    <message>
        <source>frames came behind the SYNC0 they were meant for</source>
        <translation>Frames kamen hinter dem SYNC0, für das sie bestimmt waren</translation>
    </message>
    <message>
        <source>the master was not locked to the reference clock, and frames slid through its SYNC0</source>
        <translation>der Master war nicht auf die Referenzuhr eingerastet, und Frames glitten durch SYNC0</translation>
    </message>
    <message>
        <source>frames were lost</source>
        <translation>Frames gingen verloren</translation>
    </message>
    <message>
        <source>free run needs three buffer mode</source>
        <translation>Freilauf braucht den Drei-Puffer-Betrieb</translation>
    </message>
    <message>
        <source>free run not supported</source>
        <translation>Freilauf nicht unterstützt</translation>
    </message>
    <message>
        <source>gateways</source>
        <translation>Gateways</translation>
    </message>
    <message>
        <source>terminals</source>
        <translation>Klemmen</translation>
    </message>
    <message>
        <source>general error</source>
        <translation>allgemeiner Fehler</translation>
    </message>
    <message>
        <source>go to INIT first</source>
        <translation>erst nach INIT gehen</translation>
    </message>
    <message>
        <source>go to PREOP first</source>
        <translation>erst nach PREOP gehen</translation>
    </message>
    <message>
        <source>go to SAFEOP first</source>
        <translation>erst nach SAFEOP gehen</translation>
    </message>
    <message>
        <source>group "{group}" has no IdentifyCmd that compares what it reads</source>
        <translation>Gruppe "{group}" hat kein IdentifyCmd, das vergleicht, was es liest</translation>
    </message>
    <message>
        <source>group "{group}" has {members:# member|# members}, but only {left:# slave is|# slaves are} left from here</source>
        <translation>Gruppe "{group}" hat {members:# Mitglied|# Mitglieder}, aber ab hier {left:ist nur # Slave|sind nur # Slaves} übrig</translation>
    </message>
    <message>
        <source>group "{group}" has {members:# member|# members}, but {slave} begins a group of its own</source>
        <translation>Gruppe "{group}" hat {members:# Mitglied|# Mitglieder}, aber {slave} beginnt eine eigene Gruppe</translation>
    </message>
    <message>
        <source>hangs on</source>
        <translation>hängt an</translation>
    </message>
    <message>
        <source>hardware error</source>
        <translation>Hardwarefehler</translation>
    </message>
    <message>
        <source>hot-connect group</source>
        <translation>Hot-Connect-Gruppe</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>identification of the hot-connect group</source>
        <translation>Kennung der Hot-Connect-Gruppe</translation>
    </message>
    <message>
        <source>illegal operation</source>
        <translation>unerlaubter Vorgang</translation>
    </message>
    <message>
        <source>incompatible inside the device</source>
        <translation>im Gerät passt etwas nicht zusammen</translation>
    </message>
    <message>
        <source>inconsistent settings</source>
        <translation>widersprüchliche Einstellungen</translation>
    </message>
    <message>
        <source>info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>init command</source>
        <translation>Init-Kommando</translation>
    </message>
    <message>
        <source>init command {command}: {field}</source>
        <translation>Init-Kommando {command}: {field}</translation>
    </message>
    <message>
        <source>init commands</source>
        <translation>Init-Kommandos</translation>
    </message>
    <message>
        <source>init commands of a transition come in another order</source>
        <translation>Init-Kommandos eines Übergangs kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>inputs are not those of SYNC0</source>
        <translation>Eingänge sind nicht die von SYNC0</translation>
    </message>
    <message>
        <source>inputs of {command} in the image</source>
        <translation>Eingänge von {command} im Abbild</translation>
    </message>
    <message>
        <source>inputs of {slaves:# slave|# slaves} begin elsewhere in the image</source>
        <translation>die Eingänge von {slaves:# Slave|# Slaves} beginnen anderswo im Abbild</translation>
    </message>
    <message>
        <source>invalid DC SYNC configuration</source>
        <translation>ungültige DC-SYNC-Konfiguration</translation>
    </message>
    <message>
        <source>invalid DC latch configuration</source>
        <translation>ungültige DC-Latch-Konfiguration</translation>
    </message>
    <message>
        <source>invalid SYNC cycle time</source>
        <translation>ungültige SYNC-Zykluszeit</translation>
    </message>
    <message>
        <source>invalid SYNC0 cycle time</source>
        <translation>ungültige SYNC0-Zykluszeit</translation>
    </message>
    <message>
        <source>invalid SYNC1 cycle time</source>
        <translation>ungültige SYNC1-Zykluszeit</translation>
    </message>
    <message>
        <source>invalid SyncManager configuration</source>
        <translation>ungültige SyncManager-Konfiguration</translation>
    </message>
    <message>
        <source>invalid SyncManager types</source>
        <translation>ungültige SyncManager-Arten</translation>
    </message>
    <message>
        <source>invalid device setup</source>
        <translation>ungültiger Geräteaufbau</translation>
    </message>
    <message>
        <source>invalid input configuration</source>
        <translation>ungültige Eingangskonfiguration</translation>
    </message>
    <message>
        <source>invalid input mapping</source>
        <translation>ungültiges Eingangs-Mapping</translation>
    </message>
    <message>
        <source>invalid mailbox configuration in BOOT</source>
        <translation>ungültige Mailbox-Konfiguration in BOOT</translation>
    </message>
    <message>
        <source>invalid mailbox configuration in PREOP</source>
        <translation>ungültige Mailbox-Konfiguration in PREOP</translation>
    </message>
    <message>
        <source>invalid output configuration</source>
        <translation>ungültige Ausgangskonfiguration</translation>
    </message>
    <message>
        <source>invalid output mapping</source>
        <translation>ungültiges Ausgangs-Mapping</translation>
    </message>
    <message>
        <source>invalid requested state change</source>
        <translation>ungültiger Zustandswechsel angefordert</translation>
    </message>
    <message>
        <source>invalid revision</source>
        <translation>ungültige Revision</translation>
    </message>
    <message>
        <source>invalid watchdog configuration</source>
        <translation>ungültige Watchdog-Konfiguration</translation>
    </message>
    <message>
        <source>it compares data of the EEPROM for which no valid command asks</source>
        <translation>es vergleicht Daten des EEPROMs, nach denen kein gültiges Kommando fragt</translation>
    </message>
    <message>
        <source>it expects the {field} in word {word} of the EEPROM, which stands in word {own}</source>
        <translation>es erwartet {field} in Wort {word} des EEPROM, steht aber in Wort {own}</translation>
    </message>
    <message>
        <source>it hangs on {slave}, which does not stand before it</source>
        <translation>er hängt an {slave}, der nicht vor ihm steht</translation>
    </message>
    <message>
        <source>it hangs on {slave}, which stands behind it</source>
        <translation>er hängt an {slave}, der hinter ihm steht</translation>
    </message>
    <message>
        <source>it has no InitCmds</source>
        <translation>er hat keine InitCmds</translation>
    </message>
    <message>
        <source>it has {bytes:# byte|# bytes}, {most} fit</source>
        <translation>es hat {bytes:# Byte|# Bytes}, {most} passen</translation>
    </message>
    <message>
        <source>it reads the EEPROM, which does not belong to the master (0x0500 = 0) yet</source>
        <translation>es liest das EEPROM, das dem Master noch nicht gehört (0x0500 = 0)</translation>
    </message>
    <message>
        <source>it sets {written}, PhysAddr is {address}</source>
        <translation>es setzt {written}, PhysAddr ist {address}</translation>
    </message>
    <message>
        <source>it stands before the reference clock, {reference}</source>
        <translation>er steht vor der Referenzuhr, {reference}</translation>
    </message>
    <message>
        <source>its cycle of {cycle} is no multiple of the first task's {first}</source>
        <translation>ihr Zyklus von {cycle} ist kein Vielfaches des Zyklus der ersten Task von {first}</translation>
    </message>
    <message>
        <source>its datagrams take {bytes:# byte|# bytes}, {most} fit</source>
        <translation>seine Datagramme belegen {bytes:# Byte|# Bytes}, {most} passen</translation>
    </message>
    <message>
        <source>its {data} share bytes of the image with {command}</source>
        <translation>seine {data} teilen sich Bytes des Abbilds mit {command}</translation>
    </message>
    <message>
        <source>its {data} take bytes {first} to {last}, the image has {image}</source>
        <translation>seine {data} belegen die Bytes {first} bis {last}, das Abbild hat {image}</translation>
    </message>
    <message>
        <source>jitter and drift of the reference clock; wait until DC has settled before OP</source>
        <translation>Jitter und Drift der Referenzuhr; vor OP warten, bis DC eingeschwungen ist</translation>
    </message>
    <message>
        <source>late or missing frames around SYNC0: host jitter, the shift, and that the master is locked to DC</source>
        <translation>späte oder fehlende Frames um SYNC0: Jitter des Hosts, die Verschiebung, und ob der Master auf DC eingerastet ist</translation>
    </message>
    <message>
        <source>length and control byte of SM2 and SM3 against the assigned PDOs</source>
        <translation>Länge und Steuerbyte von SM2 und SM3 gegen die zugeordneten PDOs</translation>
    </message>
    <message>
        <source>licence error</source>
        <translation>Lizenzfehler</translation>
    </message>
    <message>
        <source>logical address of the mailbox state bits</source>
        <translation>logische Adresse der Zustandsbits der Mailboxen</translation>
    </message>
    <message>
        <source>logical bit of {fmmu} of {slave}, against its data in the image</source>
        <translation>logisches Bit von {fmmu} von {slave}, gegen seine Daten im Abbild</translation>
    </message>
    <message>
        <source>mailbox</source>
        <translation>Mailbox</translation>
    </message>
    <message>
        <source>mailbox AoE error</source>
        <translation>Mailbox-Fehler bei AoE</translation>
    </message>
    <message>
        <source>mailbox CoE error</source>
        <translation>Mailbox-Fehler bei CoE</translation>
    </message>
    <message>
        <source>mailbox EoE error</source>
        <translation>Mailbox-Fehler bei EoE</translation>
    </message>
    <message>
        <source>mailbox FoE error</source>
        <translation>Mailbox-Fehler bei FoE</translation>
    </message>
    <message>
        <source>mailbox SoE error</source>
        <translation>Mailbox-Fehler bei SoE</translation>
    </message>
    <message>
        <source>mailbox VoE error</source>
        <translation>Mailbox-Fehler bei VoE</translation>
    </message>
    <message>
        <source>mailbox for answers</source>
        <translation>Mailbox für Antworten</translation>
    </message>
    <message>
        <source>mailbox for requests</source>
        <translation>Mailbox für Anfragen</translation>
    </message>
    <message>
        <source>mailbox poll time</source>
        <translation>Abfragezeit der Mailbox</translation>
    </message>
    <message>
        <source>mailbox protocols</source>
        <translation>Protokolle der Mailbox</translation>
    </message>
    <message>
        <source>mailbox state bit</source>
        <translation>Zustandsbit der Mailbox</translation>
    </message>
    <message>
        <source>mailbox state bits</source>
        <translation>Zustandsbits der Mailboxen</translation>
    </message>
    <message>
        <source>mailbox states of {slaves:# slave|# slaves} have other bits</source>
        <translation>die Mailboxzustände von {slaves:# Slave|# Slaves} haben andere Bits</translation>
    </message>
    <message>
        <source>mapped objects exceed the PDO length</source>
        <translation>die gelegten Objekte sind länger als das PDO</translation>
    </message>
    <message>
        <source>master</source>
        <translation>Master</translation>
    </message>
    <message>
        <source>master OUT OF SYNC, error {error}{because}</source>
        <translation>Master NICHT SYNCHRON, Fehler {error}{because}</translation>
    </message>
    <message>
        <source>master in sync, error {error}</source>
        <translation>Master synchron, Fehler {error}</translation>
    </message>
    <message>
        <source>master{command} {field}</source>
        <translation>Master{command} {field}</translation>
    </message>
    <message>
        <source>maximum is below the minimum</source>
        <translation>das Maximum liegt unter dem Minimum</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>modules and options of the device</source>
        <translation>Module und Optionen des Geräts</translation>
    </message>
    <message>
        <source>name of the variable at bit {bit}</source>
        <translation>Name der Variablen bei Bit {bit}</translation>
    </message>
    <message>
        <source>network adapter {adapter} is DOWN, gone or without carrier: waiting for it</source>
        <translation>Netzwerkkarte {adapter} ist ABGESCHALTET, fort oder ohne Verbindung: es wird auf sie gewartet</translation>
    </message>
    <message>
        <source>network adapter {adapter} is up again after {away}</source>
        <translation>Netzwerkkarte {adapter} ist nach {away} wieder da</translation>
    </message>
    <message>
        <source>no NOP to 0x0900 stands before {command}</source>
        <translation>vor {command} steht kein NOP auf 0x0900</translation>
    </message>
    <message>
        <source>no Protocol is named</source>
        <translation>kein Protocol ist genannt</translation>
    </message>
    <message>
        <source>no SyncManager</source>
        <translation>kein SyncManager</translation>
    </message>
    <message>
        <source>no command of the master on IP clears the {registers}</source>
        <translation>kein Kommando des Masters auf IP löscht {registers}</translation>
    </message>
    <message>
        <source>no command on IP reads 0x0508 before the next request</source>
        <translation>kein Kommando auf IP liest 0x0508 vor der nächsten Anforderung</translation>
    </message>
    <message>
        <source>no command on {transition} waits for {state} behind this request</source>
        <translation>kein Kommando auf {transition} wartet hinter dieser Anforderung auf {state}</translation>
    </message>
    <message>
        <source>no cyclic BRD reads 0x0130</source>
        <translation>kein zyklisches BRD liest 0x0130</translation>
    </message>
    <message>
        <source>no data available</source>
        <translation>keine Daten vorhanden</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>no init command compares vendor or product with the EEPROM</source>
        <translation>kein InitCmd vergleicht Hersteller oder Produkt mit dem EEPROM</translation>
    </message>
    <message>
        <source>no init command on IP enables SM{manager} for {element}</source>
        <translation>kein InitCmd auf IP schaltet SM{manager} für {element} ein</translation>
    </message>
    <message>
        <source>no init command on SP or SI switches SYNC0 off again</source>
        <translation>kein InitCmd auf SP oder SI schaltet SYNC0 wieder aus</translation>
    </message>
    <message>
        <source>no init command on {transition} requests {state}</source>
        <translation>kein InitCmd auf {transition} fordert {state} an</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keiner Grenze</translation>
    </message>
    <message>
        <source>no memory</source>
        <translation>kein Speicher</translation>
    </message>
    <message>
        <source>no object dictionary</source>
        <translation>kein Objektverzeichnis</translation>
    </message>
    <message>
        <source>no reference clock leads</source>
        <translation>keine Referenzuhr führt</translation>
    </message>
    <message>
        <source>no rights for this file</source>
        <translation>keine Rechte an dieser Datei</translation>
    </message>
    <message>
        <source>no room left in the device</source>
        <translation>kein Platz mehr im Gerät</translation>
    </message>
    <message>
        <source>no slave has the station address {address}</source>
        <translation>kein Slave hat die Stationsadresse {address}</translation>
    </message>
    <message>
        <source>no sync signal</source>
        <translation>kein SYNC-Signal</translation>
    </message>
    <message>
        <source>no user</source>
        <translation>kein Benutzer</translation>
    </message>
    <message>
        <source>no valid firmware</source>
        <translation>keine gültige Firmware</translation>
    </message>
    <message>
        <source>no valid inputs and outputs</source>
        <translation>keine gültigen Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>no valid inputs available</source>
        <translation>keine gültigen Eingänge verfügbar</translation>
    </message>
    <message>
        <source>no valid outputs</source>
        <translation>keine gültigen Ausgänge</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht festgelegt</translation>
    </message>
    <message>
        <source>not in BOOT state</source>
        <translation>nicht im Zustand BOOT</translation>
    </message>
    <message>
        <source>not possible in the present device state, try it in PREOP</source>
        <translation>nicht möglich in diesem Zustand des Geräts, in PREOP versuchen</translation>
    </message>
    <message>
        <source>not possible under local control</source>
        <translation>nicht möglich, das Gerät wird vor Ort bedient</translation>
    </message>
    <message>
        <source>not seen by the master; look at its firmware and at frames that are damaged in front of it</source>
        <translation>vom Master nicht gesehen; seine Firmware ansehen, und Frames, die vor ihm beschädigt werden</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>object cannot be mapped to a PDO</source>
        <translation>Objekt kann in kein PDO gelegt werden</translation>
    </message>
    <message>
        <source>object does not exist</source>
        <translation>Objekt gibt es nicht</translation>
    </message>
    <message>
        <source>object is mapped to a PDO, download blocked</source>
        <translation>Objekt liegt in einem PDO, Schreiben gesperrt</translation>
    </message>
    <message>
        <source>object larger than the mailbox</source>
        <translation>Objekt größer als die Mailbox</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>Offline</translation>
    </message>
    <message>
        <source>on {transition} it comes behind the request for {state}</source>
        <translation>auf {transition} kommt es hinter der Anforderung von {state}</translation>
    </message>
    <message>
        <source>on {transition} it requests {requested} instead of {wanted}</source>
        <translation>auf {transition} fordert es {requested} statt {wanted} an</translation>
    </message>
    <message>
        <source>on {transition} it waits for {awaited}, requested is {requested}</source>
        <translation>auf {transition} wartet es auf {awaited}, angefordert ist {requested}</translation>
    </message>
    <message>
        <source>on {transition} it waits for {state} with the error bit (0x10) set</source>
        <translation>auf {transition} wartet es auf {state} mit gesetztem Fehlerbit (0x10)</translation>
    </message>
    <message>
        <source>one of the slaves</source>
        <translation>einer der Slaves</translation>
    </message>
    <message>
        <source>online: the master runs the configuration</source>
        <translation>Online: der Master führt die Konfiguration aus</translation>
    </message>
    <message>
        <source>only Sigma-X drives take it</source>
        <translation>nur Sigma-X-Antriebe nehmen es</translation>
    </message>
    <message>
        <source>only in BOOT state</source>
        <translation>nur im Zustand BOOT</translation>
    </message>
    <message>
        <source>only the current loop is synchronised then, the position loop is not</source>
        <translation>nur der Stromregler ist dann synchronisiert, der Lageregler nicht</translation>
    </message>
    <message>
        <source>order and types of the SyncManagers against 0x1C00</source>
        <translation>Reihenfolge und Arten der SyncManager gegen 0x1C00</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>kein Speicher mehr</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>outputs count from their arrival</source>
        <translation>Ausgänge zählen ab ihrer Ankunft</translation>
    </message>
    <message>
        <source>outputs of {command} in the image</source>
        <translation>Ausgänge von {command} im Abbild</translation>
    </message>
    <message>
        <source>outputs of {slaves:# slave|# slaves} begin elsewhere in the image</source>
        <translation>die Ausgänge von {slaves:# Slave|# Slaves} beginnen anderswo im Abbild</translation>
    </message>
    <message>
        <source>own cycle</source>
        <translation>eigener Zyklus</translation>
    </message>
    <message>
        <source>own frame</source>
        <translation>eigener Frame</translation>
    </message>
    <message>
        <source>parameters incompatible</source>
        <translation>Parameter passen nicht zusammen</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>port {port} of {slave} carries another slave already</source>
        <translation>Port {port} von {slave} trägt schon einen anderen Slave</translation>
    </message>
    <message>
        <source>possible reference clock</source>
        <translation>mögliche Referenzuhr</translation>
    </message>
    <message>
        <source>power the slave off and on</source>
        <translation>den Slave aus- und einschalten</translation>
    </message>
    <message>
        <source>propagation delays measured again: 1 slave to correct, by {largest}</source>
        <translation>Laufzeiten erneut gemessen: 1 Slave zu berichtigen, um {largest}</translation>
    </message>
    <message>
        <source>propagation delays measured again: nothing to correct</source>
        <translation>Laufzeiten erneut gemessen: nichts zu berichtigen</translation>
    </message>
    <message>
        <source>propagation delays measured again: {slaves:# slave|# slaves} to correct, by {largest} at most</source>
        <translation>Laufzeiten erneut gemessen: {slaves:# Slave|# Slaves} zu berichtigen, um höchstens {largest}</translation>
    </message>
    <message>
        <source>reading a write-only object</source>
        <translation>Lesen eines Objekts, das man nur schreiben kann</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>liest</translation>
    </message>
    <message>
        <source>real time: {what}</source>
        <translation>Echtzeit: {what}</translation>
    </message>
    <message>
        <source>reference clock</source>
        <translation>Referenzuhr</translation>
    </message>
    <message>
        <source>reference clock {subject}: LOST</source>
        <translation>Referenzuhr {subject}: VERLOREN</translation>
    </message>
    <message>
        <source>reference clock {subject}: has no system time (0x0910 does not answer), the next clock leads in its place</source>
        <translation>Referenzuhr {subject}: hat keine Systemzeit (0x0910 antwortet nicht), die nächste Uhr führt an ihrer Stelle</translation>
    </message>
    <message>
        <source>reference clock {subject}: present</source>
        <translation>Referenzuhr {subject}: vorhanden</translation>
    </message>
    <message>
        <source>reference clock {subject}: took over</source>
        <translation>Referenzuhr {subject}: hat übernommen</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>weggefallen</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>resource not available</source>
        <translation>Ressource nicht verfügbar</translation>
    </message>
    <message>
        <source>retries</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>revision</source>
        <translation>Revision</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>settling behind an interruption</source>
        <translation>Einschwingen nach einer Unterbrechung</translation>
    </message>
    <message>
        <source>The reference clock is not at the external clock</source>
        <translation>Die Referenzuhr ist nicht bei der externen Uhr</translation>
    </message>
    <message>
        <source>Wait until it is there; where it never comes there, look at the network behind the bridge device.</source>
        <translation>Warten, bis sie dort ist; wenn sie nie hinkommt, das Netzwerk hinter dem Brückengerät prüfen.</translation>
    </message>
    <message>
        <source>The reference clock is {external} away from the external clock. To go there takes some {left}.</source>
        <translation>Die Referenzuhr ist {external} von der externen Uhr entfernt. Der Weg dorthin dauert etwa {left}.</translation>
    </message>
    <message>
        <source>The external clock was elsewhere for a while</source>
        <translation>Die externe Uhr war eine Zeit lang anderswo</translation>
    </message>
    <message>
        <source>Look at the network behind the bridge device: its reference clock has stepped, or another one leads there now; or this computer's clock was slewed.</source>
        <translation>Das Netzwerk hinter dem Brückengerät prüfen: Seine Referenzuhr ist gesprungen, oder dort führt jetzt eine andere; oder die Uhr dieses Rechners wurde nachgestellt.</translation>
    </message>
    <message>
        <source>The external clock was not where the reference clock is {count}, first at {since}, and up to {external} away; the reference clock has found it again.</source>
        <translation>Die externe Uhr war {count} nicht, wo die Referenzuhr ist, zuerst bei {since}, bis zu {external} entfernt; die Referenzuhr hat sie wiedergefunden.</translation>
    </message>
    <message>
        <source>the reference clock is on its way to the external clock</source>
        <translation>die Referenzuhr ist auf dem Weg zur externen Uhr</translation>
    </message>
    <message>
        <source>the external clock is not where the reference clock is</source>
        <translation>die externe Uhr ist nicht, wo die Referenzuhr ist</translation>
    </message>
    <message>
        <source>size of the inputs</source>
        <translation>Größe der Eingänge</translation>
    </message>
    <message>
        <source>size of the outputs</source>
        <translation>Größe der Ausgänge</translation>
    </message>
    <message>
        <source>slave needs INIT</source>
        <translation>Slave braucht INIT</translation>
    </message>
    <message>
        <source>slave needs PREOP</source>
        <translation>Slave braucht PREOP</translation>
    </message>
    <message>
        <source>slave needs SAFEOP</source>
        <translation>Slave braucht SAFEOP</translation>
    </message>
    <message>
        <source>slave needs cold start</source>
        <translation>Slave braucht einen Kaltstart</translation>
    </message>
    <message>
        <source>slave restarted locally</source>
        <translation>Slave hat selbst neu gestartet</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation}</source>
        <translation>Slaves NICHT SYNCHRON, Abweichung {deviation}</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation} at {subject}</source>
        <translation>Slaves NICHT SYNCHRON, Abweichung {deviation} bei {subject}</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation} at {subject} ({slaves:# slave is|# slaves are} over the limit)</source>
        <translation>Slaves NICHT SYNCHRON, Abweichung {deviation} bei {subject} ({slaves:# Slave ist|# Slaves sind} über der Grenze)</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation}: {slaves:the one that follows, at once|all # at once} and to the same side, the reference clock has stepped or changed its rate</source>
        <translation>Slaves NICHT SYNCHRON, Abweichung {deviation}: {slaves:der eine, der folgt, sofort|alle # zugleich} und zur selben Seite, die Referenzuhr ist gesprungen oder hat ihre Geschwindigkeit geändert</translation>
    </message>
    <message>
        <source>slaves in sync, deviation {deviation}</source>
        <translation>Slaves synchron, Abweichung {deviation}</translation>
    </message>
    <message>
        <source>slaves not monitored</source>
        <translation>Slaves nicht überwacht</translation>
    </message>
    <message>
        <source>slaves: not known whether in sync, nobody leads them</source>
        <translation>Slaves: nicht bekannt, ob synchron, niemand führt sie</translation>
    </message>
    <message>
        <source>slaves: not known whether in sync, nothing was read for {age}</source>
        <translation>Slaves: nicht bekannt, ob synchron, seit {age} wurde nichts gelesen</translation>
    </message>
    <message>
        <source>source address</source>
        <translation>Quelladresse</translation>
    </message>
    <message>
        <source>split into frames</source>
        <translation>Aufteilung in Frames</translation>
    </message>
    <message>
        <source>start time 0x0990 (must lie ahead), cycle 0x09A0, activation 0x0981</source>
        <translation>Startzeit 0x0990 (muss in der Zukunft liegen), Zyklus 0x09A0, Aktivierung 0x0981</translation>
    </message>
    <message>
        <source>start-up command {command}</source>
        <translation>Startkommando {command}</translation>
    </message>
    <message>
        <source>start-up commands come in another order</source>
        <translation>die Startkommandos kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>station address</source>
        <translation>Stationsadresse</translation>
    </message>
    <message>
        <source>station address {address} belongs to {slave}, too</source>
        <translation>Stationsadresse {address} gehört auch zu {slave}</translation>
    </message>
    <message>
        <source>station addresses (0x0010)</source>
        <translation>Stationsadressen (0x0010)</translation>
    </message>
    <message>
        <source>status bit {bit} belongs to {slave}, too</source>
        <translation>Statusbit {bit} gehört auch zu {slave}</translation>
    </message>
    <message>
        <source>status bit {bit} is mapped by no FMMU on IP</source>
        <translation>Statusbit {bit} wird von keiner FMMU auf IP abgebildet</translation>
    </message>
    <message>
        <source>status bit {bit} is not read by a cyclic command in PREOP</source>
        <translation>Statusbit {bit} wird von keinem zyklischen Kommando in PREOP gelesen</translation>
    </message>
    <message>
        <source>status bit {bit}, and MailboxStates counts {counted}</source>
        <translation>Statusbit {bit}, und MailboxStates zählt {counted}</translation>
    </message>
    <message>
        <source>subindex cannot be written, subindex 0 must be 0 first</source>
        <translation>Subindex nicht schreibbar, zuerst muss Subindex 0 auf 0 stehen</translation>
    </message>
    <message>
        <source>subindex does not exist</source>
        <translation>Subindex gibt es nicht</translation>
    </message>
    <message>
        <source>supply and attached hardware of the device</source>
        <translation>Versorgung und angeschlossene Hardware des Geräts</translation>
    </message>
    <message>
        <source>supply voltage too high</source>
        <translation>Versorgungsspannung zu hoch</translation>
    </message>
    <message>
        <source>supply voltage too low</source>
        <translation>Versorgungsspannung zu niedrig</translation>
    </message>
    <message>
        <source>synchronization error</source>
        <translation>Synchronisationsfehler</translation>
    </message>
    <message>
        <source>synchronization not supported</source>
        <translation>Synchronisation nicht unterstützt</translation>
    </message>
    <message>
        <source>task {task}: commands come in another order</source>
        <translation>Task {task}: die Kommandos kommen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>task {task}: cycle time</source>
        <translation>Task {task}: Zykluszeit</translation>
    </message>
    <message>
        <source>task {task}: split into frames</source>
        <translation>Task {task}: Aufteilung in Frames</translation>
    </message>
    <message>
        <source>task {task}: {command}</source>
        <translation>Task {task}: {command}</translation>
    </message>
    <message>
        <source>temperature too high</source>
        <translation>Temperatur zu hoch</translation>
    </message>
    <message>
        <source>temperature too low</source>
        <translation>Temperatur zu niedrig</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>that DC is on or SM synchronous mode is chosen (0x1C32:01)</source>
        <translation>ob DC an ist oder die SM-synchrone Art gewählt ist (0x1C32:01)</translation>
    </message>
    <message>
        <source>that SYNC pulses and frames come in time</source>
        <translation>ob SYNC-Pulse und Frames rechtzeitig kommen</translation>
    </message>
    <message>
        <source>that cyclic frames run with the right working counter before OP is requested</source>
        <translation>ob zyklische Frames mit richtigem Working Counter laufen, bevor OP angefordert wird</translation>
    </message>
    <message>
        <source>that operation mode, PDOs and DC settings fit together</source>
        <translation>ob Betriebsart, PDOs und DC-Einstellungen zusammenpassen</translation>
    </message>
    <message>
        <source>that the EEPROM is given to the PDI before PREOP (0x0500)</source>
        <translation>ob das EEPROM vor PREOP dem PDI übergeben wird (0x0500)</translation>
    </message>
    <message>
        <source>that the PDOs in 0x1C12 add up to the length of SM2</source>
        <translation>ob die PDOs in 0x1C12 zusammen die Länge von SM2 ergeben</translation>
    </message>
    <message>
        <source>that the PDOs in 0x1C13 add up to the length of SM3</source>
        <translation>ob die PDOs in 0x1C13 zusammen die Länge von SM3 ergeben</translation>
    </message>
    <message>
        <source>that the cycle is a multiple the device supports (e.g. 125 or 250 us)</source>
        <translation>ob der Zyklus ein Vielfaches ist, das das Gerät unterstützt (etwa 125 oder 250 us)</translation>
    </message>
    <message>
        <source>the CoE start-up commands</source>
        <translation>die CoE-Startkommandos</translation>
    </message>
    <message>
        <source>the PDOs of SM{manager} have {bytes:# byte|# bytes}, it takes {least} to {most}</source>
        <translation>die PDOs von SM{manager} haben {bytes:# Byte|# Bytes}, er nimmt {least} bis {most}</translation>
    </message>
    <message>
        <source>the SYNC0 cycle of {sync0} and the task's cycle of {cycle} are no multiples of each other</source>
        <translation>der SYNC0-Zyklus von {sync0} und der Zyklus der Task von {cycle} sind keine Vielfachen voneinander</translation>
    </message>
    <message>
        <source>the SoE start-up commands</source>
        <translation>die SoE-Startkommandos</translation>
    </message>
    <message>
        <source>the ambient temperature</source>
        <translation>die Umgebungstemperatur</translation>
    </message>
    <message>
        <source>the bring-up begins again from INIT: no slave could be reached in the middle of it</source>
        <translation>der Hochlauf beginnt noch einmal bei INIT: mittendrin war kein Slave erreichbar</translation>
    </message>
    <message>
        <source>the change of state may take {timeout} ms</source>
        <translation>der Zustandswechsel darf {timeout} ms dauern</translation>
    </message>
    <message>
        <source>the control byte {control} does not make SM{manager} a mailbox for {use}</source>
        <translation>das Steuerbyte {control} macht SM{manager} nicht zu einer Mailbox für {use}</translation>
    </message>
    <message>
        <source>the control byte {control} of SM{manager} makes it {kind}, its Type says {type}</source>
        <translation>das Steuerbyte {control} von SM{manager} macht ihn zu {kind}, sein Type sagt {type}</translation>
    </message>
    <message>
        <source>the control bytes of SM2 and SM3</source>
        <translation>die Steuerbytes von SM2 und SM3</translation>
    </message>
    <message>
        <source>the controller reports an error</source>
        <translation>der Regler meldet einen Fehler</translation>
    </message>
    <message>
        <source>the device's AoE service</source>
        <translation>der AoE-Dienst des Geräts</translation>
    </message>
    <message>
        <source>the device's EoE settings (IP address)</source>
        <translation>die EoE-Einstellungen des Geräts (IP-Adresse)</translation>
    </message>
    <message>
        <source>the device's program failed</source>
        <translation>das Programm des Geräts schlug fehl</translation>
    </message>
    <message>
        <source>the file exists already</source>
        <translation>die Datei gibt es schon</translation>
    </message>
    <message>
        <source>the file transfer</source>
        <translation>die Dateiübertragung</translation>
    </message>
    <message>
        <source>the firmware file, then repeat the update</source>
        <translation>die Firmware-Datei, dann die Aktualisierung wiederholen</translation>
    </message>
    <message>
        <source>the firmware; load it in BOOT</source>
        <translation>die Firmware; sie in BOOT laden</translation>
    </message>
    <message>
        <source>frames were held up on their way</source>
        <translation>Frames wurden unterwegs aufgehalten</translation>
    </message>
    <message>
        <source>the host left cycles out</source>
        <translation>der Rechner ließ Zyklen aus</translation>
    </message>
    <message>
        <source>the identification value, then restart the slave</source>
        <translation>der Identifikationswert, dann den Slave neu starten</translation>
    </message>
    <message>
        <source>the load of the slave's processor; a longer cycle helps</source>
        <translation>die Last des Prozessors im Slave; ein längerer Zyklus hilft</translation>
    </message>
    <message>
        <source>the reference clock has stepped</source>
        <translation>die Referenzuhr ist gesprungen</translation>
    </message>
    <message>
        <source>the reference clock is addressed by its station address (FRMW)</source>
        <translation>die Referenzuhr wird mit ihrer Stationsadresse angesprochen (FRMW)</translation>
    </message>
    <message>
        <source>the reference clock's time does not come</source>
        <translation>die Zeit der Referenzuhr kommt nicht</translation>
    </message>
    <message>
        <source>the root element is {element}</source>
        <translation>das Wurzelelement ist {element}</translation>
    </message>
    <message>
        <source>the schedule is not within its limit</source>
        <translation>der Fahrplan ist nicht innerhalb seiner Grenze</translation>
    </message>
    <message>
        <source>the smallest cycle in 0x1C32:05</source>
        <translation>der kleinste Zyklus in 0x1C32:05</translation>
    </message>
    <message>
        <source>the station address is 0</source>
        <translation>die Stationsadresse ist 0</translation>
    </message>
    <message>
        <source>the supply</source>
        <translation>die Versorgung</translation>
    </message>
    <message>
        <source>the value written to AL control 0x0120</source>
        <translation>der nach AL Control 0x0120 geschriebene Wert</translation>
    </message>
    <message>
        <source>the vendor protocol</source>
        <translation>das Protokoll des Herstellers</translation>
    </message>
    <message>
        <source>the vendor's diagnosis, object 0x10F3 and the device's display</source>
        <translation>die Diagnose des Herstellers, Objekt 0x10F3 und die Anzeige des Geräts</translation>
    </message>
    <message>
        <source>the vendor's licence for this function</source>
        <translation>die Lizenz des Herstellers für diese Funktion</translation>
    </message>
    <message>
        <source>the vendor's manual</source>
        <translation>das Handbuch des Herstellers</translation>
    </message>
    <message>
        <source>there are {protocol} start-up commands, and no Protocol says {protocol}</source>
        <translation>es gibt {protocol}-Startkommandos, und kein Protocol sagt {protocol}</translation>
    </message>
    <message>
        <source>there is no CycleTime</source>
        <translation>es gibt keine CycleTime</translation>
    </message>
    <message>
        <source>time-out</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>time-out back to INIT</source>
        <translation>Zeitgrenze zurück nach INIT</translation>
    </message>
    <message>
        <source>time-out back to SAFEOP</source>
        <translation>Zeitgrenze zurück nach SAFEOP</translation>
    </message>
    <message>
        <source>time-out to PREOP</source>
        <translation>Zeitgrenze nach PREOP</translation>
    </message>
    <message>
        <source>time-out to SAFEOP and OP</source>
        <translation>Zeitgrenze nach SAFEOP und OP</translation>
    </message>
    <message>
        <source>toggle bit did not change</source>
        <translation>das Toggle-Bit hat nicht gewechselt</translation>
    </message>
    <message>
        <source>two variables have the name "{variable}"</source>
        <translation>zwei Variablen haben den Namen "{variable}"</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>unknown abort code</source>
        <translation>unbekannter Abbruchcode</translation>
    </message>
    <message>
        <source>unknown code</source>
        <translation>unbekannter Code</translation>
    </message>
    <message>
        <source>unknown device at position {position}: {identity}</source>
        <translation>unbekanntes Gerät an Position {position}: {identity}</translation>
    </message>
    <message>
        <source>unknown error of the device</source>
        <translation>unbekannter Fehler des Geräts</translation>
    </message>
    <message>
        <source>unknown requested state</source>
        <translation>unbekannter Zustand angefordert</translation>
    </message>
    <message>
        <source>unspecified error</source>
        <translation>nicht näher bestimmter Fehler</translation>
    </message>
    <message>
        <source>up to 4 of the letters Y, K and B</source>
        <translation>bis zu 4 der Buchstaben Y, K und B</translation>
    </message>
    <message>
        <source>value out of range</source>
        <translation>Wert außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>value too high</source>
        <translation>Wert zu groß</translation>
    </message>
    <message>
        <source>value too low</source>
        <translation>Wert zu klein</translation>
    </message>
    <message>
        <source>variables of the inputs</source>
        <translation>Variablen der Eingänge</translation>
    </message>
    <message>
        <source>variables of the outputs</source>
        <translation>Variablen der Ausgänge</translation>
    </message>
    <message>
        <source>vendor specific code</source>
        <translation>herstellerspezifischer Code</translation>
    </message>
    <message>
        <source>ventilation and ambient temperature</source>
        <translation>Lüftung und Umgebungstemperatur</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>what the device needs for valid inputs (supply, encoder)</source>
        <translation>was das Gerät für gültige Eingänge braucht (Versorgung, Geber)</translation>
    </message>
    <message>
        <source>whether PDOs and SyncManager lengths exceed what the slave can hold</source>
        <translation>ob PDOs und SyncManager-Längen mehr sind, als der Slave fasst</translation>
    </message>
    <message>
        <source>whether a state was skipped, e.g. INIT to SAFEOP</source>
        <translation>ob ein Zustand übersprungen wurde, etwa INIT nach SAFEOP</translation>
    </message>
    <message>
        <source>whether every object in the RxPDOs can be mapped</source>
        <translation>ob sich jedes Objekt in den RxPDOs mappen lässt</translation>
    </message>
    <message>
        <source>whether every object in the TxPDOs can be mapped</source>
        <translation>ob sich jedes Objekt in den TxPDOs mappen lässt</translation>
    </message>
    <message>
        <source>whether the EEPROM belongs to this firmware; rewrite one of them</source>
        <translation>ob das EEPROM zu dieser Firmware gehört; eins davon neu schreiben</translation>
    </message>
    <message>
        <source>whether the ESI revision fits the device's hardware and firmware</source>
        <translation>ob die ESI-Revision zu Hardware und Firmware des Geräts passt</translation>
    </message>
    <message>
        <source>whether this device has a BOOT state</source>
        <translation>ob dieses Gerät einen Zustand BOOT hat</translation>
    </message>
    <message>
        <source>who owns the latch units (AssignActivate bits 4 and 5)</source>
        <translation>wem die Latch-Einheiten gehören (AssignActivate Bits 4 und 5)</translation>
    </message>
    <message>
        <source>why SYNC0 or SYNC1 stopped; clear 0x0981 before a new start</source>
        <translation>warum SYNC0 oder SYNC1 ausblieb; vor einem neuen Start 0x0981 löschen</translation>
    </message>
    <message>
        <source>why outputs stopped for longer than the watchdog 0x0420 (loop, working counter)</source>
        <translation>warum Ausgänge länger ausblieben als der Watchdog 0x0420 (Schleife, Working Counter)</translation>
    </message>
    <message>
        <source>why the device restarted (supply, watchdog, operator)</source>
        <translation>warum das Gerät neu gestartet hat (Versorgung, Watchdog, Bediener)</translation>
    </message>
    <message>
        <source>working counter</source>
        <translation>Working Counter</translation>
    </message>
    <message>
        <source>working counter expected now {now} (all slaves: {configured})</source>
        <translation>erwarteter Working Counter jetzt {now} (alle Slaves: {configured})</translation>
    </message>
    <message>
        <source>working counter {received} instead of {expected}</source>
        <translation>Working Counter {received} statt {expected}</translation>
    </message>
    <message>
        <source>working counter {received} instead of {expected} ({count:# time|# times})</source>
        <translation>Working Counter {received} statt {expected} ({count:einmal|#-mal})</translation>
    </message>
    <message>
        <source>writes</source>
        <translation>schreibt</translation>
    </message>
    <message>
        <source>writing a read-only object</source>
        <translation>Schreiben eines Objekts, das man nur lesen kann</translation>
    </message>
    <message>
        <source>wrong packet number</source>
        <translation>falsche Paketnummer</translation>
    </message>
    <message>
        <source>{activation} switches SYNC1 on without SYNC0</source>
        <translation>{activation} schaltet SYNC1 ohne SYNC0 ein</translation>
    </message>
    <message>
        <source>{bits:# bit is|# bits are} copied from input bit {from} to output bit {to}, the image has {inputs} and {outputs}</source>
        <translation>{bits:# Bit wird|# Bits werden} von Eingangsbit {from} nach Ausgangsbit {to} kopiert, das Abbild hat {inputs} und {outputs}</translation>
    </message>
    <message>
        <source>{bytes:# byte exceeds|# bytes exceed} the {most} that SyncManager {manager} takes.</source>
        <translation>{bytes:# Byte ist|# Bytes sind} mehr als die {most}, die SyncManager {manager} annimmt.</translation>
    </message>
    <message>
        <source>{bytes:# byte of process data does|# bytes of process data do} not fit into one Ethernet frame.</source>
        <translation>{bytes:# Byte Prozessdaten passt|# Bytes Prozessdaten passen} nicht in einen Ethernet-Frame.</translation>
    </message>
    <message>
        <source>{command}</source>
        <translation>{command}</translation>
    </message>
    <message>
        <source>{command} addresses no slave of the file</source>
        <translation>{command} spricht keinen Slave der Datei an</translation>
    </message>
    <message>
        <source>{command} comes before the station address is set (0x0010)</source>
        <translation>{command} kommt, bevor die Stationsadresse gesetzt ist (0x0010)</translation>
    </message>
    <message>
        <source>{command} compares what it reads with a time-out of 0</source>
        <translation>{command} vergleicht, was es liest, mit einer Zeitgrenze von 0</translation>
    </message>
    <message>
        <source>{command} does not go to this slave (auto-increment address {address})</source>
        <translation>{command} geht nicht an diesen Slave (Auto-Increment-Adresse {address})</translation>
    </message>
    <message>
        <source>{command} does not go to this slave (station address {address})</source>
        <translation>{command} geht nicht an diesen Slave (Stationsadresse {address})</translation>
    </message>
    <message>
        <source>{command} goes to all slaves</source>
        <translation>{command} geht an alle Slaves</translation>
    </message>
    <message>
        <source>{command} goes to logical addresses, which are those of the process data</source>
        <translation>{command} geht an logische Adressen, die der Prozessdaten</translation>
    </message>
    <message>
        <source>{command} has no Cnt; the FMMUs make it {computed}</source>
        <translation>{command} hat kein Cnt; nach den FMMUs ist es {computed}</translation>
    </message>
    <message>
        <source>{command} has no bytes</source>
        <translation>{command} hat keine Bytes</translation>
    </message>
    <message>
        <source>{command} has {bytes:# byte|# bytes} instead of 4</source>
        <translation>{command} hat {bytes:# Byte|# Bytes} statt 4</translation>
    </message>
    <message>
        <source>{command} has {bytes:# byte|# bytes} instead of 4 or 8</source>
        <translation>{command} hat {bytes:# Byte|# Bytes} statt 4 oder 8</translation>
    </message>
    <message>
        <source>{command} is not sent in {state}</source>
        <translation>{command} wird in {state} nicht gesendet</translation>
    </message>
    <message>
        <source>{command} reads nothing that Validate could be compared with</source>
        <translation>{command} liest nichts, womit Validate verglichen werden könnte</translation>
    </message>
    <message>
        <source>{command} stands before {distributor}</source>
        <translation>{command} steht vor {distributor}</translation>
    </message>
    <message>
        <source>{command} steers a clock whose time nothing distributes</source>
        <translation>{command} stellt eine Uhr, deren Zeit nichts verteilt</translation>
    </message>
    <message>
        <source>{command} steers {slave}, {distributor} distributes the time of another</source>
        <translation>{command} stellt {slave}, {distributor} verteilt die Zeit eines anderen</translation>
    </message>
    <message>
        <source>{command} takes the time of {slave}, and no slave is marked as reference clock</source>
        <translation>{command} nimmt die Zeit von {slave}, und kein Slave ist als Referenzuhr gekennzeichnet</translation>
    </message>
    <message>
        <source>{command} takes the time of {slave}, the reference clock is {reference}</source>
        <translation>{command} nimmt die Zeit von {slave}, die Referenzuhr ist {reference}</translation>
    </message>
    <message>
        <source>{command}: a master can only read the register {register}</source>
        <translation>{command}: ein Master kann das Register {register} nur lesen</translation>
    </message>
    <message>
        <source>{command}: no ESC has a register there</source>
        <translation>{command}: dort hat kein ESC ein Register</translation>
    </message>
    <message>
        <source>{copies:# slave-to-slave copy|# slave-to-slave copies} cannot be kept: a project has no place for that.</source>
        <translation>{copies:# Kopie von Slave zu Slave lässt|# Kopien von Slave zu Slave lassen} sich nicht behalten: ein Projekt hat keinen Platz dafür.</translation>
    </message>
    <message>
        <source>{count:# FMMU lies|# FMMUs lie} elsewhere</source>
        <translation>{count:# FMMU liegt|# FMMUs liegen} anderswo</translation>
    </message>
    <message>
        <source>{count:# command's inputs|# commands' inputs} lie elsewhere</source>
        <translation>Eingänge von {count:# Kommando|# Kommandos} liegen anderswo</translation>
    </message>
    <message>
        <source>{count:# command's outputs|# commands' outputs} lie elsewhere</source>
        <translation>Ausgänge von {count:# Kommando|# Kommandos} liegen anderswo</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter ({received} instead of {expected} last), from {since} on.</source>
        <translation>{count:# Zyklus hatte|# Zyklen hatten} einen falschen Working Counter (zuletzt {received} statt {expected}), ab {since}.</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter, from {since} on: that is what the others see of {slave}.</source>
        <translation>{count:# Zyklus hatte|# Zyklen hatten} einen falschen Working Counter, ab {since}: das ist, was man von {slave} sonst sieht.</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} left out, the host sent nothing for up to {standstill}</source>
        <translation>{count:# Zyklus|# Zyklen} ausgelassen, der Host sendete bis zu {standstill} lang nichts</translation>
    </message>
    <message>
        <source>{count:# event was|# events were} lost</source>
        <translation>{count:# Ereignis ging|# Ereignisse gingen} verloren</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} back late, up to {late} after the deadline</source>
        <translation>{count:# Frame kam|# Frames kamen} zu spät zurück, bis zu {late} nach der Frist</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} back late, up to {late} after the deadline ({told} of them told as lost before)</source>
        <translation>{count:# Frame kam|# Frames kamen} zu spät zurück, bis zu {late} nach der Frist ({told:# davon war|# davon waren} als verloren gemeldet)</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} came back after the cycle, by up to {largest}.</source>
        <translation>{count:# Frame kam|# Frames kamen} nach dem Zyklus zurück, um bis zu {largest}.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and no slave counted an error at its ports.</source>
        <translation>{count:# Frame kam|# Frames kamen} nicht zurück (bis zu {most} nah beieinander, zuerst bei {since}), und kein Slave zählte einen Fehler an seinen Ports.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}); damaged on the way, first at {slave} port {port}.</source>
        <translation>{count:# Frame kam|# Frames kamen} nicht zurück (bis zu {most} nah beieinander, zuerst bei {since}); unterwegs beschädigt, zuerst an {slave} Port {port}.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back in time while the host stood still.</source>
        <translation>{count:# Frame kam|# Frames kamen} nicht rechtzeitig zurück, während der Rechner stillstand.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} lost</source>
        <translation>{count:# Frame|# Frames} verloren</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} reached {slave} damaged at port {port} (0x{register}), from {since} on; the cable comes from {behind}.</source>
        <translation>{count:# Frame erreichte|# Frames erreichten} {slave} beschädigt an Port {port} (0x{register}), ab {since}; das Kabel kommt von {behind}.</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} lost when {slave} went away or came back.</source>
        <translation>{count:# Frame ging|# Frames gingen} verloren, als {slave} ging oder wiederkam.</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} lost when {slave} lost its link.</source>
        <translation>{count:# Frame ging|# Frames gingen} verloren, als {slave} den Link verlor.</translation>
    </message>
    <message>
        <source>Frames were lost at the end</source>
        <translation>Am Ende gingen Frames verloren</translation>
    </message>
    <message>
        <source>Let it run on: the error counters of the slaves' ports say where they are lost.</source>
        <translation>Weiterlaufen lassen: Die Fehlerzähler der Ports der Slaves sagen, wo sie verloren gehen.</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back at the end (first at {since}), and not all slaves' error counters have been read since.</source>
        <translation>{count:# Frame kam|# Frames kamen} am Ende nicht zurück (zuerst bei {since}), und seither wurden nicht die Fehlerzähler aller Slaves gelesen.</translation>
    </message>
    <message>
        <source>{count:# variable has another data type|# variables have other data types}</source>
        <translation>{count:# Variable hat einen anderen Datentyp|# Variablen haben andere Datentypen}</translation>
    </message>
    <message>
        <source>{count:# variable has another name|# variables have other names}</source>
        <translation>{count:# Variable hat einen anderen Namen|# Variablen haben andere Namen}</translation>
    </message>
    <message>
        <source>{count:# variable of the inputs lies|# variables of the inputs lie} elsewhere</source>
        <translation>{count:# Variable der Eingänge liegt|# Variablen der Eingänge liegen} anderswo</translation>
    </message>
    <message>
        <source>{count:# variable of the outputs lies|# variables of the outputs lie} elsewhere</source>
        <translation>{count:# Variable der Ausgänge liegt|# Variablen der Ausgänge liegen} anderswo</translation>
    </message>
    <message>
        <source>{count:# variable|# variables}, "{variable}" among them, {count:lies|lie} behind the image</source>
        <translation>{count:# Variable|# Variablen}, darunter "{variable}", {count:liegt|liegen} hinter dem Abbild</translation>
    </message>
    <message>
        <source>{count:# variable|# variables}, "{variable}" among them, {count:shares|share} bits with others</source>
        <translation>{count:# Variable|# Variablen}, darunter "{variable}", {count:teilt|teilen} sich Bits mit anderen</translation>
    </message>
    <message>
        <source>{element} has {bits:# bit|# bits}, the assigned PDOs have {expected}</source>
        <translation>{element} hat {bits:# Bit|# Bits}, die zugeordneten PDOs haben {expected}</translation>
    </message>
    <message>
        <source>{element} has {bytes:# byte|# bytes} at {start}</source>
        <translation>{element} hat {bytes:# Byte|# Bytes} bei {start}</translation>
    </message>
    <message>
        <source>{element} shares bits of the image with {slave}</source>
        <translation>{element} teilt sich Bits des Abbilds mit {slave}</translation>
    </message>
    <message>
        <source>{element} starts at bit {said}, the FMMUs and cyclic commands put the data at bit {computed}</source>
        <translation>{element} beginnt bei Bit {said}, FMMUs und zyklische Kommandos legen die Daten nach Bit {computed}</translation>
    </message>
    <message>
        <source>{element} takes {bits:# bit|# bits} from bit {first}, the image has {image}</source>
        <translation>{element} belegt {bits:# Bit|# Bits} ab Bit {first}, das Abbild hat {image}</translation>
    </message>
    <message>
        <source>{entries:# entry is|# entries are} mapped; the device's dictionary has room for {room} in {object}.</source>
        <translation>{entries:# Eintrag ist|# Einträge sind} gemappt; das Objektverzeichnis des Geräts hat in {object} Platz für {room}.</translation>
    </message>
    <message>
        <source>{entries:# entry is|# entries are} mapped; the object {object} takes {most}.</source>
        <translation>{entries:# Eintrag ist|# Einträge sind} gemappt; das Objekt {object} nimmt {most}.</translation>
    </message>
    <message>
        <source>{error}</source>
        <translation>{error}</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>{field} is {said} in Info, the command expects the bytes {expected}</source>
        <translation>{field} ist in Info {said}, das Kommando erwartet die Bytes {expected}</translation>
    </message>
    <message>
        <source>{file} is an ENI: its commands and the layout of its image stay as they are, only the spelling follows the dialect. "project create --eni" makes a project that can be laid out anew.</source>
        <translation>{file} ist eine ENI: ihre Kommandos und die Anordnung ihres Abbilds bleiben, nur die Schreibweise folgt dem Dialekt. "project create --eni" macht ein Projekt, das neu angeordnet werden kann.</translation>
    </message>
    <message>
        <source>{file}: what came after frame {frames} was not read, the file breaks off there ({reason}).</source>
        <translation>{file}: Was nach Frame {frames} kam, wurde nicht gelesen, die Datei bricht dort ab ({reason}).</translation>
    </message>
    <message>
        <source>{file}: {cut} of its {frames:# frame|# frames} {cut:was|were} captured in part only and not read.</source>
        <translation>{file}: {cut} {frames:seines # Frames|seiner # Frames} {cut:wurde|wurden} nur zum Teil aufgezeichnet und nicht gelesen.</translation>
    </message>
    <message>
        <source>{first} and {second} are both the reference clock</source>
        <translation>{first} und {second} sind beide die Referenzuhr</translation>
    </message>
    <message>
        <source>{first} and {second} carry the same {data}</source>
        <translation>{first} und {second} tragen dieselben {data}</translation>
    </message>
    <message>
        <source>{frames:# frame takes|# frames take} {wire} on the wire and about {travel} through {slaves:# slave|# slaves}, the cycle is {cycle}</source>
        <translation>{frames:# Frame braucht|# Frames brauchen} auf der Leitung {wire} und durch {slaves:# Slave|# Slaves} etwa {travel}, der Zyklus ist {cycle}</translation>
    </message>
    <message>
        <source>{frames:# frame takes|# frames take} {wire} on the wire, the cycle is {cycle}</source>
        <translation>{frames:# Frame braucht|# Frames brauchen} auf der Leitung {wire}, der Zyklus ist {cycle}</translation>
    </message>
    <message>
        <source>{mode} switches SYNC0 on, its cycle is {cycle}.</source>
        <translation>{mode} schaltet SYNC0 ein, sein Zyklus ist {cycle}.</translation>
    </message>
    <message>
        <source>{mode} writes the reference clock in each cycle, but the cyclic frames have no command for it (APWR or FPWR of 0x0910); choose off, master-shift or master-shift-by-app.</source>
        <translation>{mode} schreibt die Referenzuhr in jedem Zyklus, aber die zyklischen Frames haben kein Kommando dafür (APWR oder FPWR von 0x0910); off, master-shift oder master-shift-by-app wählen.</translation>
    </message>
    <message>
        <source>{name} has no distributed clock according to its ESI and cannot be the reference.</source>
        <translation>{name} hat nach seiner ESI keine verteilte Uhr und kann nicht die Referenz sein.</translation>
    </message>
    <message>
        <source>{name} stands before the reference clock: the frame passes it without the time. A run here tells it what the master believes, so it follows less exactly; other masters leave it off.</source>
        <translation>{name} steht vor der Referenzuhr: Der Frame passiert ihn ohne die Zeit. Ein Lauf hier sagt ihm, was der Master annimmt, also folgt er weniger genau; bei anderen Mastern bleibt er daneben.</translation>
    </message>
    <message>
        <source>{name}: a SYNC0 cycle of {sync0} is neither a multiple nor a divisor of the bus cycle of {cycle}.</source>
        <translation>{name}: ein SYNC0-Zyklus von {sync0} ist weder ein Vielfaches noch ein Teiler des Buszyklus von {cycle}.</translation>
    </message>
    <message>
        <source>{objects:# object is|# objects are} mapped in this direction, {family} {devices} take {most}. Unassign a PDO, or map fewer objects and exchange the slow ones by SDO.</source>
        <translation>In dieser Richtung {objects:ist # Objekt|sind # Objekte} gemappt, {family} {devices} nehmen {most}. Ein PDO wegnehmen, oder weniger Objekte mappen und die langsamen per SDO austauschen.</translation>
    </message>
    <message>
        <source>{object} has no Data</source>
        <translation>{object} hat keine Data</translation>
    </message>
    <message>
        <source>{object} has no sub-index {sub_index}</source>
        <translation>{object} hat keinen Subindex {sub_index}</translation>
    </message>
    <message>
        <source>{object} is set to {mode}, and SYNC0 is off. {reason}. Select an operation mode with DC, or a profile mode.</source>
        <translation>{object} wird auf {mode} gesetzt, und SYNC0 ist aus. {reason}. Eine Betriebsart mit DC oder eine Profil-Betriebsart wählen.</translation>
    </message>
    <message>
        <source>{object} is set to {written}, SM{manager} lists {listed}</source>
        <translation>{object} wird auf {written} gesetzt, SM{manager} führt {listed} auf</translation>
    </message>
    <message>
        <source>{object} is set to {written}, the PDO lists {listed}</source>
        <translation>{object} wird auf {written} gesetzt, das PDO führt {listed} auf</translation>
    </message>
    <message>
        <source>{object} is set to {written}, the cycle is {cycle}</source>
        <translation>{object} wird auf {written} gesetzt, der Zyklus ist {cycle}</translation>
    </message>
    <message>
        <source>{object} is written by complete access</source>
        <translation>{object} wird mit Complete Access geschrieben</translation>
    </message>
    <message>
        <source>{object} is written on {transition}</source>
        <translation>{object} wird auf {transition} geschrieben</translation>
    </message>
    <message>
        <source>{object} may take {timeout} ms</source>
        <translation>{object} darf {timeout} ms dauern</translation>
    </message>
    <message>
        <source>{object} must stay in PDO {pdo} (ESI Entry@Fixed).</source>
        <translation>{object} muss im PDO {pdo} bleiben (ESI Entry@Fixed).</translation>
    </message>
    <message>
        <source>{object}: Ccs is {ccs}</source>
        <translation>{object}: Ccs ist {ccs}</translation>
    </message>
    <message>
        <source>{object}: the count is set to {count}, entries are written up to {last}</source>
        <translation>{object}: die Anzahl wird auf {count} gesetzt, Einträge werden bis {last} geschrieben</translation>
    </message>
    <message>
        <source>{object}: {entries:# entry is|# entries are} written, the count stays {count}</source>
        <translation>{object}: {entries:# Eintrag wird|# Einträge werden} geschrieben, die Anzahl bleibt {count}</translation>
    </message>
    <message>
        <source>{object}:01 asks for SYNC signals, and they are off. Select an operation mode with DC, or free run.</source>
        <translation>{object}:01 verlangt SYNC-Signale, und sie sind aus. Eine Betriebsart mit DC oder Freilauf wählen.</translation>
    </message>
    <message>
        <source>{object}:01 is read-only in {family} {devices}: the download ends the start-up. The SYNC signals set the type; remove the command.</source>
        <translation>{object}:01 ist bei {family} {devices} nur lesbar: der Download beendet den Anlauf. Die SYNC-Signale setzen die Art; das Kommando entfernen.</translation>
    </message>
    <message>
        <source>{object}:01 is set to {type}, which {family} {devices} do not have.</source>
        <translation>{object}:01 wird auf {type} gesetzt, was {family} {devices} nicht haben.</translation>
    </message>
    <message>
        <source>{object}:{sub_index} is written while the list is not emptied (:0 = 0)</source>
        <translation>{object}:{sub_index} wird geschrieben, während die Liste nicht geleert ist (:0 = 0)</translation>
    </message>
    <message>
        <source>{object}:{sub_index} is written with {written:# byte|# bytes}, it has {bytes}</source>
        <translation>{object}:{sub_index} wird mit {written:# Byte|# Bytes} geschrieben, es hat {bytes}</translation>
    </message>
    <message>
        <source>{pdos:# PDO is|# PDOs are} assigned to SyncManager {manager}; its object takes {most}.</source>
        <translation>{pdos:# PDO ist|# PDOs sind} SyncManager {manager} zugeordnet; sein Objekt nimmt {most}.</translation>
    </message>
    <message>
        <source>{reason}.</source>
        <translation>{reason}.</translation>
    </message>
    <message>
        <source>{set_value} is outside {least}..{most}: the cyclic frames are still on their way at SYNC0.</source>
        <translation>{set_value} liegt außerhalb von {least}..{most}: die zyklischen Frames sind bei SYNC0 noch unterwegs.</translation>
    </message>
    <message>
        <source>{setting}</source>
        <translation>{setting}</translation>
    </message>
    <message>
        <source>{slaves:# slave uses|# slaves use} distributed clocks</source>
        <translation>{slaves:# Slave benutzt|# Slaves benutzen} verteilte Uhren</translation>
    </message>
    <message>
        <source>{slaves:# slave uses|# slaves use} distributed clocks, and no cyclic command distributes the time</source>
        <translation>{slaves:# Slave benutzt|# Slaves benutzen} verteilte Uhren, und kein zyklisches Kommando verteilt die Zeit</translation>
    </message>
    <message>
        <source>{slave} ({identity}) has no system time register 0x0910, where its ESI has operation modes: DC is off.</source>
        <translation>{slave} ({identity}) hat kein Systemzeit-Register 0x0910, seine ESI aber Betriebsarten: DC ist aus.</translation>
    </message>
    <message>
        <source>{slave} ({identity}): {match} ({file}).</source>
        <translation>{slave} ({identity}): {match} ({file}).</translation>
    </message>
    <message>
        <source>{slave} counts {missed:# missed SM2 event|# missed SM2 events} (0x1C32:{sub}), and for {part} of them the master saw good cycles.</source>
        <translation>{slave} zählt {missed:# fehlendes SM2-Ereignis|# fehlende SM2-Ereignisse} (0x1C32:{sub}), und bei {part} davon sah der Master gute Zyklen.</translation>
    </message>
    <message>
        <source>{slave} did not finish {count:# cycle|# cycles} before the next frame came ({object} cycle exceeded), last at {last}: frames came less than a cycle one behind the other.</source>
        <translation>{slave} wurde mit {count:# Zyklus|# Zyklen} nicht fertig, bevor der nächste Frame kam ({object} Cycle exceeded), zuletzt bei {last}: Frames kamen in weniger als einem Zyklus hintereinander.</translation>
    </message>
    <message>
        <source>{slave} does not renew its inputs in every cycle, as it did before: from {since} on, {count} (0x0805 + 8 n of its input SyncManager names the same buffer again).</source>
        <translation>{slave} erneuert seine Eingänge nicht mehr in jedem Zyklus wie zuvor: ab {since}, {count} (0x0805 + 8 n seines Eingangs-SyncManagers nennt wieder denselben Puffer).</translation>
    </message>
    <message>
        <source>{slave} does not take its outputs in every cycle, as it did before: from {since} on, {count} (0x0220 names its output SyncManager when the next ones come).</source>
        <translation>{slave} nimmt seine Ausgänge nicht mehr in jedem Zyklus wie zuvor: ab {since}, {count} (0x0220 nennt seinen Ausgangs-SyncManager noch, wenn die nächsten kommen).</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}, and the master saw nothing but good cycles before: no frame lost or late, none left out, outputs nominally there {margin} before each SYNC0.</source>
        <translation>{slave} fiel bei {since} nach {state} mit AL-Statuscode {alcode}{alarm}, und der Master sah vorher nur gute Zyklen: kein Frame verloren oder verspätet, keiner ausgelassen, Ausgänge nominell {margin} vor jedem SYNC0.</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed:# SM2 event|# SM2 events}, its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} fiel bei {since} nach {state} mit AL-Statuscode {alcode}{alarm}: {missed:# SM2-Ereignis fehlte|# SM2-Ereignisse fehlten}, der Fehlerzähler erreichte {integrator} von {limit}.</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed:# SM2 event|# SM2 events}, {part} of them because frames came behind the SYNC0 they were meant for. Nominally they are there {margin} before it, but one in a thousand is {lateness} late.</source>
        <translation>{slave} fiel bei {since} nach {state} mit AL-Statuscode {alcode}{alarm}: {missed:# SM2-Ereignis fehlte|# SM2-Ereignisse fehlten}, davon {part}, weil Frames nach dem SYNC0 kamen, für das sie gedacht waren. Nominell sind sie {margin} davor da, doch einer von tausend kommt {lateness} zu spät.</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), because frames were held up on their way, by up to {largest}.</source>
        <translation>{slave} bekam seine Ausgänge {count} zu spät für SYNC0 (0x1C32:0D Shift too short), weil Frames unterwegs aufgehalten wurden, um bis zu {largest}.</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and used those of the cycle before: they come {margin} before SYNC0, and it needs {need}.</source>
        <translation>{slave} bekam seine Ausgänge {count} zu spät für SYNC0 (0x1C32:0D Shift too short) und nahm die des Zyklus davor: sie kommen {margin} vor SYNC0, und er braucht {need}.</translation>
    </message>
    <message>
        <source>{slave} had its inputs too late {count} (0x1C33:0D shift too short).</source>
        <translation>{slave} hatte seine Eingänge {count} zu spät (0x1C33:0D Shift too short).</translation>
    </message>
    <message>
        <source>{slave} has the alias {alias}, which {other} has as well.</source>
        <translation>{slave} hat den Alias {alias}, den auch {other} hat.</translation>
    </message>
    <message>
        <source>{slave} has the device ID {id}, which {other} has as well.</source>
        <translation>{slave} hat die Gerätekennung {id}, die auch {other} hat.</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}.</source>
        <translation>{slave} ist in {state} mit AL-Statuscode {alcode}{alarm}, seit {since}.</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}; just before: {why}.</source>
        <translation>{slave} ist seit {since} in {state} mit AL-Statuscode {alcode}{alarm}; kurz davor: {why}.</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}: it had been cut off from the master, and its SYNC0 went on.</source>
        <translation>{slave} ist in {state} mit AL-Statuscode {alcode}{alarm}, seit {since}: er war vom Master abgeschnitten, und sein SYNC0 lief weiter.</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}; the master was not locked to the reference clock, and frames slid through its SYNC0.</source>
        <translation>{slave} ist in {state} mit AL-Statuscode {alcode}{alarm}, seit {since}; der Master war nicht auf die Referenzuhr eingerastet, und Frames glitten durch SYNC0.</translation>
    </message>
    <message>
        <source>{slave} left the sync window at {since} ({deviation}, limit {limit}) and came back; {count} in all.</source>
        <translation>{slave} verließ bei {since} das Sync-Window ({deviation}, Grenze {limit}) und kam zurück; {count} insgesamt.</translation>
    </message>
    <message>
        <source>{slave} left {count:# mailbox request|# mailbox requests} in a row without an answer.</source>
        <translation>{slave} ließ {count:# Mailbox-Anfrage|# Mailbox-Anfragen} hintereinander ohne Antwort.</translation>
    </message>
    <message>
        <source>{slave} lost its link at port {port} {count} (0x{register}), last at {last}.</source>
        <translation>{slave} verlor an Port {port} {count} den Link (0x{register}), zuletzt bei {last}.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, and the master was not locked to the reference clock all the time: frames slid through its SYNC0.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}, und der Master war nicht die ganze Zeit auf die Referenzuhr eingerastet: Frames glitten durch SYNC0.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}: the master synchronisation is switched off, and frames slid through its SYNC0.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}: die Master-Synchronisation ist abgeschaltet, und Frames glitten durch SYNC0.</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and nothing held the frames at their place before it all the time: they slid through it.</source>
        <translation>{slave} bekam seine Ausgänge {count} zu spät für SYNC0 (0x1C32:0D Shift too short), und nichts hielt die Frames die ganze Zeit an ihrem Platz davor: sie glitten hindurch.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames came behind the SYNC0 they were meant for: nominally they are there {margin} before it, but one in a thousand is {lateness} late.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}, {part} davon, weil Frames hinter dem SYNC0 kamen, für das sie bestimmt waren: nominell sind sie {margin} davor da, aber einer von tausend kommt {lateness} zu spät.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames were lost; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}, {part} davon, weil Frames verloren gingen; der Fehlerzähler erreichte {integrator} von {limit}.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames were held up on their way; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}, {part} davon, weil Frames unterwegs aufgehalten wurden; der Fehlerzähler erreichte {integrator} von {limit}.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because the host left cycles out; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} {missed:fehlte # SM2-Ereignis|fehlten # SM2-Ereignisse}, {part} davon, weil der Rechner Zyklen ausließ; der Fehlerzähler erreichte {integrator} von {limit}.</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them while its SYNC0 did not come where its outputs are meant for, from {since} on: {why}.</source>
        <translation>{slave} verpasste {missed:# SM2-Ereignis|# SM2-Ereignisse}, davon {part}, während sein SYNC0 nicht dort kam, wofür seine Ausgänge bestimmt sind, ab {since}: {why}.</translation>
    </message>
    <message>
        <source>{slave} needed longer than its cycle {count} ({object} cycle exceeded), last at {last}.</source>
        <translation>{slave} brauchte {count} länger als den Zyklus ({object} Cycle exceeded), zuletzt bei {last}.</translation>
    </message>
    <message>
        <source>{slave} skipped {count:# cycle|# cycles} because the one before was not over ({object} cycle exceeded): its fieldbus needs longer than a cycle.</source>
        <translation>{slave} ließ {count:# Zyklus|# Zyklen} aus, weil der davor nicht zu Ende war ({object} Cycle exceeded): sein Feldbus braucht länger als einen Zyklus.</translation>
    </message>
    <message>
        <source>{slave} stays in {state} while others went further.</source>
        <translation>{slave} bleibt in {state}, während andere weiter sind.</translation>
    </message>
    <message>
        <source>{slave} stays in {state}: it refused to go on with AL status code {alcode}, last at {since}.</source>
        <translation>{slave} bleibt in {state}: er weigerte sich mit AL-Statuscode {alcode}, zuletzt bei {since}.</translation>
    </message>
    <message>
        <source>{slave} was {deviation} off its reference clock at {since}, and nobody monitors it.</source>
        <translation>{slave} wich bei {since} um {deviation} von der Referenzuhr ab, und niemand überwacht das.</translation>
    </message>
    <message>
        <source>{slave} went at {since} and came back; meanwhile those behind it followed with delays (0x0928) that were measured with it: they were off by up to {deviation}.</source>
        <translation>{slave} ging bei {since} verloren und kam zurück; die dahinter folgten inzwischen mit Verzögerungen (0x0928), die mit ihm gemessen wurden: sie waren um bis zu {deviation} daneben.</translation>
    </message>
    <message>
        <source>{slave} went at {since}, and those behind it follow since with delays (0x0928) that were measured with it: they are off by up to {deviation}.</source>
        <translation>{slave} ging bei {since} verloren, und die dahinter folgen seitdem mit Verzögerungen (0x0928), die mit ihm gemessen wurden: sie sind um bis zu {deviation} daneben.</translation>
    </message>
    <message>
        <source>{subject} and {detail} have changed places.</source>
        <translation>{subject} und {detail} haben die Plätze getauscht.</translation>
    </message>
    <message>
        <source>{subject} answered in its mailbox with something else than was asked{because}.</source>
        <translation>{subject} hat in seiner Mailbox etwas anderes geantwortet als gefragt{because}.</translation>
    </message>
    <message>
        <source>{subject} answers again</source>
        <translation>{subject} antwortet wieder</translation>
    </message>
    <message>
        <source>{subject} did not answer in its mailbox in time.</source>
        <translation>{subject} hat in seiner Mailbox nicht rechtzeitig geantwortet.</translation>
    </message>
    <message>
        <source>{subject} did not reach {state} in time and is in {actual}.</source>
        <translation>{subject} hat {state} nicht rechtzeitig erreicht und ist in {actual}.</translation>
    </message>
    <message>
        <source>{subject} does not answer</source>
        <translation>{subject} antwortet nicht</translation>
    </message>
    <message>
        <source>{subject} in sync again, deviation {deviation}</source>
        <translation>{subject} wieder synchron, Abweichung {deviation}</translation>
    </message>
    <message>
        <source>{subject} is another device than configured{because}.</source>
        <translation>{subject} ist ein anderes Gerät als konfiguriert{because}.</translation>
    </message>
    <message>
        <source>{subject} is malformed{because}.</source>
        <translation>{subject} ist fehlerhaft aufgebaut{because}.</translation>
    </message>
    <message>
        <source>{subject} is missing{because}.</source>
        <translation>{subject} fehlt{because}.</translation>
    </message>
    <message>
        <source>{subject} is not supported{because}.</source>
        <translation>{subject} wird nicht unterstützt{because}.</translation>
    </message>
    <message>
        <source>{subject} port {port}: link lost {lost}</source>
        <translation>{subject} Port {port}: Link {lost} verloren</translation>
    </message>
    <message>
        <source>{subject} port {port}: {damaged:# damaged frame|# damaged frames}</source>
        <translation>{subject} Port {port}: {damaged:# beschädigter Frame|# beschädigte Frames}</translation>
    </message>
    <message>
        <source>{subject} port {port}: {damaged:# damaged frame|# damaged frames}, link lost {lost}</source>
        <translation>{subject} Port {port}: {damaged:# beschädigter Frame|# beschädigte Frames}, Link {lost} verloren</translation>
    </message>
    <message>
        <source>{subject} refused {state} and stays in {actual}: AL status code {alcode}.</source>
        <translation>{subject} hat {state} verweigert und bleibt in {actual}: AL-Statuscode {alcode}.</translation>
    </message>
    <message>
        <source>{subject} refused {state} and stays in {actual}: AL status code {alcode}; check {check}.</source>
        <translation>{subject} hat {state} verweigert und bleibt in {actual}: AL-Statuscode {alcode}; zu prüfen: {check}.</translation>
    </message>
    <message>
        <source>{subject} took too long{because}.</source>
        <translation>{subject} hat zu lange gedauert{because}.</translation>
    </message>
    <message>
        <source>{subject}: PDI watchdog expired ({count}): its firmware is silent</source>
        <translation>{subject}: PDI-Watchdog abgelaufen ({count}): seine Firmware schweigt</translation>
    </message>
    <message>
        <source>{subject}: connected (hot-connect group "{group}")</source>
        <translation>{subject}: angesteckt (Hot-Connect-Gruppe "{group}")</translation>
    </message>
    <message>
        <source>{subject}: connected by port {port} instead of A: swap its cables IN and OUT; its delay is right here, but other masters take it wrong without a word</source>
        <translation>{subject}: über Port {port} statt A angeschlossen: die Kabel IN und OUT tauschen; die Laufzeit stimmt hier, andere Master messen sie wortlos falsch</translation>
    </message>
    <message>
        <source>{subject}: diagnosis {type} {code}, text {text}</source>
        <translation>{subject}: Diagnosemeldung ({type}) {code}, Text {text}</translation>
    </message>
    <message>
        <source>{subject}: diagnosis {type} {code}, text {text}, time stamp {stamp}</source>
        <translation>{subject}: Diagnosemeldung ({type}) {code}, Text {text}, Zeitstempel {stamp}</translation>
    </message>
    <message>
        <source>{subject}: disconnected (hot-connect group "{group}")</source>
        <translation>{subject}: abgesteckt (Hot-Connect-Gruppe "{group}")</translation>
    </message>
    <message>
        <source>{subject}: emergency {code} ({alarm}, {text}), error register {register}, data {data}</source>
        <translation>{subject}: Emergency {code} ({alarm}, {text}), Fehlerregister {register}, Daten {data}</translation>
    </message>
    <message>
        <source>{subject}: emergency {code}, error register {register}, data {data}</source>
        <translation>{subject}: Emergency {code}, Fehlerregister {register}, Daten {data}</translation>
    </message>
    <message>
        <source>{subject}: it renews its inputs in every cycle again</source>
        <translation>{subject}: er erneuert seine Eingänge wieder in jedem Zyklus</translation>
    </message>
    <message>
        <source>{subject}: it takes its outputs in every cycle again</source>
        <translation>{subject}: er nimmt seine Ausgänge wieder in jedem Zyklus</translation>
    </message>
    <message>
        <source>{subject}: its cycles are short enough again</source>
        <translation>{subject}: seine Zyklen sind wieder kurz genug</translation>
    </message>
    <message>
        <source>{subject}: its delay of {delay} is not above that of the slave before it</source>
        <translation>{subject}: seine Laufzeit von {delay} ist nicht größer als die des Slaves davor</translation>
    </message>
    <message>
        <source>{subject}: no new inputs in {stale} of {cycles:# cycle|# cycles}, where each brought some before: its firmware is slow</source>
        <translation>{subject}: keine neuen Eingänge in {stale} von {cycles:# Zyklus|# Zyklen}, wo zuvor jeder welche brachte: seine Firmware ist langsam</translation>
    </message>
    <message>
        <source>{subject}: not there yet (hot-connect group "{group}")</source>
        <translation>{subject}: noch nicht da (Hot-Connect-Gruppe "{group}")</translation>
    </message>
    <message>
        <source>{subject}: outputs waited until the next ones in {stale} of {cycles:# cycle|# cycles}, where it took them before: its firmware is slow</source>
        <translation>{subject}: Ausgänge blieben in {stale} von {cycles:# Zyklus|# Zyklen} liegen, bis die nächsten kamen, wo er sie zuvor nahm: seine Firmware ist langsam</translation>
    </message>
    <message>
        <source>{subject}: port {port} has a link and no slave behind it: a closed ring or another master</source>
        <translation>{subject}: Port {port} hat einen Link und keinen Slave dahinter: ein geschlossener Ring oder ein anderer Master</translation>
    </message>
    <message>
        <source>{subject}: process data watchdog expired ({count})</source>
        <translation>{subject}: Prozessdaten-Watchdog abgelaufen ({count})</translation>
    </message>
    <message>
        <source>{subject}: recovered (try {tries})</source>
        <translation>{subject}: wieder da (Versuch {tries})</translation>
    </message>
    <message>
        <source>{subject}: recovery FAILED (try {tries})</source>
        <translation>{subject}: Wiederanlauf GESCHEITERT (Versuch {tries})</translation>
    </message>
    <message>
        <source>{subject}: recovery begins (try {tries})</source>
        <translation>{subject}: Wiederanlauf beginnt (Versuch {tries})</translation>
    </message>
    <message>
        <source>{subject}: recovery given up (try {tries})</source>
        <translation>{subject}: Wiederanlauf aufgegeben (Versuch {tries})</translation>
    </message>
    <message>
        <source>{subject}: the DCM error of {error} is beyond the limit of {limit}.</source>
        <translation>{subject}: der DCM-Fehler von {error} überschreitet die Grenze von {limit}.</translation>
    </message>
    <message>
        <source>{subject}: the delay to it comes out negative ({delay}); 0 is taken</source>
        <translation>{subject}: die Laufzeit zu ihm ergibt sich negativ ({delay}); 0 wird genommen</translation>
    </message>
    <message>
        <source>{subject}: the delay to it is implausible ({delay}); 0 is taken</source>
        <translation>{subject}: die Laufzeit zu ihm ist unglaubwürdig ({delay}); 0 wird genommen</translation>
    </message>
    <message>
        <source>{subject}: the slave aborted the SDO transfer with {code} ({meaning}).</source>
        <translation>{subject}: der Slave hat die SDO-Übertragung abgebrochen mit {code} ({meaning}).</translation>
    </message>
    <message>
        <source>{subject}: the slave ended the file transfer with {code} ({meaning}){because}.</source>
        <translation>{subject}: der Slave hat die Dateiübertragung beendet mit {code} ({meaning}){because}.</translation>
    </message>
    <message>
        <source>{subject}: the slave's answer differs from what the init command demands{because}.</source>
        <translation>{subject}: die Antwort des Slaves weicht von der Vorgabe des Init-Kommandos ab{because}.</translation>
    </message>
    <message>
        <source>{subject}: working counter {received} where {expected} was expected; a slave did not process the datagram.</source>
        <translation>{subject}: Working Counter {received} statt {expected}; ein Slave hat das Datagramm nicht bearbeitet.</translation>
    </message>
    <message>
        <source>{subject}: {count} of its cycles took longer than the cycle time: its firmware is slow</source>
        <translation>{subject}: {count:# seiner Zyklen dauerte|# seiner Zyklen dauerten} länger als die Zykluszeit: seine Firmware ist langsam</translation>
    </message>
    <message>
        <source>{subject}: {from} -&gt; {to}</source>
        <translation>{subject}: {from} -&gt; {to}</translation>
    </message>
    <message>
        <source>{subject}: {status} with AL status code {code}</source>
        <translation>{subject}: {status} mit AL-Statuscode {code}</translation>
    </message>
    <message>
        <source>{subject}: {status} with AL status code {code}; check {check}</source>
        <translation>{subject}: {status} mit AL-Statuscode {code}; zu prüfen: {check}</translation>
    </message>
    <message>
        <source>{text}</source>
        <translation>{text}</translation>
    </message>
    <message>
        <source>{what} writes the file {file}, too; name another one for one of them</source>
        <translation>auch {what} schreibt die Datei {file}; nennen Sie für eines von beiden eine andere</translation>
    </message>
    <message>
        <source>{where}: the element &lt;{subject}&gt; is missing{because}.</source>
        <translation>{where}: das Element &lt;{subject}&gt; fehlt{because}.</translation>
    </message>
    <message>
        <source>{where}: the file is beyond what is read{because}.</source>
        <translation>{where}: die Datei ist größer, als gelesen wird{because}.</translation>
    </message>
    <message>
        <source>{where}: the key "{subject}" cannot be used{because}.</source>
        <translation>{where}: der Szenario-Schlüssel "{subject}" ist nicht verwendbar{because}.</translation>
    </message>
    <message>
        <source>{where}: the value of &lt;{subject}&gt; cannot be used{because}.</source>
        <translation>{where}: der Wert von &lt;{subject}&gt; ist nicht verwendbar{because}.</translation>
    </message>
    <message>
        <source>{where}: this is another kind of file; expected{because}.</source>
        <translation>{where}: das ist eine andere Art von Datei; erwartet{because}.</translation>
    </message>
    <message>
        <source>{where}: this is not well-formed TOML{because}.</source>
        <translation>{where}: kein wohlgeformtes TOML{because}.</translation>
    </message>
    <message>
        <source>{where}: this is not well-formed XML{because}.</source>
        <translation>{where}: kein wohlgeformtes XML{because}.</translation>
    </message>
    <message>
        <source>{who} cannot be the first slave of the bus: nobody could be in front of it.</source>
        <translation>{who} kann nicht der erste Slave des Busses sein: niemand könnte vor ihm stehen.</translation>
    </message>
    <message>
        <source>{who} is known by its alias; it has none.</source>
        <translation>{who} wird am Alias erkannt; er hat keinen.</translation>
    </message>
    <message>
        <source>"{text}" is no number</source>
        <translation>"{text}" ist keine Zahl</translation>
    </message>
    <message>
        <source>"{text}" is out of range</source>
        <translation>"{text}" liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>"{text}" is no hexadecimal data</source>
        <translation>"{text}" sind keine hexadezimalen Daten</translation>
    </message>
    <message>
        <source>"{text}" is neither true nor false</source>
        <translation>"{text}" ist weder true noch false</translation>
    </message>
    <message>
        <source>"{text}" is no state transition</source>
        <translation>"{text}" ist kein Zustandsübergang</translation>
    </message>
    <message>
        <source>"{text}" is no transition</source>
        <translation>"{text}" ist kein Übergang</translation>
    </message>
    <message>
        <source>"{text}" is no PDO index</source>
        <translation>"{text}" ist kein PDO-Index</translation>
    </message>
    <message>
        <source>in &lt;{element}&gt;</source>
        <translation>in &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>there is no element</source>
        <translation>es enthält kein Element</translation>
    </message>
    <message>
        <source>it has {size} MB, the limit is {limit} MB</source>
        <translation>sie hat {size} MB, die Grenze ist {limit} MB</translation>
    </message>
    <message>
        <source>it has more than {limit} MB</source>
        <translation>sie hat mehr als {limit} MB</translation>
    </message>
    <message>
        <source>it is written in the encoding "{name}", which this system cannot convert; save it as UTF-8</source>
        <translation>sie ist in der Kodierung "{name}" geschrieben, die dieses System nicht umsetzen kann; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>it should be written in the encoding "{name}", to which the byte 0x{byte} does not belong; save it as UTF-8</source>
        <translation>sie soll in der Kodierung "{name}" geschrieben sein, zu der das Byte 0x{byte} nicht gehört; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>a project file with the root &lt;{wanted}&gt;, not &lt;{root}&gt;</source>
        <translation>eine Projektdatei mit der Wurzel &lt;{wanted}&gt;, nicht &lt;{root}&gt;</translation>
    </message>
    <message>
        <source>a project file of version {version} or older, not {other}</source>
        <translation>eine Projektdatei der Version {version} oder älter, nicht {other}</translation>
    </message>
    <message>
        <source>an ENI file (root element EtherCATConfig)</source>
        <translation>eine ENI-Datei (Wurzelelement EtherCATConfig)</translation>
    </message>
    <message>
        <source>an ENI file that others can read: its maker has encrypted it</source>
        <translation>eine ENI-Datei, die andere lesen können: ihr Hersteller hat sie verschlüsselt</translation>
    </message>
    <message>
        <source>an ESI file with the root &lt;EtherCATInfo&gt;, not &lt;{root}&gt;</source>
        <translation>eine ESI-Datei mit der Wurzel &lt;EtherCATInfo&gt;, nicht &lt;{root}&gt;</translation>
    </message>
    <message>
        <source>a pcap or pcapng capture; it is empty</source>
        <translation>eine pcap- oder pcapng-Aufzeichnung; sie ist leer</translation>
    </message>
    <message>
        <source>a recording; this database belongs to another program</source>
        <translation>eine Aufzeichnung; diese Datenbank gehört einem anderen Programm</translation>
    </message>
    <message>
        <source>a recording of version {version} or older; this one is of version {other}, use the program that has written it, or a newer one</source>
        <translation>eine Aufzeichnung der Version {version} oder älter; diese hat Version {other}, das Programm nehmen, das sie geschrieben hat, oder ein neueres</translation>
    </message>
    <message>
        <source>it is damaged: {words}</source>
        <translation>sie ist beschädigt: {words}</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht aus</translation>
    </message>
    <message>
        <source>there is one of this name already, and a recording replaces nothing</source>
        <translation>es gibt schon eine dieses Namens, und eine Aufzeichnung ersetzt nichts</translation>
    </message>
    <message>
        <source>the file is gone: it, or its folder, was deleted or moved while it was recorded</source>
        <translation>die Datei ist fort: sie oder ihr Ordner wurde während der Aufzeichnung gelöscht oder verschoben</translation>
    </message>
    <message>
        <source>the attribute No is missing</source>
        <translation>das Attribut No fehlt</translation>
    </message>
    <message>
        <source>the attribute ModuleIdent is missing</source>
        <translation>das Attribut ModuleIdent fehlt</translation>
    </message>
    <message>
        <source>it has too many sub-indices</source>
        <translation>es hat zu viele Subindizes</translation>
    </message>
    <message>
        <source>MinInstances {least} is more than MaxInstances {most}</source>
        <translation>MinInstances {least} ist mehr als MaxInstances {most}</translation>
    </message>
    <message>
        <source>there is no Pdo with the RefName "{name}"</source>
        <translation>es gibt kein Pdo mit dem RefName "{name}"</translation>
    </message>
    <message>
        <source>the PDO index 0x{index} is used twice; first in line {line}</source>
        <translation>der PDO-Index 0x{index} kommt zweimal vor; zuerst in Zeile {line}</translation>
    </message>
    <message>
        <source>{value} is out of range in channel {channel}</source>
        <translation>{value} liegt in Kanal {channel} außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>it lies outside of the folder of the ESI file</source>
        <translation>sie liegt außerhalb des Ordners der ESI-Datei</translation>
    </message>
    <message>
        <source>the ESI file refers to too many files</source>
        <translation>die ESI-Datei verweist auf zu viele Dateien</translation>
    </message>
    <message>
        <source>there is no device "{name}" in the file</source>
        <translation>die Datei hat kein Gerät "{name}"</translation>
    </message>
    <message>
        <source>the ESI files have revision 0x{revision}</source>
        <translation>die ESI-Dateien haben Revision 0x{revision}</translation>
    </message>
    <message>
        <source>none of the {count} devices in the ESI files has this vendor and product</source>
        <translation>keines der {count} Geräte in den ESI-Dateien hat diesen Hersteller und dieses Produkt</translation>
    </message>
    <message>
        <source>it is no device catalogue, or its beginning is damaged</source>
        <translation>sie ist kein Gerätekatalog, oder ihr Anfang ist beschädigt</translation>
    </message>
    <message>
        <source>it is no ordinary file</source>
        <translation>sie ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ein Teil des Pfads ist kein Ordner</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>das Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>das Kontingent ist erschöpft</translation>
    </message>
    <message>
        <source>this machine has no Ethernet adapter</source>
        <translation>dieser Rechner hat keine Ethernet-Karte</translation>
    </message>
    <message>
        <source>there are: {names}</source>
        <translation>es gibt: {names}</translation>
    </message>
    <message>
        <source>not an Ethernet adapter</source>
        <translation>keine Ethernet-Karte</translation>
    </message>
    <message>
        <source>no carrier</source>
        <translation>keine Verbindung am Kabel</translation>
    </message>
    <message>
        <source>it cannot put its send time into frames</source>
        <translation>sie kann ihre Sendezeit nicht in Frames schreiben</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>die Netzwerkkarte ist abgeschaltet</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>das Gerät gibt es nicht mehr</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>das Gerät gibt es nicht mehr</translation>
    </message>
    <message>
        <source>the EEPROM belongs to the PDI and is left to it</source>
        <translation>das EEPROM gehört dem PDI und bleibt bei ihm</translation>
    </message>
    <message>
        <source>category {category} at word 0x{word} of {words} words reaches beyond the EEPROM of {bytes} bytes</source>
        <translation>Kategorie {category} bei Wort 0x{word} mit {words} Wörtern reicht über das EEPROM von {bytes} Bytes hinaus</translation>
    </message>
    <message>
        <source>more than {most} categories up to word 0x{word}</source>
        <translation>mehr als {most} Kategorien bis Wort 0x{word}</translation>
    </message>
    <message>
        <source>it has an odd number of bytes</source>
        <translation>es hat eine ungerade Zahl von Bytes</translation>
    </message>
    <message>
        <source>it is shorter than the header of {bytes} bytes</source>
        <translation>es ist kürzer als der Kopf von {bytes} Bytes</translation>
    </message>
    <message>
        <source>its checksum is 0x{has} where 0x{right} is right</source>
        <translation>seine Prüfsumme ist 0x{has}, richtig ist 0x{right}</translation>
    </message>
    <message>
        <source>its {bytes} bytes are more than the EEPROM's {room}</source>
        <translation>seine {bytes} Bytes sind mehr als die {room} des EEPROMs</translation>
    </message>
    <message>
        <source>no answer at word 0x{word}{which}</source>
        <translation>keine Antwort bei Wort 0x{word}{which}</translation>
    </message>
    <message>
        <source>the EEPROM stays busy at word 0x{word}{which}</source>
        <translation>das EEPROM bleibt bei Wort 0x{word} beschäftigt{which}</translation>
    </message>
    <message>
        <source>the ESC does not enable writing at word 0x{word}{which}</source>
        <translation>der ESC gibt das Schreiben bei Wort 0x{word} nicht frei{which}</translation>
    </message>
    <message>
        <source>the EEPROM acknowledges no write command at word 0x{word}{which}</source>
        <translation>das EEPROM bestätigt bei Wort 0x{word} kein Schreibkommando{which}</translation>
    </message>
    <message>
        <source>the EEPROM acknowledges no read command at word 0x{word}{which}</source>
        <translation>das EEPROM bestätigt bei Wort 0x{word} kein Lesekommando{which}</translation>
    </message>
    <message>
        <source>word 0x{word} reads 0x{value} after another value was written{which}</source>
        <translation>Wort 0x{word} liest sich als 0x{value}, nachdem ein anderer Wert geschrieben wurde{which}</translation>
    </message>
    <message>
        <source>{bytes} bytes are fewer than the {least} of its fixed part</source>
        <translation>{bytes} Bytes sind weniger als die {least} seines festen Teils</translation>
    </message>
    <message>
        <source>a write of it was cut short; go offline and end that first</source>
        <translation>ein Schreibvorgang wurde abgebrochen; offline gehen und ihn zuerst beenden</translation>
    </message>
    <message>
        <source>a write of it was cut short; end that first with "sii finish", or write a whole image</source>
        <translation>ein Schreibvorgang wurde abgebrochen; ihn zuerst mit "sii finish" beenden oder ein ganzes Abbild schreiben</translation>
    </message>
    <message>
        <source>no EEPROM write of this slave was cut short</source>
        <translation>bei diesem Slave wurde kein Schreiben des EEPROMs abgebrochen</translation>
    </message>
    <message>
        <source>the mailbox holds no segment</source>
        <translation>die Mailbox fasst kein Segment</translation>
    </message>
    <message>
        <source>the mailbox holds no data</source>
        <translation>die Mailbox fasst keine Daten</translation>
    </message>
    <message>
        <source>the answer belongs to another request</source>
        <translation>die Antwort gehört zu einer anderen Anfrage</translation>
    </message>
    <message>
        <source>the toggle bit did not alternate</source>
        <translation>das Toggle-Bit wechselte nicht</translation>
    </message>
    <message>
        <source>the slave announces {bytes} bytes, more than the {most} that are taken</source>
        <translation>der Slave kündigt {bytes} Bytes an, mehr als die {most}, die angenommen werden</translation>
    </message>
    <message>
        <source>more than the {bytes} bytes that were announced</source>
        <translation>mehr als die {bytes} Bytes, die angekündigt waren</translation>
    </message>
    <message>
        <source>{bytes} bytes where {announced} were announced</source>
        <translation>{bytes} Bytes, wo {announced} angekündigt waren</translation>
    </message>
    <message>
        <source>an empty segment that is not the last</source>
        <translation>ein leeres Segment, das nicht das letzte ist</translation>
    </message>
    <message>
        <source>its fragments do not follow each other</source>
        <translation>ihre Teile folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>its answer is longer than {bytes} bytes</source>
        <translation>die Antwort ist länger als {bytes} Bytes</translation>
    </message>
    <message>
        <source>an error that cannot be read</source>
        <translation>ein Fehler, der sich nicht lesen lässt</translation>
    </message>
    <message>
        <source>it has no mailbox</source>
        <translation>er hat keine Mailbox</translation>
    </message>
    <message>
        <source>it is longer than a frame</source>
        <translation>es ist länger als ein Frame</translation>
    </message>
    <message>
        <source>no frame comes back</source>
        <translation>kein Frame kommt zurück</translation>
    </message>
    <message>
        <source>no acknowledgement where one was to come</source>
        <translation>keine Bestätigung, wo eine kommen sollte</translation>
    </message>
    <message>
        <source>no data where data were asked for</source>
        <translation>keine Daten, wo welche verlangt waren</translation>
    </message>
    <message>
        <source>busy without end</source>
        <translation>beschäftigt ohne Ende</translation>
    </message>
    <message>
        <source>packet {number} where {expected} was to come</source>
        <translation>Paket {number}, wo {expected} kommen sollte</translation>
    </message>
    <message>
        <source>the file is longer than the {bytes} bytes that are taken</source>
        <translation>die Datei ist länger als die {bytes} Bytes, die angenommen werden</translation>
    </message>
    <message>
        <source>its datagram of {bytes} bytes takes {time} us on the wire, and the cycle leaves no room for it; choose a longer cycle</source>
        <translation>sein Datagramm von {bytes} Bytes braucht {time} us auf der Leitung, und der Zyklus lässt dafür keinen Platz; einen längeren Zyklus wählen</translation>
    </message>
    <message>
        <source>{bytes} bytes are more than the {most} that are possible</source>
        <translation>{bytes} Bytes sind mehr als die möglichen {most}</translation>
    </message>
    <message>
        <source>it is about no bytes at all</source>
        <translation>es geht um gar keine Bytes</translation>
    </message>
    <message>
        <source>{count} others are on their way already; wait for one of them</source>
        <translation>{count} andere sind schon unterwegs; auf eine davon warten</translation>
    </message>
    <message>
        <source>it has no slaves</source>
        <translation>es hat keine Slaves</translation>
    </message>
    <message>
        <source>it has no cyclic frames</source>
        <translation>es hat keine zyklischen Frames</translation>
    </message>
    <message>
        <source>more slaves than addresses</source>
        <translation>mehr Slaves als Adressen</translation>
    </message>
    <message>
        <source>the bus is offline</source>
        <translation>der Bus ist offline</translation>
    </message>
    <message>
        <source>no slave on the bus has a system time</source>
        <translation>kein Slave am Bus hat eine Systemzeit</translation>
    </message>
    <message>
        <source>no slave is configured as reference clock</source>
        <translation>kein Slave ist als Referenzuhr eingestellt</translation>
    </message>
    <message>
        <source>it has no system time and cannot be the reference clock, and no slave behind it can</source>
        <translation>er hat keine Systemzeit und kann nicht Referenzuhr sein, und kein Slave hinter ihm kann es</translation>
    </message>
    <message>
        <source>no slave that is there can be the reference clock</source>
        <translation>kein Slave, der da ist, kann Referenzuhr sein</translation>
    </message>
    <message>
        <source>no answer to the receive time latch</source>
        <translation>keine Antwort auf das Festhalten der Empfangszeiten</translation>
    </message>
    <message>
        <source>it does not take its system time offset</source>
        <translation>er nimmt seinen Systemzeitversatz nicht an</translation>
    </message>
    <message>
        <source>its system time cannot be read</source>
        <translation>seine Systemzeit lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>its SYNC unit is not active (0x0981)</source>
        <translation>seine SYNC-Einheit ist nicht aktiv (0x0981)</translation>
    </message>
    <message>
        <source>the bus is at rest in INIT; lead the whole bus to PREOP first</source>
        <translation>der Bus ruht in INIT; zuerst den ganzen Bus nach PREOP führen</translation>
    </message>
    <message>
        <source>the bus is in {state}; no slave can be led above it</source>
        <translation>der Bus ist in {state}; kein Slave lässt sich darüber hinaus führen</translation>
    </message>
    <message>
        <source>no station address is free</source>
        <translation>keine Stationsadresse ist frei</translation>
    </message>
    <message>
        <source>"{text}" is no whole number</source>
        <translation>"{text}" ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>"{text}" is no number of microseconds with at most three decimals</source>
        <translation>"{text}" ist keine Zahl von Mikrosekunden mit höchstens drei Nachkommastellen</translation>
    </message>
    <message>
        <source>"{text}" is neither on nor off</source>
        <translation>"{text}" ist weder on noch off</translation>
    </message>
    <message>
        <source>"{text}" is none of {words}</source>
        <translation>"{text}" ist keins von {words}</translation>
    </message>
    <message>
        <source>"{text}" is no address like {example}</source>
        <translation>"{text}" ist keine Adresse wie {example}</translation>
    </message>
    <message>
        <source>a name cannot be empty</source>
        <translation>ein Name darf nicht leer sein</translation>
    </message>
    <message>
        <source>a name is printable UTF-8 text</source>
        <translation>ein Name ist druckbarer UTF-8-Text</translation>
    </message>
    <message>
        <source>the factor 0 gives no cycle; switch the operation mode off instead</source>
        <translation>der Faktor 0 ergibt keinen Zyklus; statt dessen die Betriebsart abschalten</translation>
    </message>
    <message>
        <source>the setting needs a value</source>
        <translation>die Einstellung braucht einen Wert</translation>
    </message>
    <message>
        <source>"{text}" is not to be had here</source>
        <translation>"{text}" gibt es hier nicht</translation>
    </message>
    <message>
        <source>it is a number</source>
        <translation>es ist eine Zahl</translation>
    </message>
    <message>
        <source>it is a text</source>
        <translation>es ist ein Text</translation>
    </message>
    <message>
        <source>"{name}" is the name of number {number} already</source>
        <translation>"{name}" ist schon der Name von Nummer {number}</translation>
    </message>
    <message>
        <source>the device has no PDO 0x{index} in this direction; it has {indices}</source>
        <translation>das Gerät hat in dieser Richtung kein PDO 0x{index}; es hat {indices}</translation>
    </message>
    <message>
        <source>0x{index} stands there twice</source>
        <translation>0x{index} steht dort zweimal</translation>
    </message>
    <message>
        <source>0x{index} and 0x{other} exclude each other</source>
        <translation>0x{index} und 0x{other} schließen einander aus</translation>
    </message>
    <message>
        <source>the device has no such PDO</source>
        <translation>das Gerät hat kein solches PDO</translation>
    </message>
    <message>
        <source>the ESI says that the mapping of this PDO is fixed</source>
        <translation>nach der ESI ist das Mapping dieses PDOs fest</translation>
    </message>
    <message>
        <source>the device does not take another mapping (CoE PdoConfig in its ESI)</source>
        <translation>das Gerät nimmt kein anderes Mapping an (CoE PdoConfig in seiner ESI)</translation>
    </message>
    <message>
        <source>the device has no CoE mailbox</source>
        <translation>das Gerät hat keine CoE-Mailbox</translation>
    </message>
    <message>
        <source>the device has no SoE mailbox</source>
        <translation>das Gerät hat keine SoE-Mailbox</translation>
    </message>
    <message>
        <source>"{text}" is no state transition like PS or SO</source>
        <translation>"{text}" ist kein Zustandsübergang wie PS oder SO</translation>
    </message>
    <message>
        <source>"{text}" are no whole hexadecimal bytes</source>
        <translation>"{text}" sind keine ganzen hexadezimalen Bytes</translation>
    </message>
    <message>
        <source>"{text}" is no object</source>
        <translation>"{text}" ist kein Objekt</translation>
    </message>
    <message>
        <source>the comment is no UTF-8 text</source>
        <translation>der Kommentar ist kein UTF-8-Text</translation>
    </message>
    <message>
        <source>"{text}" is neither none nor a module ident</source>
        <translation>"{text}" ist weder none noch eine Modulkennung</translation>
    </message>
    <message>
        <source>there is no slave at position {position}, the last one is at {last}</source>
        <translation>an Position {position} ist kein Slave, der letzte ist an {last}</translation>
    </message>
    <message>
        <source>the slave is gone</source>
        <translation>der Slave ist fort</translation>
    </message>
    <message>
        <source>no file can be made there</source>
        <translation>dort lässt sich keine Datei anlegen</translation>
    </message>
    <message>
        <source>no slaves</source>
        <translation>keine Slaves</translation>
    </message>
    <message>
        <source>unsaved work of Syncline</source>
        <translation>ungesicherte Arbeit von Syncline</translation>
    </message>
    <message>
        <source>a recording is shown: close it first (File, Close Recording)</source>
        <translation>eine Aufzeichnung wird gezeigt: sie zuerst schließen (Datei, Aufzeichnung schließen)</translation>
    </message>
    <message>
        <source>a run holds {count} different ones: go offline and online again to watch others</source>
        <translation>ein Lauf fasst {count} verschiedene: offline und wieder online gehen, um andere zu beobachten</translation>
    </message>
    <message>
        <source>no machine runs: go online first</source>
        <translation>es läuft keine Maschine: zuerst online gehen</translation>
    </message>
    <message>
        <source>no cycle has run yet: go online first</source>
        <translation>es lief noch kein Zyklus: zuerst online gehen</translation>
    </message>
    <message>
        <source>no cycle of it is in memory any more</source>
        <translation>kein Zyklus davon ist noch im Speicher</translation>
    </message>
    <message>
        <source>another stretch is being written; try again in a moment</source>
        <translation>ein anderer Abschnitt wird gerade geschrieben; gleich noch einmal versuchen</translation>
    </message>
    <message>
        <source>{value} is outside {range}</source>
        <translation>{value} liegt außerhalb von {range}</translation>
    </message>
    <message>
        <source>the value is of another kind</source>
        <translation>der Wert ist von anderer Art</translation>
    </message>
    <message>
        <source>its SYNC0 will never come: the start time {start} (0x0990) had passed by {late} ns at {time}</source>
        <translation>sein SYNC0 kommt nie: die Startzeit {start} (0x0990) war bei {time} seit {late} ns vorbei</translation>
    </message>
    <message>
        <source>packet {number} acknowledged where {expected} was sent</source>
        <translation>Paket {number} bestätigt, wo {expected} gesendet war</translation>
    </message>
    <message>
        <source>link-layer-ref-clock: this link cannot put its send time into frames</source>
        <translation>link-layer-ref-clock: diese Verbindung kann ihre Sendezeit nicht in Frames schreiben</translation>
    </message>
    <message>
        <source>it is not in sync after {time} s: {reason}</source>
        <translation>er ist nach {time} s nicht synchron: {reason}</translation>
    </message>
    <message>
        <source>messages without end, but no answer</source>
        <translation>Nachrichten ohne Ende, aber keine Antwort</translation>
    </message>
    <message>
        <source>an EEPROM is written in words of two bytes</source>
        <translation>ein EEPROM wird in Wörtern von zwei Bytes geschrieben</translation>
    </message>
    <message>
        <source>the device has {count} places for modules, counted from 0</source>
        <translation>das Gerät hat {count} Plätze für Module, von 0 an gezählt</translation>
    </message>
    <message>
        <source>module 0x{module} does not fit into place {place}; these do: {modules}</source>
        <translation>Modul 0x{module} passt nicht auf Platz {place}; diese passen: {modules}</translation>
    </message>
    <message>
        <source>SDO command 0x{command} is not a response</source>
        <translation>SDO-Kommando 0x{command} ist keine Antwort</translation>
    </message>
    <message>
        <source>it is not an SDO response</source>
        <translation>es ist keine SDO-Antwort</translation>
    </message>
    <message>
        <source>only {bytes} bytes</source>
        <translation>nur {bytes} Bytes</translation>
    </message>
    <message>
        <source>"{text}" is no object; write 0x1018:01</source>
        <translation>"{text}" ist kein Objekt; 0x1018:01 schreiben</translation>
    </message>
    <message>
        <source>it needs about {need} MiB, and the disk has {left} MiB left</source>
        <translation>sie braucht etwa {need} MiB, und auf dem Datenträger sind {left} MiB frei</translation>
    </message>
    <message>
        <source>only {left} MiB are left on the disk; the recording is whole up to here</source>
        <translation>nur noch {left} MiB sind auf dem Datenträger frei; die Aufzeichnung ist bis hierher ganz</translation>
    </message>
    <message>
        <source>there is no slave at position {position}; the project has {count}</source>
        <translation>an Position {position} ist kein Slave; das Projekt hat {count}</translation>
    </message>
    <message>
        <source>"{text}" is no NAME xMULTIPLE like Slow x4, with 1..{most} bus cycles</source>
        <translation>"{text}" ist kein NAME xVIELFACHES wie Slow x4, mit 1..{most} Buszyklen</translation>
    </message>
    <message>
        <source>there is no Sync Unit "{name}"; the project has {names}</source>
        <translation>es gibt keine Sync Unit "{name}"; das Projekt hat {names}</translation>
    </message>
    <message>
        <source>"{text}" is neither auto nor a factor from {least} to {most}</source>
        <translation>"{text}" ist weder auto noch ein Faktor von {least} bis {most}</translation>
    </message>
    <message>
        <source>"{text}" is no entry INDEX:SUB:BITS like 0x6040:00:16</source>
        <translation>"{text}" ist kein Eintrag INDEX:SUB:BITS wie 0x6040:00:16</translation>
    </message>
    <message>
        <source>"{text}" is no address like 01:23:45:67:89:ab</source>
        <translation>"{text}" ist keine Adresse wie 01:23:45:67:89:ab</translation>
    </message>
    <message>
        <source>it is the name of an operation mode</source>
        <translation>es ist der Name einer Betriebsart</translation>
    </message>
    <message>
        <source>"{text}" is neither none nor POSITION:PORT, like 0:B</source>
        <translation>"{text}" ist weder none noch POSITION:PORT wie 0:B</translation>
    </message>
    <message>
        <source>"{text}" is no DRIVE:IDN=DATA like 0:S-0-0047=00000000</source>
        <translation>"{text}" ist kein DRIVE:IDN=DATA wie 0:S-0-0047=00000000</translation>
    </message>
    <message>
        <source>"{text}" is no data=HEX like data=0200</source>
        <translation>"{text}" ist kein data=HEX wie data=0200</translation>
    </message>
    <message>
        <source>the device has no {protocol} mailbox</source>
        <translation>das Gerät hat keine {protocol}-Mailbox</translation>
    </message>
    <message>
        <source>"{text}" is neither write nor read</source>
        <translation>"{text}" ist weder write noch read</translation>
    </message>
    <message>
        <source>"{text}" is no REGISTER=DATA like 0x09A8=0100, nor, for a read, REGISTER*BYTES</source>
        <translation>"{text}" ist kein REGISTER=DATA wie 0x09A8=0100 und, beim Lesen, kein REGISTER*BYTES</translation>
    </message>
    <message>
        <source>"{text}" is none of expect=HEX, mask=HEX, within=MS, off, after</source>
        <translation>"{text}" ist keines von expect=HEX, mask=HEX, within=MS, off, after</translation>
    </message>
    <message>
        <source>only a read expects a value, of as many bytes as it reads; a mask is as long</source>
        <translation>nur wer liest, erwartet einen Wert, und zwar mit so vielen Bytes, wie gelesen werden; eine Maske ist ebenso lang</translation>
    </message>
    <message>
        <source>only commands of the master stand behind those of the slaves</source>
        <translation>nur Kommandos des Masters stehen hinter denen der Slaves</translation>
    </message>
    <message>
        <source>A start-up message is longer than the mailbox</source>
        <translation>Eine Startnachricht ist länger als die Mailbox</translation>
    </message>
    <message>
        <source>Shorten it, or enlarge the output mailbox.</source>
        <translation>Sie kürzen oder die Ausgangs-Mailbox vergrößern.</translation>
    </message>
    <message>
        <source>In bytes: the message {bytes}, room in the slave's mailbox {most}.</source>
        <translation>In Bytes: die Nachricht {bytes}, Platz in der Mailbox des Slaves {most}.</translation>
    </message>
    <message>
        <source>"{text}" is no IDN of a drive 0..7</source>
        <translation>"{text}" ist keine IDN eines Antriebs 0..7</translation>
    </message>
    <message>
        <source>"{text}" is none of fixed, off, timeout=MS</source>
        <translation>"{text}" ist keins von fixed, off, timeout=MS</translation>
    </message>
    <message>
        <source>"{text}" is no INDEX:SUB=DATA like 0x6060:00=08</source>
        <translation>"{text}" ist kein INDEX:SUB=DATA wie 0x6060:00=08</translation>
    </message>
    <message>
        <source>"{text}" is none of complete, fixed, off, adapt, timeout=MS</source>
        <translation>"{text}" ist keins von complete, fixed, off, adapt, timeout=MS</translation>
    </message>
    <message>
        <source>the device has no output pins that are known</source>
        <translation>von dem Gerät sind keine Ausgangspins bekannt</translation>
    </message>
    <message>
        <source>the device is no CAN gateway that is known</source>
        <translation>das Gerät ist kein bekanntes CAN-Gateway</translation>
    </message>
    <message>
        <source>{time} ns do not fit into 32 bits</source>
        <translation>{time} ns passen nicht in 32 Bits</translation>
    </message>
    <message>
        <source>{percent} is more than 100 %</source>
        <translation>{percent} ist mehr als 100 %</translation>
    </message>
    <message>
        <source>the device has no CoE mailbox through which objects could be written</source>
        <translation>das Gerät hat keine CoE-Mailbox, durch die Objekte geschrieben werden könnten</translation>
    </message>
    <message>
        <source>it names none of the log's columns</source>
        <translation>es nennt keine der Spalten des Logs</translation>
    </message>
    <message>
        <source>the file holds {count} networks; choose one by number or name: {names}</source>
        <translation>die Datei enthält {count} Netze; eines nach Nummer oder Name wählen: {names}</translation>
    </message>
    <message>
        <source>it holds neither what was there nor what was to be written: another slave, or written since; write the image that it is to have with "sii write"</source>
        <translation>es enthält weder, was da war, noch, was geschrieben werden sollte: ein anderer Slave, oder seither beschrieben; das gewünschte Abbild mit "sii write" schreiben</translation>
    </message>
    <message>
        <source>the other revision does not take it</source>
        <translation>die andere Revision nimmt es nicht</translation>
    </message>
    <message>
        <source>must be a list of [part, ns], such as [[0, 50], [0.5, 500], [1, 40000]]</source>
        <translation>er muss eine Liste aus [Anteil, ns] sein, etwa [[0, 50], [0.5, 500], [1, 40000]]</translation>
    </message>
    <message>
        <source>must be pairs of a part from 0 to 1 and a time from 0 to 60000000000 ns</source>
        <translation>er muss aus Paaren bestehen: ein Anteil von 0 bis 1 und eine Zeit von 0 bis 60000000000 ns</translation>
    </message>
    <message>
        <source>the parts must rise</source>
        <translation>die Anteile müssen steigen</translation>
    </message>
    <message>
        <source>{part} of all are not above {time} ns, so {other} of all cannot be below {least} ns</source>
        <translation>{part} von allen liegen nicht über {time} ns, also können {other} von allen nicht unter {least} ns liegen</translation>
    </message>
    <message>
        <source>so many stalls of this length leave the host no time at all</source>
        <translation>so viele Aussetzer dieser Länge lassen dem Rechner gar keine Zeit</translation>
    </message>
    <message>
        <source>must be one of {names}</source>
        <translation>er muss einer von diesen sein: {names}</translation>
    </message>
    <message>
        <source>does not go with {fault}</source>
        <translation>er passt nicht zu {fault}</translation>
    </message>
    <message>
        <source>does not go with {fault}: it is no slave's</source>
        <translation>er passt nicht zu {fault}: das ist keine Störung eines Slaves</translation>
    </message>
    <message>
        <source>is missing: {fault} needs it</source>
        <translation>er fehlt: {fault} braucht ihn</translation>
    </message>
    <message>
        <source>goes without probability: one of the two</source>
        <translation>er steht nicht neben probability: nur eines von beiden</translation>
    </message>
    <message>
        <source>must be above 0; the sign of value_ns says which way</source>
        <translation>er muss über 0 liegen; die Richtung gibt das Vorzeichen von value_ns an</translation>
    </message>
    <message>
        <source>must be above 0: at least 0.01</source>
        <translation>er muss über 0 liegen: mindestens 0.01</translation>
    </message>
    <message>
        <source>must be INIT, PREOP, SAFEOP or OP</source>
        <translation>er muss INIT, PREOP, SAFEOP oder OP sein</translation>
    </message>
    <message>
        <source>must be "A", "B", "C" or "D"</source>
        <translation>er muss "A", "B", "C" oder "D" sein</translation>
    </message>
    <message>
        <source>must be the position of a slave of this scenario</source>
        <translation>er muss die Position eines Slaves dieses Szenarios sein</translation>
    </message>
    <message>
        <source>this slave has no firmware that could do so (device emulation)</source>
        <translation>dieser Slave hat keine Firmware, die das könnte (Device Emulation)</translation>
    </message>
    <message>
        <source>this slave has no mailbox</source>
        <translation>dieser Slave hat keine Mailbox</translation>
    </message>
    <message>
        <source>this slave has no clock (dc)</source>
        <translation>dieser Slave hat keine Uhr (dc)</translation>
    </message>
    <message>
        <source>this slave has no system time (dc)</source>
        <translation>dieser Slave hat keine Systemzeit (dc)</translation>
    </message>
    <message>
        <source>needs a slave</source>
        <translation>er braucht einen Slave</translation>
    </message>
    <message>
        <source>no cable is at this port</source>
        <translation>an diesem Port ist kein Kabel</translation>
    </message>
    <message>
        <source>is not free: another slave is there</source>
        <translation>er ist nicht frei: dort ist ein anderer Slave</translation>
    </message>
    <message>
        <source>is where the cable from the master is anyway</source>
        <translation>dort ist ohnehin das Kabel vom Master</translation>
    </message>
    <message>
        <source>the fault would end before it begins, at {time} ms; 0 or no until_ms: for good</source>
        <translation>die Störung würde enden, bevor sie bei {time} ms beginnt; 0 oder kein until_ms: für immer</translation>
    </message>
    <message>
        <source>goes without until_ms: so many frames, or all of them until then</source>
        <translation>er steht nicht neben until_ms: so viele Frames oder alle bis dahin</translation>
    </message>
    <message>
        <source>without a slave, lose-frames has a count or a probability</source>
        <translation>ohne Slave hat lose-frames ein count oder eine probability</translation>
    </message>
    <message>
        <source>the {fault} of the same slave that begins at {time} ms is not over then</source>
        <translation>{fault} desselben Slaves, das bei {time} ms beginnt, ist dann noch nicht vorbei</translation>
    </message>
    <message>
        <source>the {fault} that begins at {time} ms is not over then</source>
        <translation>{fault}, das bei {time} ms beginnt, ist dann noch nicht vorbei</translation>
    </message>
    <message>
        <source>must be "none", "quiet", "desktop" or "bad"</source>
        <translation>er muss "none", "quiet", "desktop" oder "bad" sein</translation>
    </message>
    <message>
        <source>goes without jitter: one of the two</source>
        <translation>er steht nicht neben jitter: nur eines von beiden</translation>
    </message>
    <message>
        <source>a scenario needs at least one [[slave]]</source>
        <translation>ein Szenario braucht mindestens einen [[slave]]</translation>
    </message>
    <message>
        <source>all pulses must come within a day</source>
        <translation>alle Impulse müssen innerhalb eines Tages kommen</translation>
    </message>
    <message>
        <source>must be above 0 and below period_ms</source>
        <translation>er muss über 0 und unter period_ms liegen</translation>
    </message>
    <message>
        <source>must be "64", "32", "times" or "none"</source>
        <translation>er muss "64", "32", "times" oder "none" sein</translation>
    </message>
    <message>
        <source>must be "generic", "servo-y", "drive-c", "can-gateway", "analog-input" or "sync-bridge"</source>
        <translation>er muss "generic", "servo-y", "drive-c", "can-gateway", "analog-input" oder "sync-bridge" sein</translation>
    </message>
    <message>
        <source>must be 4 or 8</source>
        <translation>er muss 4 oder 8 sein</translation>
    </message>
    <message>
        <source>goes without esc, whose delays are known</source>
        <translation>er steht nicht neben esc, dessen Laufzeiten bekannt sind</translation>
    </message>
    <message>
        <source>is processing_delay_ns less forwarding_delay_ns: one of the two</source>
        <translation>er ist processing_delay_ns weniger forwarding_delay_ns: nur eines von beiden</translation>
    </message>
    <message>
        <source>must be "older" or "newer"</source>
        <translation>er muss "older" oder "newer" sein</translation>
    </message>
    <message>
        <source>makes {count} slaves where a segment has {most} at most</source>
        <translation>damit sind es {count} Slaves, ein Segment hat höchstens {most}</translation>
    </message>
    <message>
        <source>counts up to {last}, beyond 65535</source>
        <translation>er zählt bis {last}, über 65535 hinaus</translation>
    </message>
    <message>
        <source>counts up beyond 4294967295</source>
        <translation>er zählt über 4294967295 hinaus</translation>
    </message>
    <message>
        <source>is where the next of these slaves would be wired to; give them one by one</source>
        <translation>dort wäre der nächste dieser Slaves angeschlossen; einzeln angeben</translation>
    </message>
    <message>
        <source>must be the number of another slave</source>
        <translation>er muss die Nummer eines anderen Slaves sein</translation>
    </message>
    <message>
        <source>this port of slave {slave} has slave {other} already</source>
        <translation>an diesem Port von Slave {slave} ist schon Slave {other}</translation>
    </message>
    <message>
        <source>is more than there and back over {length} m together</source>
        <translation>er ist mehr als Hin- und Rückweg über {length} m zusammen</translation>
    </message>
    <message>
        <source>is needed: slave {slave} is the one that is wired to the master</source>
        <translation>er wird gebraucht: Slave {slave} ist der, der am Master hängt</translation>
    </message>
    <message>
        <source>must be the number of a slave; there are {count}</source>
        <translation>er muss die Nummer eines Slaves sein; es gibt {count}</translation>
    </message>
    <message>
        <source>{port} is where slave {slave} is wired to the one before it</source>
        <translation>mit {port} hängt Slave {slave} an dem vor ihm</translation>
    </message>
    <message>
        <source>goes with behaviour = "sync-bridge" only</source>
        <translation>er passt nur zu behaviour = "sync-bridge"</translation>
    </message>
    <message>
        <source>either esi = an ESI file or sii = an EEPROM image names the device, relative to the scenario</source>
        <translation>entweder esi = eine ESI-Datei oder sii = ein EEPROM-Abbild nennt das Gerät, relativ zum Szenario</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>er muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>er muss true oder false sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>er muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number from {low} on</source>
        <translation>er muss eine ganze Zahl ab {low} sein</translation>
    </message>
    <message>
        <source>must be a whole number from {low} to {high}</source>
        <translation>er muss eine ganze Zahl von {low} bis {high} sein</translation>
    </message>
    <message>
        <source>must be a number from {low} to {high}</source>
        <translation>er muss eine Zahl von {low} bis {high} sein</translation>
    </message>
    <message>
        <source>must be written as [{key}]</source>
        <translation>er muss als [{key}] geschrieben werden</translation>
    </message>
    <message>
        <source>must be written as [[{key}]]</source>
        <translation>er muss als [[{key}]] geschrieben werden</translation>
    </message>
    <message>
        <source>must be a list in brackets</source>
        <translation>er muss eine Liste in Klammern sein</translation>
    </message>
    <message>
        <source>is not a key that {reason} has here</source>
        <translation>{reason} hat hier keinen solchen Schlüssel</translation>
    </message>
    <message>
        <source>a scenario</source>
        <translation>ein Szenario</translation>
    </message>
    <message>
        <source>a host profile</source>
        <translation>ein Rechnerprofil</translation>
    </message>
    <message>
        <source>the segment has no slaves</source>
        <translation>das Segment hat keine Slaves</translation>
    </message>
    <message>
        <source>no slave is where it hangs; check parent</source>
        <translation>dort, wo er hängt, ist kein Slave; parent prüfen</translation>
    </message>
    <message>
        <source>the wiring puts slave {slave} at this place of the frame's way; list the slaves in frame order (ports D, B, C; what hangs between another entry than A and port A comes first)</source>
        <translation>die Verkabelung setzt Slave {slave} an diese Stelle des Frame-Weges; die Slaves in der Reihenfolge des Frames aufführen (Ports D, B, C; was zwischen einem anderen Eingang als A und Port A hängt, kommt zuerst)</translation>
    </message>
    <message>
        <source>no frame reaches it; check parent and port</source>
        <translation>kein Frame erreicht ihn; parent und port prüfen</translation>
    </message>
    <message>
        <source>it has no slaves to simulate</source>
        <translation>sie hat keine Slaves, die zu simulieren wären</translation>
    </message>
    <message>
        <source>not in {file}</source>
        <translation>nicht in {file}</translation>
    </message>
    <message>
        <source>{file} is the EEPROM of {device}</source>
        <translation>{file} ist das EEPROM von {device}</translation>
    </message>
    <message>
        <source>{file} has {count}, counted from 0</source>
        <translation>{file} hat {count}, von 0 an gezählt</translation>
    </message>
    <message>
        <source>unknown option '{option}'; {forms}</source>
        <translation>unbekannte Option '{option}'; {forms}</translation>
    </message>
    <message>
        <source>the controller moves the timer; set it to on first</source>
        <translation>der Regler verstellt den Timer; erst auf on setzen</translation>
    </message>
    <message>
        <source>its EEPROM, of which the capture holds {words} words</source>
        <translation>sein EEPROM, von dem die Aufzeichnung {words} Worte enthält</translation>
    </message>
    <message>
        <source>the place of the send time is not in the frame</source>
        <translation>die Stelle der Sendezeit liegt nicht im Frame</translation>
    </message>
    <message>
        <source>the slave does not answer{which}</source>
        <translation>der Slave antwortet nicht{which}</translation>
    </message>
    <message>
        <source>the bus is offline; go online first</source>
        <translation>der Bus ist offline; zuerst online gehen</translation>
    </message>
    <message>
        <source>the configuration has only {count} slaves</source>
        <translation>die Konfiguration hat nur {count} Slaves</translation>
    </message>
    <message>
        <source>it does not speak CoE</source>
        <translation>er spricht kein CoE</translation>
    </message>
    <message>
        <source>its mailbox works from PREOP on, and it is in {state}; lead it there first</source>
        <translation>seine Mailbox arbeitet ab PREOP, und er ist in {state}; zuerst dorthin führen</translation>
    </message>
    <message>
        <source>the bus is brought up again</source>
        <translation>der Bus wird neu hochgefahren</translation>
    </message>
    <message>
        <source>mailbox error {number}, {reason}</source>
        <translation>Mailbox-Fehler {number}, {reason}</translation>
    </message>
    <message>
        <source>syntax of the mailbox header</source>
        <translation>Syntax des Mailbox-Headers</translation>
    </message>
    <message>
        <source>the slave does not support this protocol</source>
        <translation>der Slave unterstützt dieses Protokoll nicht</translation>
    </message>
    <message>
        <source>the channel does not exist</source>
        <translation>den Kanal gibt es nicht</translation>
    </message>
    <message>
        <source>the slave does not support this service of the protocol</source>
        <translation>der Slave unterstützt diesen Dienst des Protokolls nicht</translation>
    </message>
    <message>
        <source>the protocol's header is wrong</source>
        <translation>der Header des Protokolls ist falsch</translation>
    </message>
    <message>
        <source>the message is too short</source>
        <translation>die Nachricht ist zu kurz</translation>
    </message>
    <message>
        <source>the slave is out of memory</source>
        <translation>der Slave hat keinen Speicher mehr</translation>
    </message>
    <message>
        <source>the length in the message is inconsistent</source>
        <translation>die Länge in der Nachricht passt nicht</translation>
    </message>
    <message>
        <source>the slave is still busy with another service</source>
        <translation>der Slave ist noch mit einem anderen Dienst beschäftigt</translation>
    </message>
    <message>
        <source>unknown mailbox error</source>
        <translation>unbekannter Mailbox-Fehler</translation>
    </message>
    <message>
        <source>only answers to other requests come</source>
        <translation>es kommen nur Antworten auf andere Anfragen</translation>
    </message>
    <message>
        <source>the bus goes offline{which}</source>
        <translation>der Bus geht offline{which}</translation>
    </message>
    <message>
        <source>the content changed again after every word had been verified, at word 0x{word}</source>
        <translation>der Inhalt hat sich bei Wort 0x{word} wieder geändert, nachdem jedes Wort geprüft war</translation>
    </message>
    <message>
        <source>words 0 to 7 would end up with the checksum 0x{has} where 0x{right} is right; write word 7 with them</source>
        <translation>die Worte 0 bis 7 hätten danach die Prüfsumme 0x{has}, richtig ist 0x{right}; Wort 7 mit ihnen schreiben</translation>
    </message>
    <message>
        <source>writing ended early{which}</source>
        <translation>das Schreiben endete vorzeitig{which}</translation>
    </message>
    <message>
        <source>they are {by} ns from the reference clock after {time} s, the sync window allows {limit} ns</source>
        <translation>sie liegen nach {time} s um {by} ns neben der Referenzuhr, das Sync-Fenster erlaubt {limit} ns</translation>
    </message>
    <message>
        <source>{slave} {by} ns from the reference clock after {time} s, the sync window allows {limit} ns</source>
        <translation>{slave} {by} ns neben der Referenzuhr nach {time} s, das Sync-Fenster erlaubt {limit} ns</translation>
    </message>
    <message>
        <source>they did not stay within {limit} ns of the reference clock for {settle} ms in {time} s</source>
        <translation>sie blieben in {time} s nie {settle} ms lang innerhalb von {limit} ns an der Referenzuhr</translation>
    </message>
    <message>
        <source>the reference clock has been away for {time} s</source>
        <translation>die Referenzuhr ist seit {time} s weg</translation>
    </message>
    <message>
        <source>expected {wanted}, read {read}</source>
        <translation>erwartet {wanted}, gelesen {read}</translation>
    </message>
    <message>
        <source>{comment}: expected {wanted}, read {read}</source>
        <translation>{comment}: erwartet {wanted}, gelesen {read}</translation>
    </message>
    <message>
        <source>EoE result 0x{code}</source>
        <translation>EoE-Ergebnis 0x{code}</translation>
    </message>
    <message>
        <source>SoE error 0x{code}</source>
        <translation>SoE-Fehler 0x{code}</translation>
    </message>
    <message>
        <source>AoE error 0x{code}</source>
        <translation>AoE-Fehler 0x{code}</translation>
    </message>
    <message>
        <source>FoE error 0x{code}</source>
        <translation>FoE-Fehler 0x{code}</translation>
    </message>
    <message>
        <source>its header promises {promised} bytes of data, {count} bytes came with the header</source>
        <translation>ihr Header verspricht {promised} Bytes Daten, mit dem Header kamen {count} Bytes</translation>
    </message>
    <message>
        <source>SDO command 0x{command} is not a request</source>
        <translation>SDO-Kommando 0x{command} ist keine Anfrage</translation>
    </message>
    <message>
        <source>it is not an SDO request</source>
        <translation>es ist keine SDO-Anfrage</translation>
    </message>
    <message>
        <source>service {number} does not exist</source>
        <translation>den Dienst {number} gibt es nicht</translation>
    </message>
    <message>
        <source>type {number} does not exist</source>
        <translation>den Typ {number} gibt es nicht</translation>
    </message>
    <message>
        <source>opcode {number} does not exist</source>
        <translation>den Opcode {number} gibt es nicht</translation>
    </message>
    <message>
        <source>operation {number} does not exist</source>
        <translation>die Operation {number} gibt es nicht</translation>
    </message>
    <message>
        <source>{bytes} bytes, service {number}</source>
        <translation>{bytes} Bytes, Dienst {number}</translation>
    </message>
    <message>
        <source>"{text}" is no {type}</source>
        <translation>"{text}" ist kein {type}</translation>
    </message>
    <message>
        <source>the object list is too short</source>
        <translation>die Objektliste ist zu kurz</translation>
    </message>
    <message>
        <source>the object description is too short</source>
        <translation>die Objektbeschreibung ist zu kurz</translation>
    </message>
    <message>
        <source>the description of 0x{index}:{sub} is too short</source>
        <translation>die Beschreibung von 0x{index}:{sub} ist zu kurz</translation>
    </message>
    <message>
        <source>it is CoE service {number}</source>
        <translation>es ist der CoE-Dienst {number}</translation>
    </message>
    <message>
        <source>opcode {number} is not a request</source>
        <translation>der Opcode {number} ist keine Anfrage</translation>
    </message>
    <message>
        <source>the request is too short</source>
        <translation>die Anfrage ist zu kurz</translation>
    </message>
    <message>
        <source>the error is too short</source>
        <translation>der Fehler ist zu kurz</translation>
    </message>
    <message>
        <source>opcode {number} is not a response</source>
        <translation>der Opcode {number} ist keine Antwort</translation>
    </message>
    <message>
        <source>category {category} at word 0x{word} {reason}</source>
        <translation>die Kategorie {category} bei Wort 0x{word} {reason}</translation>
    </message>
    <message>
        <source>of {words} words reaches beyond the image</source>
        <translation>mit {words} Worten reicht über das Abbild hinaus</translation>
    </message>
    <message>
        <source>ends inside string {number} of {count}</source>
        <translation>endet mitten in Zeichenkette {number} von {count}</translation>
    </message>
    <message>
        <source>is too short for general information</source>
        <translation>ist zu kurz für allgemeine Angaben</translation>
    </message>
    <message>
        <source>holds a part of a SyncManager</source>
        <translation>enthält nur einen Teil eines SyncManagers</translation>
    </message>
    <message>
        <source>ends inside PDO 0x{index}</source>
        <translation>endet mitten in PDO 0x{index}</translation>
    </message>
    <message>
        <source>holds a part of a DC mode</source>
        <translation>enthält nur einen Teil einer DC-Betriebsart</translation>
    </message>
    <message>
        <source>a pcap or pcapng capture; {words}</source>
        <translation>eine pcap- oder pcapng-Aufzeichnung; {words}</translation>
    </message>
    <message>
        <source>a capture of Ethernet frames; this one holds {reason}</source>
        <translation>eine Aufzeichnung von Ethernet-Frames; diese enthält {reason}</translation>
    </message>
    <message>
        <source>a frame's time stamp of {time} s is outside of the years 1708 to 2292</source>
        <translation>der Zeitstempel {time} s eines Frames liegt außerhalb der Jahre 1708 bis 2292</translation>
    </message>
    <message>
        <source>a capture with EtherCAT frames and their answers</source>
        <translation>eine Aufzeichnung mit EtherCAT-Frames und ihren Antworten</translation>
    </message>
    <message>
        <source>a capture of whole frames; {cut} of its {frames} were captured in part only</source>
        <translation>eine Aufzeichnung ganzer Frames; {cut} von ihren {frames} sind nur teilweise aufgezeichnet</translation>
    </message>
    <message>
        <source>a recording that "synclinectl run --record" has written</source>
        <translation>eine Aufnahme, die "synclinectl run --record" geschrieben hat</translation>
    </message>
    <message>
        <source>it is damaged or cut off ({words})</source>
        <translation>sie ist beschädigt oder abgeschnitten ({words})</translation>
    </message>
    <message>
        <source>it has {count} slaves, the recording has {other}</source>
        <translation>sie hat {count} Slaves, die Aufnahme hat {other}</translation>
    </message>
    <message>
        <source>a {kind} has at most {bytes} bytes</source>
        <translation>{kind}: höchstens {bytes} Bytes</translation>
    </message>
    <message>
        <source>{value} is none of {words}</source>
        <translation>{value} ist keines von {words}</translation>
    </message>
    <message>
        <source>slaves in the project: {count}, counted from 0</source>
        <translation>Slaves im Projekt: {count}, von 0 an gezählt</translation>
    </message>
    <message>
        <source>slave {position} has no such item</source>
        <translation>Slave {position} hat keinen solchen Eintrag</translation>
    </message>
    <message>
        <source>there is no such item</source>
        <translation>es gibt keinen solchen Eintrag</translation>
    </message>
    <message>
        <source>list all with "synclinectl project keys"</source>
        <translation>alle zeigt "synclinectl project keys"</translation>
    </message>
    <message>
        <source>a slave has the ports A to D</source>
        <translation>ein Slave hat die Ports A bis D</translation>
    </message>
    <message>
        <source>{value} is more than {devices} take: 0 to {most}</source>
        <translation>{value} ist mehr, als {devices} annehmen: 0 bis {most}</translation>
    </message>
    <message>
        <source>{devices} set it themselves by the SYNC signals</source>
        <translation>{devices} stellen es selbst nach den SYNC-Signalen ein</translation>
    </message>
    <message>
        <source>{devices} do not have {type}</source>
        <translation>{devices} haben {type} nicht</translation>
    </message>
    <message>
        <source>{devices} have pins 1 to {last}</source>
        <translation>{devices} haben die Pins 1 bis {last}</translation>
    </message>
    <message>
        <source>{devices} have no function {number}</source>
        <translation>{devices} haben keine Funktion {number}</translation>
    </message>
    <message>
        <source>slave.{position}.{key}: {reason}</source>
        <translation>slave.{position}.{key}: {reason}</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>the ENI goes to this file</source>
        <translation>die ENI kommt in diese Datei</translation>
    </message>
    <message>
        <source>it is a disk, not a file</source>
        <translation>es ist ein Laufwerk, keine Datei</translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation>es ist ein Socket, keine Datei</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>es ist leer</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>es hat keine Zeilen</translation>
    </message>
    <message>
        <source>it holds no cyclic frame that came back</source>
        <translation>er enthält keinen zyklischen Frame, der zurückkam</translation>
    </message>
    <message>
        <source>its times do not tell the cycles apart</source>
        <translation>seine Zeiten unterscheiden die Zyklen nicht</translation>
    </message>
    <message>
        <source>its time {time} ns is no date of this century</source>
        <translation>seine Zeit {time} ns ist kein Datum dieses Jahrhunderts</translation>
    </message>
    <message>
        <source>a log of the master synchronisation, or the table that "synclinectl run --csv" writes</source>
        <translation>ein Log der Master-Synchronisation oder die Tabelle, die „synclinectl run --csv“ schreibt</translation>
    </message>
    <message>
        <source>its name must end in .png, .svg or .pdf</source>
        <translation>der Name muss auf .png, .svg oder .pdf enden</translation>
    </message>
    <message>
        <source>the view needs more room; leave the size out to have what suits it</source>
        <translation>die Ansicht braucht mehr Platz; ohne Größenangabe bekommt sie, was zu ihr passt</translation>
    </message>
    <message>
        <source>it is no signal that can be shown here, such as dcm_error_ns or deviation_ns@1</source>
        <translation>es ist kein Signal, das hier gezeigt werden kann, wie dcm_error_ns oder deviation_ns@1</translation>
    </message>
    <message>
        <source>no slave with SYNC0 whose arrivals are known</source>
        <translation>kein Slave mit SYNC0, dessen Ankünfte bekannt sind</translation>
    </message>
    <message>
        <source>slaves in the recording: {count}, counted from 0</source>
        <translation>Slaves in der Aufzeichnung: {count}, gezählt ab 0</translation>
    </message>
    <message>
        <source>it holds nothing of the recording, which is {time} s long</source>
        <translation>darin liegt nichts von der Aufzeichnung, die {time} s lang ist</translation>
    </message>
    <message>
        <source>{file} has it no longer</source>
        <translation>{file} enthält es nicht mehr</translation>
    </message>
    <message>
        <source>its ESI files are missing here</source>
        <translation>seine ESI-Dateien fehlen hier</translation>
    </message>
    <message>
        <source>Device: {reason}</source>
        <translation>Gerät: {reason}</translation>
    </message>
    <message>
        <source>Device {device}: {reason}</source>
        <translation>Gerät {device}: {reason}</translation>
    </message>
    <message>
        <source>{attribute}="{text}" {reason}</source>
        <translation>{attribute}="{text}" {reason}</translation>
    </message>
    <message>
        <source>is no rule</source>
        <translation>ist keine Regel</translation>
    </message>
    <message>
        <source>is no mode</source>
        <translation>ist keine Betriebsart</translation>
    </message>
    <message>
        <source>is no scale</source>
        <translation>ist keine Teilung</translation>
    </message>
    <message>
        <source>is nothing that has signals</source>
        <translation>ist nichts, was Signale hat</translation>
    </message>
    <message>
        <source>is no pair of limits, the lower one first</source>
        <translation>ist kein Paar von Grenzen, die untere zuerst</translation>
    </message>
    <message>
        <source>the project in the recording has no view of that name</source>
        <translation>das Projekt in der Aufzeichnung hat keine Ansicht dieses Namens</translation>
    </message>
    <message>
        <source>it is no signal that can be drawn, such as lost_frames_total, al_status@1 or a variable's name</source>
        <translation>das ist kein Signal, das gezeichnet werden kann, wie lost_frames_total, al_status@1 oder der Name einer Variablen</translation>
    </message>
    <message>
        <source>is no synchronisation type</source>
        <translation>ist keine Synchronisationsart</translation>
    </message>
    <message>
        <source>is no Ethernet address</source>
        <translation>ist keine Ethernet-Adresse</translation>
    </message>
    <message>
        <source>the file holds {names}</source>
        <translation>die Datei enthält {names}</translation>
    </message>
    <message>
        <source>it defines entities of its own, which are not read</source>
        <translation>sie definiert eigene Entities, die nicht gelesen werden</translation>
    </message>
    <message>
        <source>more than {most} elements</source>
        <translation>mehr als {most} Elemente</translation>
    </message>
    <message>
        <source>it has {count} elements, attributes and comments of less than {bytes} bytes each, as no tool writes them</source>
        <translation>sie hat {count} Elemente, Attribute und Kommentare mit je weniger als {bytes} Byte, wie kein Werkzeug sie schreibt</translation>
    </message>
    <message>
        <source>an element with more than {most} attributes</source>
        <translation>ein Element mit mehr als {most} Attributen</translation>
    </message>
    <message>
        <source>more than {most} attributes</source>
        <translation>mehr als {most} Attribute</translation>
    </message>
    <message>
        <source>elements are nested more than {most} deep</source>
        <translation>Elemente sind mehr als {most} tief geschachtelt</translation>
    </message>
    <message>
        <source>{reason} (&lt;{element}&gt;)</source>
        <translation>{reason} (&lt;{element}&gt;)</translation>
    </message>
    <message>
        <source>an end tag does not match its start tag</source>
        <translation>ein End-Tag passt nicht zu seinem Start-Tag</translation>
    </message>
    <message>
        <source>an attribute is written wrongly</source>
        <translation>ein Attribut ist falsch geschrieben</translation>
    </message>
    <message>
        <source>an element is not complete</source>
        <translation>ein Element ist nicht vollständig</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>ein Text endet nicht</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>ein Kommentar endet nicht</translation>
    </message>
    <message>
        <source>the XML declaration is wrong</source>
        <translation>die XML-Deklaration ist falsch</translation>
    </message>
    <message>
        <source>a &lt;!...&gt; section does not end</source>
        <translation>ein &lt;!...&gt;-Abschnitt endet nicht</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the elements are nested too deeply</source>
        <translation>die Elemente sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>the text ends too early or is no XML</source>
        <translation>der Text endet zu früh oder ist kein XML</translation>
    </message>
    <message>
        <source>another window has it open ({who}): save under another name</source>
        <translation>ein anderes Fenster hat es offen ({who}): unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>a mailbox error reply that cannot be read</source>
        <translation>eine Mailbox-Fehlerantwort, die nicht lesbar ist</translation>
    </message>
    <message>
        <source>the request is longer than the mailbox</source>
        <translation>die Anfrage ist länger als die Mailbox</translation>
    </message>
    <message>
        <source>its mailbox holds no message</source>
        <translation>seine Mailbox enthält keine Nachricht</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>etwas anderes</translation>
    </message>
    <message>
        <source>the file of a machine is a scenario of its own</source>
        <translation>die Datei einer Maschine ist ein Szenario für sich</translation>
    </message>
    <message>
        <source>the slaves are those of the machine</source>
        <translation>die Slaves sind die der Maschine</translation>
    </message>
    <message>
        <source>stands in the file of the machine</source>
        <translation>steht in der Datei der Maschine</translation>
    </message>
    <message>
        <source>{device} is not in the file</source>
        <translation>{device} ist nicht in der Datei</translation>
    </message>
    <message>
        <source>Before that, at {since}, {slave} had left the sync window as well ({deviation}, limit {limit}); {count} in all.</source>
        <translation>Davor, bei {since}, hatte auch {slave} das Sync-Window verlassen ({deviation}, Grenze {limit}); {count} insgesamt.</translation>
    </message>
    <message>
        <source>Outputs are forced</source>
        <translation>Ausgänge sind erzwungen</translation>
    </message>
    <message>
        <source>No output is forced any more</source>
        <translation>Kein Ausgang ist mehr erzwungen</translation>
    </message>
    <message>
        <source>They stay at the value that somebody set by hand, whatever the application calculates.</source>
        <translation>Sie bleiben auf dem Wert, den jemand von Hand gesetzt hat, was immer die Anwendung berechnet.</translation>
    </message>
    <message>
        <source>Release them before the machine is left to itself.</source>
        <translation>Geben Sie sie frei, bevor die Maschine sich selbst überlassen wird.</translation>
    </message>
    <message>
        <source>outputs are forced: {bits:# bit|# bits}</source>
        <translation>Ausgänge sind erzwungen: {bits:# Bit|# Bits}</translation>
    </message>
    <message>
        <source>no output is forced any more</source>
        <translation>kein Ausgang ist mehr erzwungen</translation>
    </message>
    <message>
        <source>the process image has no such bits</source>
        <translation>das Prozessabbild hat keine solchen Bits</translation>
    </message>
    <message>
        <source>the process image has no such variable of 1 to 64 bits: use its name, or SLAVE.ENTRY with the slave's position or name, e.g. "3.Position actual value"</source>
        <translation>das Prozessabbild hat keine solche Variable von 1 bis 64 Bit: ihren Namen angeben, oder SLAVE.EINTRAG mit Position oder Name des Slaves, z. B. „3.Position actual value“</translation>
    </message>
    <message>
        <source>it could be any of {names}</source>
        <translation>es könnte jede von diesen sein: {names}</translation>
    </message>
    <message>
        <source>the network "{name}" runs on it: choose another link or take that one offline</source>
        <translation>Das Netzwerk „{name}“ läuft darauf: einen anderen Link wählen oder jenes offline nehmen</translation>
    </message>
    <message>
        <source>; not all words could be put back: write them again before power is switched off</source>
        <translation>; nicht alle Wörter ließen sich wiederherstellen: vor dem Ausschalten noch einmal schreiben</translation>
    </message>
    <message>
        <source>; the old content was put back</source>
        <translation>; der alte Inhalt wurde wiederhergestellt</translation>
    </message>
    <message>
        <source>block {number} holds other cycles than it says</source>
        <translation>Block {number} enthält andere Zyklen, als er angibt</translation>
    </message>
    <message>
        <source>its lists of watched variables are none</source>
        <translation>ihre Listen beobachteter Variablen sind keine</translation>
    </message>
    <message>
        <source>block {number} is none</source>
        <translation>Block {number} ist keiner</translation>
    </message>
    <message>
        <source>it has no cycle time</source>
        <translation>sie hat keine Zykluszeit</translation>
    </message>
    <message>
        <source>it reads other words than it is asked for at word 0x{word}</source>
        <translation>bei Wort 0x{word} liest es andere Wörter als die verlangten</translation>
    </message>
    <message>
        <source>it was away for a moment</source>
        <translation>er war einen Augenblick lang weg</translation>
    </message>
    <message>
        <source>its slaves are not numbered in a row</source>
        <translation>ihre Slaves sind nicht fortlaufend nummeriert</translation>
    </message>
    <message>
        <source>slave {position} is not another slave of the {count} on the bus</source>
        <translation>Slave {position} ist kein anderer der {count} Slaves am Bus</translation>
    </message>
    <message>
        <source>the sums of {signal} in block {number} are not those of its values</source>
        <translation>die Summen von {signal} in Block {number} sind nicht die seiner Werte</translation>
    </message>
    <message>
        <source>there are values of blocks that are not there</source>
        <translation>es gibt Werte von Blöcken, die es nicht gibt</translation>
    </message>
    <message>
        <source>use sim:FILE[?virtual][&amp;seed=N][&amp;network=N], nic:NAME or replay:FILE</source>
        <translation>sim:DATEI[?virtual][&amp;seed=N][&amp;network=N], nic:NAME oder replay:DATEI angeben</translation>
    </message>
    <message>
        <source>{signal} of block {number} cannot be read</source>
        <translation>{signal} von Block {number} ist nicht lesbar</translation>
    </message>
    <message>
        <source>expected {wanted}, found {found}</source>
        <translation>erwartet war {wanted}, gefunden wurde {found}</translation>
    </message>
    <message>
        <source>it is at position {position}</source>
        <translation>es steht an Position {position}</translation>
    </message>
    <message>
        <source>{limit} is the shortest cycle that {family} {devices} take</source>
        <translation>{limit} ist der kürzeste Zyklus, den {family} {devices} annehmen</translation>
    </message>
    <message>
        <source>{limit} is the longest cycle that {family} {devices} take</source>
        <translation>{limit} ist der längste Zyklus, den {family} {devices} annehmen</translation>
    </message>
    <message>
        <source>{family} {devices} take multiples of {step}</source>
        <translation>{family} {devices} nehmen Vielfache von {step}</translation>
    </message>
    <message>
        <source>{family} {devices} need multiples of {step}; {otherwise}</source>
        <translation>{family} {devices} brauchen Vielfache von {step}; {otherwise}</translation>
    </message>
    <message>
        <source>{limit} is the shortest cycle that its object 0x1C32:05 names</source>
        <translation>{limit} ist der kürzeste Zyklus, den sein Objekt 0x1C32:05 nennt</translation>
    </message>
    <message>
        <source>its operation mode {mode} has a SYNC0 every {cycle}, which is neither a multiple nor a part of it</source>
        <translation>seine Betriebsart {mode} hat alle {cycle} ein SYNC0: weder ein Vielfaches noch ein Teil davon</translation>
    </message>
    <message>
        <source>its operation mode {mode} divides the cycle by {divisor}, which leaves a rest</source>
        <translation>seine Betriebsart {mode} teilt den Zyklus durch {divisor}, und es bleibt ein Rest</translation>
    </message>
    <message>
        <source>its object 0x60C2 (interpolation time) cannot express it</source>
        <translation>sein Objekt 0x60C2 (Interpolationszeit) kann ihn nicht ausdrücken</translation>
    </message>
    <message>
        <source>the bus cycle is {shortest} to {longest}</source>
        <translation>der Buszyklus beträgt {shortest} bis {longest}</translation>
    </message>
    <message>
        <source>the cyclic frames take {time} of wire time</source>
        <translation>die zyklischen Frames brauchen {time} auf der Leitung</translation>
    </message>
    <message>
        <source>the cyclic frames take {time} of wire time and about {travel} through the slaves</source>
        <translation>die zyklischen Frames brauchen {time} auf der Leitung und etwa {travel} durch die Slaves</translation>
    </message>
    <message>
        <source>it should be the first on the bus</source>
        <translation>er sollte der erste am Bus sein</translation>
    </message>
    <message>
        <source>it should follow {slave}</source>
        <translation>er sollte auf {slave} folgen</translation>
    </message>
    <message>
        <source>it should hang at port {port} of {slave}</source>
        <translation>er sollte an Port {port} von {slave} hängen</translation>
    </message>
    <message>
        <source>the file is gone: it, or its folder, was deleted or moved while it was written</source>
        <translation>die Datei ist fort: sie oder ihr Ordner wurde während des Schreibens gelöscht oder verschoben</translation>
    </message>
    <message>
        <source>only {left} MiB are left on the disk; the black box is whole up to here</source>
        <translation>nur noch {left} MiB sind auf dem Datenträger frei; die Blackbox ist bis hierher ganz</translation>
    </message>
    <message>
        <source>another program writes to a black box of this name: use another one</source>
        <translation>ein anderes Programm schreibt in eine Blackbox dieses Namens: einen anderen verwenden</translation>
    </message>
    <message>
        <source>the disk has {left} MiB left, a black box needs {needed} MiB with what is kept free</source>
        <translation>auf dem Datenträger sind {left} MiB frei, eine Blackbox braucht mit dem, was frei bleibt, {needed} MiB</translation>
    </message>
    <message>
        <source>A SYNC time that neither registers nor ENI hold</source>
        <translation>Eine SYNC-Zeit, die weder Register noch ENI fassen</translation>
    </message>
    <message>
        <source>Choose a shorter time.</source>
        <translation>Eine kürzere Zeit wählen.</translation>
    </message>
    <message>
        <source>The cycle of SYNC0 is {time}; registers and ENI hold up to {most}.</source>
        <translation>Der Zyklus von SYNC0 ist {time}; Register und ENI fassen höchstens {most}.</translation>
    </message>
    <message>
        <source>SYNC1 would come {time} after SYNC0; registers and ENI hold up to {most}.</source>
        <translation>SYNC1 käme {time} nach SYNC0; Register und ENI fassen höchstens {most}.</translation>
    </message>
    <message>
        <source>The shift of SYNC0 is {time}; registers and ENI hold up to {most}.</source>
        <translation>Die Verschiebung von SYNC0 ist {time}; Register und ENI fassen höchstens {most}.</translation>
    </message>
    <message>
        <source>The shift of SYNC0 is longer than its cycle</source>
        <translation>Die Verschiebung von SYNC0 ist länger als ihr Zyklus</translation>
    </message>
    <message>
        <source>Choose a shift within the cycle of SYNC0.</source>
        <translation>Eine Verschiebung innerhalb des Zyklus von SYNC0 wählen.</translation>
    </message>
    <message>
        <source>SYNC0 is shifted by {shift}, its cycle is {cycle}: the shift counts modulo the cycle, and SYNC0 starts later.</source>
        <translation>SYNC0 ist um {shift} verschoben, ihr Zyklus ist {cycle}: Die Verschiebung zählt modulo Zyklus, und SYNC0 beginnt später.</translation>
    </message>
    <message>
        <source>Times of a SYNC signal that does not come</source>
        <translation>Zeiten eines SYNC-Signals, das nicht kommt</translation>
    </message>
    <message>
        <source>Choose an operation mode with that signal, or set its times back to auto.</source>
        <translation>Eine Betriebsart mit diesem Signal wählen oder seine Zeiten auf auto zurücksetzen.</translation>
    </message>
    <message>
        <source>{file} is what {what} reads and would be lost; name another file</source>
        <translation>{file} ist, was {what} liest, und ginge verloren; nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>{signal} is set, and the operation mode &quot;{mode}&quot; does not generate it: what is set has no effect.</source>
        <translation>{signal} ist eingestellt, und die Betriebsart „{mode}“ erzeugt es nicht: Die Einstellung bleibt ohne Wirkung.</translation>
    </message>
    <message>
        <source>{signal} is set, and distributed clocks are off for this slave: what is set has no effect.</source>
        <translation>{signal} ist eingestellt, und verteilte Uhren sind für diesen Slave aus: Die Einstellung bleibt ohne Wirkung.</translation>
    </message>
    <message>
        <source>Outputs stay as they are when frames stop</source>
        <translation>Ausgänge bleiben stehen, wenn keine Frames mehr kommen</translation>
    </message>
    <message>
        <source>Let the process data watchdog guard them, unless something else stops the machine.</source>
        <translation>Den Prozessdaten-Watchdog über sie wachen lassen, wenn nicht anderes die Maschine stillsetzt.</translation>
    </message>
    <message>
        <source>The process data watchdog is switched off: outputs keep their last values when frames stop.</source>
        <translation>Der Prozessdaten-Watchdog ist abgeschaltet: Ausgänge behalten ihre letzten Werte, wenn keine Frames mehr kommen.</translation>
    </message>
    <message>
        <source>Outputs do not trigger the process data watchdog: they keep their last values when frames stop.</source>
        <translation>Ausgänge lösen den Prozessdaten-Watchdog nicht aus: Sie behalten ihre letzten Werte, wenn keine Frames mehr kommen.</translation>
    </message>
    <message>
        <source>Two slaves are known by the same alias</source>
        <translation>Zwei Slaves werden an demselben Alias erkannt</translation>
    </message>
    <message>
        <source>Give each of them an alias of its own, here and in its EEPROM.</source>
        <translation>Jedem einen eigenen Alias geben, hier und in seinem EEPROM.</translation>
    </message>
    <message>
        <source>It is known by the alias {alias}, and so is {slave}: nobody could tell if they were exchanged.</source>
        <translation>Er wird am Alias {alias} erkannt, und {slave} auch: Niemand sähe, wenn sie vertauscht wären.</translation>
    </message>
    <message>
        <source>A device with outputs gets none</source>
        <translation>Ein Gerät mit Ausgängen bekommt keine</translation>
    </message>
    <message>
        <source>Assign a PDO, if the device is to be told anything.</source>
        <translation>Ein PDO zuordnen, wenn das Gerät etwas gesagt bekommen soll.</translation>
    </message>
    <message>
        <source>The device has outputs, and no PDO is assigned for them: it gets no set values.</source>
        <translation>Das Gerät hat Ausgänge, und für sie ist kein PDO zugeordnet: Es bekommt keine Sollwerte.</translation>
    </message>
    <message>
        <source>Exchanged with each other they pass the check of their aliases, and get each other&apos;s outputs</source>
        <translation>Miteinander vertauscht bestehen sie die Prüfung ihrer Aliase und bekommen die Ausgänge des anderen</translation>
    </message>
    <message>
        <source>Give each slave an alias of its own, in the file and in the device</source>
        <translation>Jedem Slave einen eigenen Alias geben, in der Datei und im Gerät</translation>
    </message>
    <message>
        <source>its alias is checked to be {alias}, and so is that of {slave}</source>
        <translation>sein Alias wird auf {alias} geprüft, und der von {slave} auch</translation>
    </message>
    <message>
        <source>{count} of the clocks do not keep what is written to 0x0920 and 0x0928, the first one reads {read} in {register} instead of {written}</source>
        <translation>{count} der Uhren behalten nicht, was nach 0x0920 und 0x0928 geschrieben wird, die erste liest {read} in {register} statt {written}</translation>
    </message>
    <message>
        <source>Frames of other programs reach the bus</source>
        <translation>Frames anderer Programme erreichen den Bus</translation>
    </message>
    <message>
        <source>Each takes the wire from the master's frames, which come later by its length.</source>
        <translation>Jeder nimmt den Frames des Masters die Leitung, die um seine Länge später kommen.</translation>
    </message>
    <message>
        <source>Give the adapter no IP address and no other protocol (DHCP, IPv6, LLDP, a network manager), and put no switch with other devices between the host and the first slave.</source>
        <translation>Dem Adapter keine IP-Adresse und kein anderes Protokoll geben (DHCP, IPv6, LLDP, einen Netzwerkmanager), und keinen Switch mit anderen Geräten zwischen Host und ersten Slave setzen.</translation>
    </message>
    <message>
        <source>{slave} has counted {count:# frame|# frames} that it could not process (0x030C) and that were not damaged, from {since} on: they are none of the master's.</source>
        <translation>{slave} hat {count:# Frame|# Frames} gezählt, die er nicht verarbeiten konnte (0x030C) und die nicht beschädigt waren, ab {since}: sie sind nicht vom Master.</translation>
    </message>
    <message>
        <source>"{text}" is read as {value}</source>
        <translation>"{text}" wird als {value} gelesen</translation>
    </message>
    <message>
        <source>"{text}" has an odd number of digits; a zero is put in front</source>
        <translation>"{text}" hat eine ungerade Zahl von Ziffern; eine Null wird vorangestellt</translation>
    </message>
    <message>
        <source>hexadecimal numbers of this file begin with 0x instead of #x</source>
        <translation>hexadezimale Zahlen dieser Datei beginnen mit 0x statt mit #x</translation>
    </message>
    <message>
        <source>the text is not UTF-8, though it should be; read as {encoding}</source>
        <translation>der Text ist nicht UTF-8, obwohl er es sein sollte; gelesen als {encoding}</translation>
    </message>
    <message>
        <source>the byte 0x{byte} is no letter of the encoding {name}; read as a control character</source>
        <translation>das Byte 0x{byte} ist kein Buchstabe der Kodierung {name}; gelesen als Steuerzeichen</translation>
    </message>
    <message>
        <source>it names the encoding {name}, but its letters stand alone as Western ones do; read as {encoding}</source>
        <translation>sie nennt die Kodierung {name}, aber ihre Buchstaben stehen einzeln wie westliche; gelesen als {encoding}</translation>
    </message>
    <message>
        <source>it names the encoding {name}, but its letters come in pairs as those of GB 2312; read as {encoding}</source>
        <translation>sie nennt die Kodierung {name}, aber ihre Buchstaben stehen in Paaren wie die von GB 2312; gelesen als {encoding}</translation>
    </message>
    <message>
        <source>Transition is missing; taken for PS</source>
        <translation>Transition fehlt; angenommen wird PS</translation>
    </message>
    <message>
        <source>Name is missing; taken from Desc</source>
        <translation>Name fehlt; aus Desc übernommen</translation>
    </message>
    <message>
        <source>MaxInstances is missing; taken for 1</source>
        <translation>MaxInstances fehlt; angenommen wird 1</translation>
    </message>
    <message>
        <source>BitLen is missing; {bits} bits by the data type {type}</source>
        <translation>BitLen fehlt; {bits} Bits nach dem Datentyp {type}</translation>
    </message>
    <message>
        <source>the use "{use}" is not known; the FMMU counts as free</source>
        <translation>die Verwendung "{use}" ist nicht bekannt; die FMMU gilt als frei</translation>
    </message>
    <message>
        <source>the use "{use}" is not known; taken from the control byte 0x{control}</source>
        <translation>die Verwendung "{use}" ist nicht bekannt; dem Steuerbyte 0x{control} entnommen</translation>
    </message>
    <message>
        <source>the PDO 0x{index} excludes itself; that is left out</source>
        <translation>das PDO 0x{index} schließt sich selbst aus; das bleibt unbeachtet</translation>
    </message>
    <message>
        <source>the rule "{rule}" for {attribute} is not known</source>
        <translation>die Regel "{rule}" für {attribute} ist nicht bekannt</translation>
    </message>
    <message>
        <source>{attribute} "{text}" is no number of 32 bits and is left out</source>
        <translation>{attribute} "{text}" ist keine Zahl von 32 Bits und bleibt weg</translation>
    </message>
    <message>
        <source>the picture is no hexadecimal data and is left out</source>
        <translation>das Bild besteht nicht aus hexadezimalen Daten und bleibt weg</translation>
    </message>
    <message>
        <source>the dictionary has too many entries; the rest is left out</source>
        <translation>das Objektverzeichnis hat zu viele Einträge; der Rest bleibt weg</translation>
    </message>
    <message>
        <source>the data type is left out: {error}</source>
        <translation>der Datentyp bleibt weg: {error}</translation>
    </message>
    <message>
        <source>the object is left out: {error}</source>
        <translation>das Objekt bleibt weg: {error}</translation>
    </message>
    <message>
        <source>the module is left out: {error}</source>
        <translation>das Modul bleibt weg: {error}</translation>
    </message>
    <message>
        <source>the dictionary is left out: {error}</source>
        <translation>das Objektverzeichnis bleibt weg: {error}</translation>
    </message>
    <message>
        <source>the file is left out: {error}</source>
        <translation>die Datei bleibt weg: {error}</translation>
    </message>
    <message>
        <source>Device is left out: {error}</source>
        <translation>ein Gerät bleibt weg: {error}</translation>
    </message>
    <message>
        <source>Device {device} is left out: {error}</source>
        <translation>Gerät {device} bleibt weg: {error}</translation>
    </message>
    <message>
        <source>"{name}" is another file, which is not read here</source>
        <translation>"{name}" ist eine andere Datei, die hier nicht gelesen wird</translation>
    </message>
    <message>
        <source>the dictionary "{name}" is in another file, which is not read here</source>
        <translation>das Objektverzeichnis "{name}" steht in einer anderen Datei, die hier nicht gelesen wird</translation>
    </message>
    <message>
        <source>"{name}" is no dictionary file: its root is &lt;{root}&gt;, not &lt;EtherCATDict&gt;</source>
        <translation>"{name}" ist keine Datei mit einem Objektverzeichnis: ihre Wurzel ist &lt;{root}&gt;, nicht &lt;EtherCATDict&gt;</translation>
    </message>
    <message>
        <source>no file describes the module 0x{module} of the slot "{slot}"</source>
        <translation>keine Datei beschreibt das Modul 0x{module} des Steckplatzes "{slot}"</translation>
    </message>
    <message>
        <source>the device catalogue is made again: {reason}</source>
        <translation>der Gerätekatalog wird neu angelegt: {reason}</translation>
    </message>
    <message>
        <source>it was damaged: {words}</source>
        <translation>er war beschädigt: {words}</translation>
    </message>
    <message>
        <source>it is of version {version}, this program uses version {own}</source>
        <translation>er hat die Version {version}, dieses Programm verwendet die Version {own}</translation>
    </message>
    <message>
        <source>the ESI files are read anew each time: {error}</source>
        <translation>die ESI-Dateien werden jedes Mal neu gelesen: {error}</translation>
    </message>
    <message>
        <source>{place}: {reason}</source>
        <translation>{place}: {reason}</translation>
    </message>
    <message>
        <source>{sentence}.</source>
        <translation>{sentence}.</translation>
    </message>
    <message>
        <source>{sentence} {next}</source>
        <translation>{sentence} {next}</translation>
    </message>
    <message>
        <source>: {reason}</source>
        <translation>: {reason}</translation>
    </message>
    <message>
        <source>{code} ({meaning})</source>
        <translation>{code} ({meaning})</translation>
    </message>
    <message>
        <source>Watched for</source>
        <translation>Beobachtet</translation>
    </message>
    <message>
        <source>State of the master</source>
        <translation>Zustand des Masters</translation>
    </message>
    <message>
        <source>Slaves against their reference clock</source>
        <translation>Slaves gegen ihre Referenzuhr</translation>
    </message>
    <message>
        <source>Reference clock against the master</source>
        <translation>Referenzuhr gegen den Master</translation>
    </message>
    <message>
        <source>SM2 events missed</source>
        <translation>Verpasste SM2-Ereignisse</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Verlorene Frames</translation>
    </message>
    <message>
        <source>Cycles of a slave were not finished because frames came too soon</source>
        <translation>Ein Slave wurde mit Zyklen nicht fertig, weil Frames zu früh kamen</translation>
    </message>
    <message>
        <source>Cycles with another working counter than expected</source>
        <translation>Zyklen mit anderem Working Counter als erwartet</translation>
    </message>
    <message>
        <source>Cycles left out by the host</source>
        <translation>Vom Rechner ausgelassene Zyklen</translation>
    </message>
    <message>
        <source>Disturbances</source>
        <translation>Störungen</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>NOT KEPT</source>
        <translation>NICHT ERFÜLLT</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>as long as it was</source>
        <translation>so lange, wie es war</translation>
    </message>
    <message>
        <source>OP at the end</source>
        <translation>am Ende OP</translation>
    </message>
    <message>
        <source>in sync throughout</source>
        <translation>durchweg synchron</translation>
    </message>
    <message>
        <source>no error, no warning</source>
        <translation>kein Fehler, keine Warnung</translation>
    </message>
    <message>
        <source>never: it was not in sync in OP</source>
        <translation>nie: in OP war es nicht synchron</translation>
    </message>
    <message>
        <source>unknown: a slave does not answer, or it is not told</source>
        <translation>unbekannt: ein Slave antwortet nicht, oder es ist nicht überliefert</translation>
    </message>
    <message>
        <source>not counted: it was never armed</source>
        <translation>nicht gezählt: es wurde nie scharfgeschaltet</translation>
    </message>
    <message>
        <source>no slave has a counter that is known</source>
        <translation>kein Slave hat einen bekannten Zähler</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nicht überliefert</translation>
    </message>
</context>
</TS>
