#!/usr/bin/env python3
"""That the check of the catalogues finds faults planted in small ones, and nothing in a clean one."""
import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.sax.saxutils import escape

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)


def message(source, *forms, comment="", state="", numerus=None):
    numerus = len(forms) > 1 if numerus is None else numerus
    inside = "".join(f"<numerusform>{escape(f)}</numerusform>" for f in forms) if numerus else escape(forms[0])
    return (f'<message numerus="{"yes" if numerus else "no"}"><source>{escape(source)}</source>'
            f'<comment>{escape(comment)}</comment><translation type="{state}">{inside}</translation></message>')


def catalogue(*messages, context="Dialog"):
    return f'<TS version="2.1"><context><name>{context}</name>{"".join(messages)}</context></TS>'


class Catalogues(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, language, *messages, **options):
        path = self.folder / f"kriva_{language}.ts"
        path.write_text(catalogue(*messages, **options), encoding="utf-8")
        return path

    def faults(self, *messages, language="sl", **options):
        return list(check.catalogue_faults(self.write(language, *messages, **options)))

    def assert_fault(self, pattern, *messages, **options):
        found = self.faults(*messages, **options)
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], pattern)

    def test_a_clean_catalogue_has_no_fault(self):
        self.assertEqual(self.faults(
            message("&Save", "&Shrani"), message("%1 of %L2: ", "%L2, %1: "), message("A && B & C", "A && B & C"),
            message("<b>x</b> &lt;", "<b>y</b> &lt;"),
            message("%n point(s)", "%n točka", "%n točki", "%n točke", "%n točk")), [])

    def test_unfinished_vanished_and_empty_are_faults(self):
        for state in ("unfinished", "vanished", "obsolete"):
            self.assert_fault(f"{state}$", message("Save", "Shrani", state=state))
        self.assert_fault("empty$", message("Save", ""))
        self.assert_fault("empty$", message("%n", "%n", "%n", "%n", ""))

    def test_each_language_has_its_number_of_plural_forms(self):
        for language, count in check.PLURAL_FORMS.items():
            self.assertEqual(self.faults(message("%n", *["%n"] * count), language=language), [])
            self.assert_fault("plural forms, not", message("%n", *["%n"] * (count - 1), numerus=True),
                              language=language)

    def test_english_holds_plural_forms_alone(self):
        self.assert_fault("English", message("Save", "Save"), language="en")

    def test_placeholders_are_kept(self):
        for form in ("%1", "%1 %3", "%1 %2 %n", "%1 %L2"):
            self.assert_fault("placeholders", message("%1 %2", form))

    def test_tags_blanks_and_punctuation_are_kept(self):
        self.assert_fault("tags", message("<b>x</b>", "<b>y"))
        self.assert_fault("blanks", message("x ", "y"))
        self.assert_fault("punctuation", message("x…", "y..."))
        self.assert_fault("punctuation", message("x", "y."))

    def test_mnemonics_are_kept_and_stand_for_one_text(self):
        self.assert_fault("mnemonic lost", message("&Save", "Shrani"))
        self.assert_fault("mnemonic lost", message("Save", "&Shrani"))
        twice = message("&Save", "&Shrani"), message("&Open", "Odpri &skladišče")
        self.assert_fault("mnemonic 's' stands for", *twice)
        self.assertEqual(self.faults(*twice, context="Window"), [])
        menu = message("&Save", "&Shrani", comment="File menu"), message("&Stop", "&Stoj", comment="File menu")
        self.assert_fault("mnemonic", *menu, context="Window")

    def test_a_message_stands_once(self):
        self.assert_fault("twice", message("Save", "Shrani"), message("Save", "Shrani"))
        self.assertEqual(self.faults(message("Save", "Shrani"), message("Save", "Shrani", comment="file")), [])

    def test_what_the_sources_do_not_say_and_what_is_missing_are_faults(self):
        have = self.write("sl", message("Save", "Shrani"), message("Old", "Staro"))
        want = self.write("fresh", message("Save", "", state="unfinished"), message("New", "", state="unfinished"))
        self.assertEqual(list(check.difference_faults(have, want)),
                         ["Dialog: 'New': not in the catalogue", "Dialog: 'Old': no source says it"])

    def test_texts_are_found_in_the_sources_under_their_full_class_name(self):
        contexts = set()
        subprocess.run([check.ROOT / "translations" / "update", self.folder], check=True)
        for path in self.folder.glob("*.ts"):
            contexts.update(message.context for message in check.messages(path))
        self.assertIn("kriva::ui::NumberField", contexts)


if __name__ == "__main__":
    unittest.main()
