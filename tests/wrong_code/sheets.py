#!/usr/bin/env python3
"""That a sheet which fills in its form wrongly is refused by the compiler, in words that name the fault: sheets that
lack a member or a function, misspell it or give another type, and whose capabilities are not those of their functions.

    sheets.py COMPILER     the C++ compiler of the build

All sheets stand in one file, each in a namespace of its own, and are compiled at once."""
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).parent.parent.parent
CAPABILITIES = ("handles", "closing", "pieces", "animation", "relations", "longDrawing", "viewSettings",
                "outputLimits")

MEMBERS = {
    "kSheet": 'static constexpr std::string_view kSheet = "sheet";',
    "kCaption": "static constexpr Caption kCaption = Caption::none;",
    "kCapabilities": "static constexpr Capabilities kCapabilities{CAPABILITIES};",
    "name": "std::string name;",
    "style": "CurveStyle style;",
    "view": "CurveView view;",
    "operator==": "bool operator==(const Sheet&) const = default;",
}
REQUIRED = {
    "isIncomplete": "bool isIncomplete(const Sheet&);",
    "pointCount": "std::size_t pointCount(const Sheet&);",
    "pointAt": "Point pointAt(const Sheet&, int);",
    "derivedPointCount": "std::size_t derivedPointCount(const Sheet&);",
    "pointLimitError": "std::optional<FileError> pointLimitError(const Sheet&);",
    "isWithin": "bool isWithin(const Sheet&, double);",
    "polynomialDegree": "std::optional<int> polynomialDegree(const Sheet&);",
    "grips": "std::vector<Grip> grips(const Sheet&);",
    "layerOf": "std::string_view layerOf(const Sheet&, GripKind);",
    "withGripsMoved": "Sheet withGripsMoved(const Sheet&, std::span<const GripId>, Vector);",
    "withPointAdded": "Edited<Sheet> withPointAdded(Sheet, Point);",
    "withPointsAdded": "Sheet withPointsAdded(Sheet, std::span<const Point>);",
    "appended": "Sheet appended(Sheet, const Sheet&);",
    "withPointInserted": "std::optional<Edited<Sheet>> withPointInserted(const Sheet&, Point);",
    "withPointInsertedBehind":
        "std::optional<Edited<Sheet>> withPointInsertedBehind(const Sheet&, std::optional<int>);",
    "withCurvePulled": "std::optional<Sheet> withCurvePulled(const Sheet&, Point, Vector);",
    "withPointsRemoved": "Edited<Sheet> withPointsRemoved(const Sheet&, const std::vector<int>&);",
    "reversed": "Edited<Sheet> reversed(const Sheet&);",
    "layersOf": "std::span<const LayerInfo> layersOf(const Sheet&);",
    "figureOf": "Figure figureOf(const Sheet&, const FigureContext&);",
    "drawingSteps": "std::uint64_t drawingSteps(const Sheet&);",
    "results": "std::optional<std::vector<Result>> results(const Sheet&, WorkBudget&);",
    "plotsOf": "std::optional<std::vector<PlotGroup>> plotsOf(const Sheet&, WorkBudget&);",
    "tablesOf": "std::optional<std::vector<Table>> tablesOf(const Sheet&, WorkBudget&);",
    "reportCurve": "void reportCurve(JsonWriter&, const Sheet&);",
    "readCurve": "void readCurve(const JsonNode&, Sheet&);",
    "writeCurve": "void writeCurve(JsonWriter&, const Sheet&);",
}
OF_CAPABILITIES = {
    "handles": {
        "pullsHandles": "bool pullsHandles(const Sheet&);",
        "readyToPull": "std::optional<Sheet> readyToPull(Sheet, int);",
        "withHandleDragged": "Sheet withHandleDragged(const Sheet&, const GripId&, const HandleWay&);",
        "withHandleRetracted": "std::optional<Sheet> withHandleRetracted(const Sheet&, const GripId&);",
    },
    "closing": {"closedAt": "std::optional<Sheet> closedAt(const Sheet&, int);"},
    "pieces": {
        "withPathAdded": "Sheet withPathAdded(Sheet, const Path&);",
        "withPointsRemovedRefitted":
            "Refitted<Sheet> withPointsRemovedRefitted(const Sheet&, const std::vector<int>&);",
    },
    "animation": {"atFrame": "std::optional<Frame<Sheet>> atFrame(const Sheet&, const FramePlace&);"},
    "relations": {
        "relationsOf": "std::optional<Relations> relationsOf(std::span<const Sheet* const>, WorkBudget&);",
        "reportTogether":
            "std::optional<FileError> reportTogether(JsonWriter&, std::span<const Sheet* const>, WorkBudget&);",
    },
    "longDrawing": {"drawn": "std::optional<DrawnCurve> drawn(const Sheet&, const FigureContext&, WorkBudget&);"},
    "viewSettings": {"viewSettingsOf": "std::span<const ViewSetting> viewSettingsOf(const Sheet&);"},
    "outputLimits": {
        "outputLimitError": "std::optional<FileError> outputLimitError(std::span<const Sheet* const>, Output);",
    },
}
FUNCTIONS = REQUIRED | {name: text for some in OF_CAPABILITIES.values() for name, text in some.items()}


