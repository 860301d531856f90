#include "tests/ui/canvas/canvas_fixture.h"
#include "ui/editing/canvas_content.h"
#include "ui/editing/sheet_input.h"

#include <QSignalSpy>
#include <QThreadPool>

namespace kriva::ui {
namespace {

constexpr Qt::KeyboardModifiers kCtrlAlt = Qt::ControlModifier | Qt::AltModifier;
const Point kEmpty{0, -150};
const Point kOut{40, 150}; ///< the out handle of the knot 1

struct SplineOnCanvas {
    OpenDocument document;
    QThreadPool workers;
    SheetEditor editor{document, workers, *sheetNamed("spline")};
    SheetRelations relations{editor};
    const std::vector<Role> explained{Role::construction};
    SheetInput input{editor, explained};
    CanvasContent content{editor, relations, input.canvas()};
};

/// Two splines: through (-100, 0), (0, 100), (100, 0), with handles at the second knot; and above it, straight from
/// (-150, -100) to (150, -100), which is active.
class SheetInputTest : public ::testing::Test, protected SplineOnCanvas, protected CanvasEvents {
  protected:
    SheetInputTest()
        : CanvasEvents(input.canvas()) {
        SplineCurve arc = through({{-100, 0}, {0, 100}, {100, 0}});
        arc.knots[1].join = SplineKnot::Join::corner;
        arc.knots[1].in = {-40, 150};
        arc.knots[1].out = kOut;
        Document both;
        both.active = editor.index();
        both.sheets[editor.index()].curves = {Curve(arc), Curve(through({{-150, -100}, {150, -100}}))};
        both.sheets[editor.index()].view.activeCurve = 1;
        document.replace(both);
        show();
    }

