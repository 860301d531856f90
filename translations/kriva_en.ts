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
    <name>kriva::ui::ImportDialog</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
</TS>