def sheet(namespace, members=None, functions=None, capabilities=CAPABILITIES):
    """The text of one sheet and of the question whether it is one."""
    named = ", ".join(f".{name} = true" for name in CAPABILITIES if name in capabilities)
    return "\n".join([f"namespace {namespace} {{", "using namespace kriva;", "struct Sheet {",
                      *(MEMBERS if members is None else members).values(), "};",
                      *(FUNCTIONS if functions is None else functions).values(), "}",
                      f"static_assert(kriva::isSheet<{namespace}::Sheet>());"]).replace("CAPABILITIES", named)


def without(table, name):
    return {key: text for key, text in table.items() if key != name}


def renamed(table, name):
    return {key: re.sub(rf"\b{name}(?=\()", name + "s", text) if key == name else text for key, text in table.items()}


def retyped(table, name):
    """With a type in place of its own that nobody asks for."""
    return {key: re.sub(rf"^.* (?={name}\()", "Sheet* ", text) if key == name else text for key, text in table.items()}


def wrong_sheets():
    """Each wrong sheet by its namespace, with what the compiler must say of it."""
    for name in MEMBERS:
        said = "equality_comparable|==" if name == "operator==" else rf"(\.|::){name}\b"
        yield sheet(f"lacks_member_{name if name.isalpha() else 'equality'}", members=without(MEMBERS, name)), said
    for name in FUNCTIONS:
        yield sheet(f"lacks_{name}", functions=without(FUNCTIONS, name)), rf"\b{name}\("
        yield sheet(f"misspells_{name}", functions=renamed(FUNCTIONS, name)), rf"\b{name}\("
        yield sheet(f"mistypes_{name}", functions=retyped(FUNCTIONS, name)), rf"\b{name}\("
    for name in CAPABILITIES:
        others = [other for other in CAPABILITIES if other != name]
        yield sheet(f"hides_{name}", capabilities=others), f"kCapabilities does not name {name}"


def told_of(namespaces, output):
    """What the compiler says of each: its words begin where it first names the sheet, and end where it names another.
    The file's own lines are left out, as they name everything."""
    told = dict.fromkeys(namespaces, "")
    about = None
    for line in output.splitlines():
        if re.match(r"\s*\d* \|", line) or line.startswith("static_assert"):
            continue
        named = re.search(r"\b(\w+)::Sheet\b", line)
        about = named.group(1) if named else about
        if about in told:
            told[about] += line + "\n"
    return told


class Sheets(unittest.TestCase):
    maxDiff = None

    def compile(self, text):
        every_fault = ["-ferror-limit=0"] if "clang" in COMPILER else []
        command = [COMPILER, "-std=c++20", "-fsyntax-only", *every_fault, f"-I{ROOT}", "-x", "c++", "-"]
        return subprocess.run(command, input='#include "core/curve/sheet.h"\n' + text, capture_output=True, text=True)

    def test_a_whole_sheet_is_one(self):
        compiled = self.compile(sheet("whole") + sheet("small", functions=REQUIRED, capabilities=()))
        self.assertEqual((compiled.returncode, compiled.stderr), (0, ""))

    def test_the_compiler_names_what_is_wrong(self):
        wrong = list(wrong_sheets())
        names = [re.match(r"namespace (\w+)", text).group(1) for text, _ in wrong]
        compiled = self.compile("\n".join(text for text, _ in wrong))
        self.assertNotEqual(compiled.returncode, 0)
        told = told_of(names, compiled.stderr)
        for name, (_, said) in zip(names, wrong):
            with self.subTest(name):
                self.assertRegex(told[name], said)


if __name__ == "__main__":
    COMPILER = sys.argv.pop(1)
    unittest.main()
