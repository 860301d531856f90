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
</TS>
