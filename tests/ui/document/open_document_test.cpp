#include "core/curve/limits.h"
#include "core/io/json/document_json.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/support/long_run.h"
#include "tests/support/sheet_curves.h"
#include "ui/document/open_document.h"
#include "ui/editing/sheet_editor.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QThreadPool>

#include <random>

namespace kriva::ui {
namespace {

constexpr SheetIndex kElevationSheet = kSheetOf<ElevationCurve>;
const StepLabel kMove{"Move point %1", 3};

ElevationCurve singleArch() {
    ElevationCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    return curve;
}

Curve withFirstAt(Point at) {
    ElevationCurve curve = singleArch();
    curve.points[0] = at;
    return curve;
}

/// An open document with one curve in its first sheet.
class OpenDocumentTest : public testing::Test {
  protected:
    OpenDocumentTest() {
        Document start;
        start.sheets[kElevationSheet].curves = test::curves({singleArch()});
        document.replace(start);
        serial = document.serials(kElevationSheet).front();
    }
    [[nodiscard]] int steps() { return document.history(kElevationSheet).count(); }
    [[nodiscard]] const Curve& curve() { return *document.find(kElevationSheet, serial); }

    OpenDocument document;
    Serial serial = 0;
};

TEST_F(OpenDocumentTest, aDragOfFiftyMovesIsOneStepAndOneSignalPerMove) {
    const QSignalSpy changes(&document, &OpenDocument::curveChanged);
    document.beginGesture(kElevationSheet, serial, kMove);
    for (int i = 1; i <= 50; ++i)
        document.preview(withFirstAt({i / 10.0, 1}));
    document.endGesture();
    EXPECT_EQ(changes.count(), 50);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(resolvedStep(document.history(kElevationSheet).undoText()), QStringLiteral("Move point 3"));
    document.undo();
    EXPECT_EQ(curve(), Curve(singleArch()));
    document.redo();
    EXPECT_EQ(curve(), withFirstAt({5, 1}));
}

TEST_F(OpenDocumentTest, outAndBackIsNoStep) {
    document.beginGesture(kElevationSheet, serial, kMove);
    document.preview(withFirstAt({5, 5}));
    document.preview(singleArch());
    document.endGesture();
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(document.isModified());
}

TEST_F(OpenDocumentTest, aCancelledGestureLosesNeitherRedoNorTheSavedState) {
    document.change(kElevationSheet, serial, withFirstAt({1, 1}), kMove);
    document.undo();
    ASSERT_FALSE(document.isModified());
    document.beginGesture(kElevationSheet, serial, kMove);
    document.preview(withFirstAt({9, 9}));
    document.cancelGesture();
    EXPECT_EQ(curve(), Curve(singleArch()));
    EXPECT_FALSE(document.isModified());
    EXPECT_TRUE(document.history(kElevationSheet).canRedo());
    document.redo();
    EXPECT_EQ(curve(), withFirstAt({1, 1}));
}

TEST_F(OpenDocumentTest, aGestureThatDrawsANewCurveIsOneStepOrNone) {
    document.remove(kElevationSheet, serial, {"Delete the curve"});
    const Serial drawn = *document.beginGestureWithNew(kElevationSheet, 0, singleArch(), {"New curve"});
    EXPECT_EQ(document.activeCurve(kElevationSheet), drawn);
    document.preview(withFirstAt({2, 1}));
    document.cancelGesture();
    EXPECT_EQ(document.find(kElevationSheet, drawn), nullptr);
    EXPECT_EQ(steps(), 1);
    serial = *document.beginGestureWithNew(kElevationSheet, 0, singleArch(), {"New curve"});
    document.preview(withFirstAt({2, 1}));
    document.preview(withFirstAt({3, 1}));
    document.endGesture();
    EXPECT_EQ(steps(), 2);
    document.undo();
    EXPECT_EQ(document.find(kElevationSheet, serial), nullptr);
    document.redo();
    EXPECT_EQ(curve(), withFirstAt({3, 1}));
}

TEST_F(OpenDocumentTest, stepsThatFollowEachOtherCloselyAreOne) {
    for (int i = 1; i <= 10; ++i)
        document.changeInBurst(kElevationSheet, serial, withFirstAt({0.0 + i, 0}), {"Nudge"});
    EXPECT_EQ(steps(), 0);
    document.changeInBurst(kElevationSheet, serial, withFirstAt({0, 7}), {"Set the degree"});
    EXPECT_EQ(steps(), 1);
    document.endGesture();
    EXPECT_EQ(steps(), 2);
}

TEST_F(OpenDocumentTest, isModifiedExactlyWhereTheValueDiffersFromTheOneSaved) {
    document.change(kElevationSheet, serial, withFirstAt({1, 1}), kMove);
    EXPECT_TRUE(document.isModified());
    document.markSaved();
    EXPECT_FALSE(document.isModified());
    document.undo();
    EXPECT_TRUE(document.isModified());
    document.change(kElevationSheet, serial, withFirstAt({1, 1}), kMove); // the value saved, by another way
    EXPECT_FALSE(document.isModified());
}

TEST_F(OpenDocumentTest, viewStateIsNeitherAStepNorAModification) {
    document.setCurveShown(kElevationSheet, serial, false);
    document.setLayerShown(kElevationSheet, "labels", false);
    document.setActiveSheet(test::kSubdivision);
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(steps(), 0);
}

TEST_F(OpenDocumentTest, undoDoesNotShowWhatIsHidden) {
    document.change(kElevationSheet, serial, withFirstAt({1, 1}), kMove);
    document.setCurveShown(kElevationSheet, serial, false);
    document.undo();
    EXPECT_FALSE(viewOf(curve()).isShown);
}

TEST_F(OpenDocumentTest, undoingADeletionBringsTheSerialBack) {
    document.add(kElevationSheet, 1, ElevationCurve{}, {"New curve"});
    document.remove(kElevationSheet, serial, {"Delete the curve"});
    EXPECT_EQ(document.find(kElevationSheet, serial), nullptr);
    document.undo();
    ASSERT_NE(document.find(kElevationSheet, serial), nullptr);
    EXPECT_EQ(document.indexOf(kElevationSheet, serial), 0);
}

TEST_F(OpenDocumentTest, reorderingKeepsTheActiveCurve) {
    const Serial other = document.add(kElevationSheet, 1, ElevationCurve{}, {"New curve"}).value();
    document.reorder(kElevationSheet, other, 0, {"Reorder the curves"});
    EXPECT_EQ(document.activeCurve(kElevationSheet), other);
    EXPECT_EQ(document.indexOf(kElevationSheet, other), 0);
    document.undo();
    EXPECT_EQ(document.activeCurve(kElevationSheet), other);
    EXPECT_EQ(document.indexOf(kElevationSheet, other), 1);
}

TEST_F(OpenDocumentTest, whatIsBeyondALimitIsRefusedAndNothingChanges) {
    const QSignalSpy refusals(&document, &OpenDocument::refused);
    ElevationCurve tooLong = singleArch();
    tooLong.points.resize(limits::kControlPoints + 1);
    EXPECT_FALSE(document.change(kElevationSheet, serial, tooLong, kMove));
    EXPECT_FALSE(document.change(kElevationSheet, serial, withFirstAt({1.1 * limits::kNumber, 0}), kMove));
    EXPECT_EQ(refusals.count(), 2);
    EXPECT_EQ(curve(), Curve(singleArch()));
    tooLong.points.pop_back();
    EXPECT_TRUE(document.change(kElevationSheet, serial, tooLong, kMove));
}

TEST_F(OpenDocumentTest, clearingTheCanvasIsOneStep) {
    document.add(kElevationSheet, 1, singleArch(), {"New curve"});
    QThreadPool workers;
    SheetEditor editor(document, workers, kElevationSheet);
    const int before = steps();
    editor.clear();
    EXPECT_TRUE(document.sheet(kElevationSheet).curves.empty());
    EXPECT_EQ(steps(), before + 1);
    document.undo();
    EXPECT_EQ(document.sheet(kElevationSheet).curves.size(), 2u);
}

TEST_F(OpenDocumentTest, aHistoryBelongsToItsSheet) {
    document.change(kElevationSheet, serial, withFirstAt({1, 1}), kMove);
    document.setActiveSheet(test::kSubdivision);
    document.undo();
    EXPECT_EQ(curve(), withFirstAt({1, 1}));
}

/// One random thing that a person could do.
class Person {
  public:
    Person(OpenDocument& document, unsigned seed)
        : document_(document)
        , random_(seed) {}

