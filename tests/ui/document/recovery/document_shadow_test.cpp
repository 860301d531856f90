#include "ui/document/recovery/document_shadow.h"

#include <gtest/gtest.h>

#include <random>

namespace kriva::ui {
namespace {

using namespace std::chrono_literals;

constexpr SheetIndex kElevation = kSheetOf<ElevationCurve>;
const StepLabel kStep{"Move point %1", 3};

Curve curveAt(double x) {
    return withPointsAdded(emptyCurve(kElevation), Points{{x, 0}, {x, 1}, {2, 2}});
}

class DocumentShadowTest : public testing::Test {
  protected:
    DocumentShadowTest() {
        Document start;
        start.title = "Shadow";
        for (int i = 0; i < kCurves; ++i)
            start.sheets[kElevation].curves.push_back(curveAt(i));
        document.replace(start);
    }
    [[nodiscard]] Serial serial(int index) const {
        return document.serials(kElevation)[static_cast<std::size_t>(index)];
    }
    void change(int index, double x) { document.change(kElevation, serial(index), curveAt(x), kStep); }

    static constexpr int kCurves = 20;
    OpenDocument document;
    DocumentShadow shadow{document};
};

TEST_F(DocumentShadowTest, isTheDocumentAfterAnyChanges) {
    std::mt19937 random(7);
    for (int i = 0; i < 500; ++i) {
        const int count = static_cast<int>(document.serials(kElevation).size());
        const int index = static_cast<int>(random() % static_cast<unsigned>(std::max(count, 1)));
        switch (random() % 8) {
        case 0:
            document.add(kElevation, index, curveAt(i), kStep);
            break;
        case 1:
            if (count > 3)
                document.remove(kElevation, serial(index), kStep);
            break;
        case 2:
            document.undo();
            break;
        case 3:
            document.redo();
            break;
        case 4:
            document.reorder(kElevation, serial(index), 0, kStep);
            break;
        case 5:
            document.divide(kElevation, serial(index), curveAt(-i), curveAt(i + 0.5), kStep);
            break;
        case 6:
            document.setActiveCurve(kElevation, serial(index));
            break;
        default:
            change(index, i);
        }
        if (random() % 3 == 0)
            shadow.catchUp(0ns);
        if (random() % 50 == 0)
            shadow.drop();
        if (random() % 4 == 0) {
            while (!shadow.catchUp(0ns)) {
            }
            ASSERT_EQ(documentOf(shadow.snapshot()), document.value()) << "after step " << i;
        }
    }
}

TEST_F(DocumentShadowTest, sharesWhatDidNotChange) {
    ASSERT_TRUE(shadow.catchUp(1h));
    const DocumentSnapshot before = shadow.snapshot();
    change(3, 100);
    ASSERT_TRUE(shadow.catchUp(0ns)) << "one curve alone is copied";
    const DocumentSnapshot after = shadow.snapshot();
    for (std::size_t i = 0; i < kCurves; ++i)
        EXPECT_EQ(before.curves[kElevation][i] == after.curves[kElevation][i], i != 3) << i;
    EXPECT_EQ(documentOf(before).sheets[kElevation].curves[3], curveAt(3)) << "a snapshot stays as it is";
}

TEST_F(DocumentShadowTest, aCurveThatIsDraggedKeepsNoOtherWaiting) {
    document.beginGesture(kElevation, serial(0), kStep);
    int turns = 0;
    for (; turns < 10 * kCurves && !shadow.catchUp(0ns); ++turns)
        document.preview(curveAt(1000 + turns));
    EXPECT_LE(turns, kCurves + 1);
    EXPECT_EQ(documentOf(shadow.snapshot()), document.value());
}

TEST_F(DocumentShadowTest, copiesAtLeastOneAndNoMoreThanThereIsTimeFor) {
    int turns = 1;
    while (!shadow.catchUp(0ns))
        ++turns;
    EXPECT_EQ(turns, kCurves);
}

} // namespace
} // namespace kriva::ui
