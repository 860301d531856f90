<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Errors</name>
    <message numerus="yes">
        <source>expected %n element(s)</source>
        <translation>
            <numerusform>expected %n element</numerusform>
            <numerusform>expected %n elements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::FramesField</name>
    <message numerus="yes">
        <source>At most %n frame(s): stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</source>
        <translation>
            <numerusform>At most %n frame: stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</numerusform>
            <numerusform>At most %n frames: stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::ImportDialog</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberListField</name>
    <message numerus="yes">
        <source>%n number(s) from %1 to %2, with semicolons between them.</source>
        <translation>
            <numerusform>%n number from %1 to %2, with semicolons between them.</numerusform>
            <numerusform>%n numbers from %1 to %2, with semicolons between them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n number(s) above %1 and below %2, with semicolons between them.</source>
        <translation>
            <numerusform>At most %n number above %1 and below %2, with semicolons between them.</numerusform>
            <numerusform>At most %n numbers above %1 and below %2, with semicolons between them.</numerusform>
        </translation>
    </message>
</context>
</TS>