    void act() {
        const Serial serial = any(document_.serials(kElevationSheet));
        switch (below(10)) {
        case 0:
            document_.add(kElevationSheet, below(static_cast<int>(document_.serials(kElevationSheet).size()) + 1),
                          singleArch(), {"New curve"});
            break;
        case 1:
            if (document_.serials(kElevationSheet).size() > 1)
                document_.remove(kElevationSheet, serial, {"Delete the curve"});
            break;
        case 2:
            document_.reorder(kElevationSheet, serial,
                              below(static_cast<int>(document_.serials(kElevationSheet).size())),
                              {"Reorder the curves"});
            break;
        case 3:
            document_.change(kElevationSheet, serial, moved(serial), kMove);
            break;
        case 4:
            document_.beginGesture(kElevationSheet, serial, kMove);
            document_.preview(moved(serial));
            document_.preview(moved(serial));
            below(2) == 0 ? document_.endGesture() : document_.cancelGesture();
            break;
        case 5:
            document_.changeInBurst(kElevationSheet, serial, moved(serial), {"Nudge"});
            break;
        case 6:
            document_.undo();
            break;
        case 7:
            document_.redo();
            break;
        case 8:
            document_.preview(moved(*document_.beginGestureWithNew(kElevationSheet, 0, singleArch(), {"New curve"})));
            below(2) == 0 ? document_.endGesture() : document_.cancelGesture();
            break;
        default:
            document_.markSaved();
            saved_ = document_.value();
        }
    }
    [[nodiscard]] const Document& saved() const { return saved_; }

