<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>CommandLine</name>
    <message numerus="yes">
        <source>%1: %Ln strands left out, which are broken</source>
        <translation>
            <numerusform>%1: %Ln strand left out, which is broken</numerusform>
            <numerusform>%1: %Ln strands left out, which are broken</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::app::HairExchange</name>
    <message numerus="yes">
        <source>%1 imported; %Ln strands left out, which are broken</source>
        <translation>
            <numerusform>%1 imported; %Ln strand left out, which is broken</numerusform>
            <numerusform>%1 imported; %Ln strands left out, which are broken</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::app::MapExchange</name>
    <message numerus="yes">
        <source>There are already %Ln of these files, &apos;%1&apos; among them. Replace them?</source>
        <translation>
            <numerusform>There is already %Ln of these files, &apos;%1&apos;. Replace it?</numerusform>
            <numerusform>There are already %Ln of these files, &apos;%1&apos; among them. Replace them?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln maps written</source>
        <translation>
            <numerusform>%Ln map written</numerusform>
            <numerusform>%Ln maps written</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::app::RecoveryDialog</name>
    <message numerus="yes">
        <source>Last changed %1, %n step(s) to undo</source>
        <translation>
            <numerusform>Last changed %1, %n step to undo</numerusform>
            <numerusform>Last changed %1, %n steps to undo</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::app::StyleFiles</name>
    <message numerus="yes">
        <source>%Ln styles added to yours</source>
        <translation>
            <numerusform>%Ln style added to yours</numerusform>
            <numerusform>%Ln styles added to yours</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HairImportDialog</name>
    <message numerus="yes">
        <source>%Ln strands. In this unit and axis most roots are %1 cm off the skin or further, so they can&apos;t come in: choose another, or Automatic, or export them as they stand on a head.</source>
        <translation>
            <numerusform>%Ln strand. In this unit and axis its root is %1 cm off the skin, so it can&apos;t come in: choose another, or Automatic, or export it as it stands on a head.</numerusform>
            <numerusform>%Ln strands. In this unit and axis most roots are %1 cm off the skin or further, so they can&apos;t come in: choose another, or Automatic, or export them as they stand on a head.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln strands, turned, scaled and moved until their roots lay on the head.</source>
        <translation>
            <numerusform>%Ln strand, turned, scaled and moved until its root lay on the head.</numerusform>
            <numerusform>%Ln strands, turned, scaled and moved until their roots lay on the head.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln strands, their roots on the head. Unit: %1; up: %2.</source>
        <translation>
            <numerusform>%Ln strand, its root on the head. Unit: %1; up: %2.</numerusform>
            <numerusform>%Ln strands, their roots on the head. Unit: %1; up: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HeadImportDialog</name>
    <message numerus="yes">
        <source>%Ln triangles. %1 cm is no usual height for a head, a bust or a body: check the unit and the axis.</source>
        <translation>
            <numerusform>%Ln triangle. %1 cm is no usual height for a head, a bust or a body: check the unit and the axis.</numerusform>
            <numerusform>%Ln triangles. %1 cm is no usual height for a head, a bust or a body: check the unit and the axis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles, %1 cm tall.</source>
        <translation>
            <numerusform>%Ln triangle, %1 cm tall.</numerusform>
            <numerusform>%Ln triangles, %1 cm tall.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles, %1 cm tall; unit and axis are those that the file tells.</source>
        <translation>
            <numerusform>%Ln triangle, %1 cm tall; unit and axis are those that the file tells.</numerusform>
            <numerusform>%Ln triangles, %1 cm tall; unit and axis are those that the file tells.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StatusReadout</name>
    <message numerus="yes">
        <source>%1 of %Ln hairs</source>
        <translation>
            <numerusform>%1 of %Ln hair</numerusform>
            <numerusform>%1 of %Ln hairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hairs</source>
        <translation>
            <numerusform>%Ln hair</numerusform>
            <numerusform>%Ln hairs</numerusform>
        </translation>
    </message>
</context>
</TS>