    static SplineCurve through(const Points& places) {
        SplineCurve curve;
        for (const Point at : places)
            curve.knots.emplace_back().at = at;
        return curve;
    }
    [[nodiscard]] Serial arc() const { return document.serials(editor.index())[0]; }
    [[nodiscard]] Serial line() const { return document.serials(editor.index())[1]; }
    [[nodiscard]] GripRef knot(int index) const { return {arc(), {GripKind::point, index}}; }
    [[nodiscard]] GripRef end(int index) const { return {line(), {GripKind::point, index}}; }
    [[nodiscard]] GripRef handle() const { return {arc(), {GripKind::outHandle, 1}}; }
    [[nodiscard]] const SplineCurve& value(Serial serial) const {
        return std::get<SplineCurve>(*document.find(editor.index(), serial));
    }
    void doubleClick(Point at, Qt::KeyboardModifiers modifiers = {}) {
        click(at, modifiers);
        pressAgain(at, modifiers);
        release(at, modifiers);
    }
    [[nodiscard]] QStringList steps() {
        QStringList names;
        for (int i = 0; i < document.history(editor.index()).count(); ++i)
            names.append(resolvedStep(document.history(editor.index()).text(i)));
        return names;
    }
};

TEST_F(SheetInputTest, aClickSelectsAPointAndMakesItsCurveActive) {
    click({0, 100});
    EXPECT_EQ(editor.selection(), (Selection{knot(1)}));
    EXPECT_EQ(editor.activeSerial(), arc());
    click(kEmpty);
    EXPECT_EQ(editor.selection(), Selection());
    EXPECT_EQ(editor.activeSerial(), arc());
    click({0, -100});
    EXPECT_EQ(editor.activeSerial(), line()) << "a click on the curve itself";
    EXPECT_EQ(steps(), QStringList());
}

TEST_F(SheetInputTest, shiftAndAClickToggle) {
    click({0, 100});
    click({100, 0}, Qt::ShiftModifier);
    EXPECT_EQ(editor.selection(), (Selection{knot(1), knot(2)}));
    click({150, -100}, Qt::ShiftModifier);
    EXPECT_EQ(editor.selection(), (Selection{knot(1), knot(2), end(1)}));
    EXPECT_EQ(editor.activeSerial(), arc()) << "points of two curves";
    click({0, 100}, Qt::ShiftModifier);
    click({100, 0}, Qt::ShiftModifier);
    EXPECT_EQ(editor.selection(), (Selection{end(1)}));
    EXPECT_EQ(editor.activeSerial(), line());
    click(kEmpty, Qt::ShiftModifier);
    EXPECT_EQ(editor.selection(), (Selection{end(1)}));
}

TEST_F(SheetInputTest, clicksWithAltAddRemoveAndInsert) {
    click(kEmpty, Qt::AltModifier);
    EXPECT_EQ(editor.selection(), (Selection{end(2)}));
    click({0, -100}, Qt::AltModifier);
    EXPECT_EQ(value(line()).knots.back().at, (Point{0, -100})) << "on the curve too";
    click({150, -100}, Qt::AltModifier);
    click(kOut, Qt::AltModifier);
    EXPECT_EQ(steps(), list({"Add a point", "Add a point", "Remove point 1"})) << "a handle is no point";
    click({-60, 0}, kCtrlAlt);
    EXPECT_EQ(steps().size(), 3) << "there is no curve";
}

TEST_F(SheetInputTest, insertingMakesTheCurveActive) {
    ASSERT_EQ(editor.activeSerial(), line());
    const int count = static_cast<int>(value(arc()).knots.size());
    view.setTool(Tool::add);
    move({0, 100});
    const Point onArc = pointAt(withPointInserted(value(arc()), {95, 25})->curve, 2);

    click(onArc);
    EXPECT_EQ(editor.activeSerial(), arc());
    EXPECT_EQ(static_cast<int>(value(arc()).knots.size()), count + 1);
    EXPECT_EQ(editor.selection(), (Selection{knot(2)}));
    EXPECT_EQ(steps(), list({"Insert a point"}));
}

TEST_F(SheetInputTest, aDoubleClickAddsInsertsOrIsOneMoreClick) {
    doubleClick({0, 100});
    EXPECT_EQ(editor.selection(), (Selection{knot(1)}));
    EXPECT_EQ(steps(), QStringList());
    doubleClick({0, -100});
    EXPECT_EQ(editor.selection(), (Selection{end(1)}));
    doubleClick(kEmpty);
    EXPECT_EQ(steps(), list({"Insert a point", "Add a point"}));
    click({50, -150}, Qt::AltModifier);
    pressAgain({75, -150}, Qt::AltModifier);
    release({75, -150}, Qt::AltModifier);
    EXPECT_EQ(value(line()).knots.back().at, (Point{75, -150}));
    EXPECT_EQ(steps().size(), 4);
}

TEST_F(SheetInputTest, eachClickWithTheAddToolAdds) {
    view.setTool(Tool::add);
    click({20, -150});
    pressAgain({50, -150});
    release({50, -150});
    click({150, -100});
    EXPECT_EQ(steps(), list({"Add a point", "Add a point", "Add a point"})) << "on a point that closes nothing too";
    EXPECT_EQ(view.tool(), Tool::add);
}

TEST_F(SheetInputTest, ctrlAndAClickRetractAHandleAndSelectAPoint) {
    click({0, 100}, Qt::ControlModifier);
    EXPECT_EQ(editor.selection(), (Selection{knot(1)}));
    editor.activate(line());
    click(kOut, Qt::ControlModifier);
    EXPECT_EQ(value(arc()).knots[1].out, (Point{0, 100}));
    EXPECT_EQ(editor.activeSerial(), arc());
    EXPECT_EQ(steps(), list({"Retract a handle of knot 1"}));
}

TEST_F(SheetInputTest, aDragTakesTheSelectionAlong) {
    drag({0, 100}, {0, 120});
    EXPECT_EQ(editor.selection(), (Selection{knot(1)}));
    drag({100, 0}, {100, 20}, Qt::ShiftModifier);
    EXPECT_EQ(editor.selection(), (Selection{knot(1), knot(2)}));
    drag({100, 20}, {110, 20});
    EXPECT_EQ(value(arc()).knots[1].at, (Point{10, 140}));
    EXPECT_EQ(value(arc()).knots[2].at, (Point{110, 20}));
    EXPECT_EQ(steps(), list({"Move point 1", "Move points", "Move points"}));
}

TEST_F(SheetInputTest, ctrlLocksPointsToAnAxisAndLeavesHandlesFree) {
    drag({0, 100}, {30, 110}, Qt::ControlModifier);
    EXPECT_EQ(value(arc()).knots[1].at, (Point{30, 100}));
    const Point out = *value(arc()).knots[1].out;
    drag(out, {60, 130}, Qt::ControlModifier);
    EXPECT_NEAR(distance(*value(arc()).knots[1].out, {60, 130}), 0, 1e-9) << "45 degrees is one of its steps";
}

TEST_F(SheetInputTest, aDragOffPointsBendsInsertsAddsOrBands) {
    drag({0, -100}, {0, -80});
    view.setTool(Tool::add);
    drag({20, -160}, {20, -180});
    EXPECT_EQ(steps(), list({"Mould the curve", "Add a point"}));
    view.setTool(Tool::edit);
    drag({-120, -20}, {120, 120});
    EXPECT_EQ(editor.selection(), (Selection{knot(0), knot(1), knot(2)}));
    drag({0, 100}, {-110, -10}, Qt::AltModifier);
    EXPECT_EQ(editor.selection(), (Selection{knot(2)})) << "with Alt from a point too";
    EXPECT_EQ(steps().size(), 2);
}

TEST_F(SheetInputTest, onlyMarksOfTheTablesAreExplained) {
    QSignalSpy explanations(&input, &SheetInput::explanationRequested);
    QSignalSpy hints(&input, &SheetInput::hintChanged);
    CanvasCurve curve;
    curve.figure.layers.push_back({"marks", {}, {{{{0, -40}}, Role::construction}, {{{40, -40}}, Role::curvePoint}}});
    view.scene().setCurves({curve});
    move({0, -40});
    EXPECT_EQ(hints.back()[0].toString(), QStringLiteral("Click: how this point is worked out, in Tables"));
    click({0, -40});
    move({40, -40});
    EXPECT_NE(hints.back()[0].toString(), QStringLiteral("Click: how this point is worked out, in Tables"));
    click({40, -40});
    ASSERT_EQ(explanations.size(), 1);
    EXPECT_EQ(explanations[0][0].value<MarkPlace>(), (MarkPlace{Role::construction, {0, -40}}));
}

TEST_F(SheetInputTest, aMenuIsAboutWhatIsUnderIt) {
    QSignalSpy menus(&input, &SheetInput::menuRequested);
    const auto ask = [&](Point at) {
        press(at, {}, Qt::RightButton);
        release(at, {}, Qt::RightButton);
        return menus.back()[1].value<Hit>();
    };
    EXPECT_EQ(ask({0, 100}), (Hit{knot(1), {}}));
    EXPECT_EQ(editor.selection(), (Selection{knot(1)}));
    EXPECT_EQ(editor.activeSerial(), arc());
    EXPECT_EQ(ask({0, -100}), (Hit{{}, line()}));
    EXPECT_EQ(editor.activeSerial(), line());
    input.insertPointHere();
    EXPECT_NEAR(distance(value(line()).knots[1].at, {0, -100}), 0, 1e-9);
    EXPECT_EQ(ask(kEmpty), Hit());
    EXPECT_EQ(editor.selection(), (Selection{end(1)})) << "it deselects nothing";
    EXPECT_EQ(menus.size(), 3);
}

TEST_F(SheetInputTest, hintsFollowThePointerAndTheKeysOfAHandle) {
    QSignalSpy hints(&input, &SheetInput::hintChanged);
    move(kOut);
    EXPECT_TRUE(hints.back()[0].toString().startsWith(QStringLiteral("Drag: move the handle")));
    press(kOut);
    move({60, 160});
    EXPECT_TRUE(hints.back()[0].toString().startsWith(QStringLiteral("Ctrl: steps of 15°   Ctrl+Alt")));
    holdModifier(Qt::Key_Alt);
    EXPECT_EQ(hints.back()[0].toString(), QStringLiteral("Alt: the other handle stays"));
    key(Qt::Key_Escape);
    release({60, 160});
    EXPECT_EQ(steps(), QStringList());
}

} // namespace
} // namespace kriva::ui