  private:
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    Serial any(const std::vector<Serial>& serials) {
        return serials[static_cast<std::size_t>(below(static_cast<int>(serials.size())))];
    }
    Curve moved(Serial serial) {
        const GripId id{GripKind::point, below(4)};
        return withGripsMoved(*document_.find(kElevationSheet, serial), std::span(&id, 1),
                              {below(7) - 3.0, below(7) - 3.0});
    }

    OpenDocument& document_;
    std::mt19937 random_;
    Document saved_ = document_.value();
};

TEST_F(OpenDocumentTest, anySequenceCanBeUndoneAndRedoneByteForByte) {
    const unsigned sequences = test::isLongRun() ? 10'000 : 500;
    for (unsigned seed = 0; seed < sequences; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Document start;
        start.sheets[kElevationSheet].curves = test::curves({singleArch()});
        document.replace(start);
        Person person(document, seed);
        for (int i = 0; i < 50; ++i) {
            person.act();
            ASSERT_EQ(document.isModified(), !sameContent(document.value(), person.saved()));
        }
        document.endGesture();
        while (document.history(kElevationSheet).canRedo())
            document.redo();
        const std::string end = writeDocument(document.value(), 0);
        while (document.history(kElevationSheet).canUndo())
            document.undo();
        Document undone = document.value();
        undone.sheets[kElevationSheet].view = {};
        ASSERT_EQ(writeDocument(undone), writeDocument(start));
        while (document.history(kElevationSheet).canRedo())
            document.redo();
        Document redone = document.value();
        redone.sheets[kElevationSheet].view = std::get<Document>(readDocument(end)).sheets[kElevationSheet].view;
        ASSERT_EQ(writeDocument(redone, 0), end);
    }
}

TEST_F(OpenDocumentTest, dividingACurveIsOneStepAndIsRefusedAsAWhole) {
    SubdivisionCurve whole;
    whole.points = {{0, 0}, {1, 1}, {2, 0}};
    whole.multiplicity.assign(3, 1);
    Document start;
    start.sheets[test::kSubdivision].curves = test::curves({whole, whole});
    document.replace(start);
    const Serial first = document.serials(test::kSubdivision)[0];
    const auto parts = *dividedAtCut(whole);
    EXPECT_TRUE(document.divide(1, first, parts[0], parts[1], kMove));
    EXPECT_EQ(document.sheet(test::kSubdivision).curves, test::curves({parts[0], parts[1], whole}));
    EXPECT_EQ(document.activeCurve(test::kSubdivision), first);
    EXPECT_EQ(document.history(test::kSubdivision).count(), 1);
    document.setActiveSheet(test::kSubdivision);
    document.undo();
    EXPECT_EQ(document.sheet(test::kSubdivision).curves, test::curves({whole, whole}));
    document.redo();
    EXPECT_EQ(document.sheet(test::kSubdivision).curves.size(), 3u);

    start.sheets[test::kSubdivision].curves.assign(limits::kCurvesInSheet, Curve(whole));
    document.replace(start);
    EXPECT_FALSE(document.divide(1, document.serials(test::kSubdivision)[0], parts[0], parts[1], kMove));
    EXPECT_EQ(document.sheet(test::kSubdivision).curves, start.sheets[test::kSubdivision].curves);
    EXPECT_EQ(document.history(test::kSubdivision).count(), 0);
}

} // namespace
} // namespace kriva::ui
