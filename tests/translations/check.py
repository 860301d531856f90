#!/usr/bin/env python3
"""Checks the catalogues, which lrelease does not: it takes unfinished, empty and damaged translations alike.

    check.py [FOLDER]     the folder of the catalogues

Every message is finished, has the language's number of plural forms, and keeps placeholders, tags, blanks at the ends,
the punctuation at the end and mnemonics; the catalogues hold just what the sources say. One line for each fault; exit
code 1 if there is one."""
import collections
import dataclasses
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).parent.parent.parent
PLURAL_FORMS = {"en": 2, "bg": 2, "uk": 3, "sl": 4}

PLACEHOLDER = re.compile(r"%(?:L?\d{1,2}|L?n)")
# By name: Qt's "<empty>" is a word in brackets.
TAG = re.compile(r"</?(?:a|b|br|code|em|h[1-6]|i|img|li|nobr|ol|p|pre|qt|span|strong|su[bp]|table|t[dhrt]|u|ul)\b[^>]*>")
# One & before a character that can be typed; && is an ampersand to read, &lt; belongs to a text with tags.
MNEMONIC = re.compile(r"(?<!&)(?:&&)*&(?!\w+;)([^\s&])")
CLOSING = re.compile(r"[.:…?!,;]*$")


@dataclasses.dataclass
class Message:
    context: str
    source: str
    comment: str
    numerus: bool
    state: str
    forms: list

    @property
    def key(self):
        return self.context, self.source, self.comment, self.numerus

    def __str__(self):
        return f"{self.context}: {self.source!r}" + (f" ({self.comment})" if self.comment else "")


def text_of(element):
    return "" if element is None else "".join(element.itertext())


def messages(path):
    found = []
    for context in xml.etree.ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            numerus = message.get("numerus") == "yes"
            forms = [text_of(form) for form in translation.iter("numerusform")] if numerus else [text_of(translation)]
            found.append(Message(text_of(context.find("name")), text_of(message.find("source")),
                                 text_of(message.find("comment")), numerus, translation.get("type", ""), forms))
    return found


def blanks(text):
    return text[:len(text) - len(text.lstrip())], text[len(text.rstrip()):]


def form_faults(source, form):
    """What differs between a source and one form of its translation."""
    if sorted(set(PLACEHOLDER.findall(source))) != sorted(set(PLACEHOLDER.findall(form))):
        yield "other placeholders"
    if sorted(TAG.findall(source)) != sorted(TAG.findall(form)):
        yield "other tags"
    if blanks(source) != blanks(form):
        yield "other blanks at the ends"
    if CLOSING.search(source.rstrip()).group() != CLOSING.search(form.rstrip()).group():
        yield "other punctuation at the end"
    if len(MNEMONIC.findall(source)) != len(MNEMONIC.findall(form)):
        yield "a mnemonic lost or added"


def message_faults(message, plural_forms):
    if message.state:
        yield message.state
        return
    if message.numerus and len(message.forms) != plural_forms:
        yield f"{len(message.forms)} plural forms, not {plural_forms}"
    for form in message.forms:
        if form:
            yield from (f"{fault}: {form!r}" for fault in form_faults(message.source, form))
        else:
            yield "empty"


def mnemonic_faults(found):
    """Mnemonics stand for themselves in one menu or dialog: the texts that share a context ending in Menu or Dialog,
    or whose comment names the menu."""
    groups = collections.defaultdict(list)
    for message in found:
        if message.context.endswith(("Menu", "Dialog")) or "menu" in message.comment:
            for letter in MNEMONIC.findall(message.forms[0]):
                groups[message.context, message.comment, letter.lower()].append(message.forms[0])
    for (context, comment, letter), texts in groups.items():
        if len(texts) > 1:
            place = context + (f" ({comment})" if comment else "")
            yield f"{place}: the mnemonic {letter!r} stands for {', '.join(map(repr, texts))}"


def catalogue_faults(path):
    language = path.stem.rsplit("_", 1)[1]
    found = messages(path)
    for message in found:
        if language == "en" and not message.numerus:
            yield f"{message}: English needs plural forms alone"
        yield from (f"{message}: {fault}" for fault in message_faults(message, PLURAL_FORMS[language]))
    counts = collections.Counter(message.key for message in found)
    yield from (f"{key[0]}: {key[1]!r}: stands twice" for key, count in counts.items() if count > 1)
    yield from mnemonic_faults(found)


def difference_faults(catalogue, fresh):
    """Where a catalogue differs from one that lupdate has just made of the sources."""
    have = {message.key: message for message in messages(catalogue)}
    want = {message.key: message for message in messages(fresh)}
    yield from (f"{message}: not in the catalogue" for key, message in want.items() if key not in have)
    yield from (f"{message}: no source says it" for key, message in have.items() if key not in want)


def faults(folder):
    with tempfile.TemporaryDirectory() as fresh:
        subprocess.run([ROOT / "translations" / "update", fresh], check=True)
        for language in PLURAL_FORMS:
            name = f"kriva_{language}.ts"
            yield from (f"{name}: {fault}" for fault in difference_faults(folder / name, pathlib.Path(fresh) / name))
    for path in sorted(folder.glob("*.ts")):
        yield from (f"{path.name}: {fault}" for fault in catalogue_faults(path))


def main():
    found = list(faults(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "translations"))
    print(*found, f"{len(found)} faults in the catalogues", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
