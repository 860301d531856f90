#include "tests/support/documents.h"
#include "ui/document/serial_document.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

[[nodiscard]] Curve curveTo(Point end) {
    ElevationCurve curve;
    curve.points = {{0, 0}, {1, 2}, end};
    return Curve(curve);
}

class SerialDocumentTest : public testing::Test {
  protected:
    static constexpr SheetIndex kFirstSheet = 0;

    SerialDocumentTest() {
        Document value;
        value.sheets[kFirstSheet].curves = {curveTo({3, 0}), curveTo({4, 0})};
        document_.replace(std::move(value));
    }

    [[nodiscard]] Serial serial(std::size_t index) const { return document_.serials(kFirstSheet)[index]; }

    SerialDocument document_;
};

TEST_F(SerialDocumentTest, givesOneSnapshotToAllWhoAsk) {
    const std::shared_ptr<const Curve> first = document_.snapshot(kFirstSheet, serial(0));
    EXPECT_EQ(first, document_.snapshot(kFirstSheet, serial(0)));
    EXPECT_EQ(*first, curveTo({3, 0}));
    EXPECT_EQ(*document_.snapshot(kFirstSheet, serial(1)), curveTo({4, 0}));
}

TEST_F(SerialDocumentTest, keepsASnapshotAsItWasWhateverBecomesOfTheCurve) {
    const std::shared_ptr<const Curve> before = document_.snapshot(kFirstSheet, serial(0));
    document_.put(kFirstSheet, serial(0), curveTo({5, 0}));
    EXPECT_EQ(*before, curveTo({3, 0}));
    EXPECT_EQ(*document_.snapshot(kFirstSheet, serial(0)), curveTo({5, 0}));

    const std::shared_ptr<const Curve> after = document_.snapshot(kFirstSheet, serial(0));
    document_.exchange(kFirstSheet, serial(0), PlacedCurve{curveTo({6, 0}), 0});
    EXPECT_EQ(*after, curveTo({5, 0}));
    EXPECT_EQ(*document_.snapshot(kFirstSheet, serial(0)), curveTo({6, 0}));
}

TEST_F(SerialDocumentTest, makesASnapshotOfWhatComesBack) {
    const Serial gone = serial(0);
    const std::shared_ptr<const Curve> before = document_.snapshot(kFirstSheet, gone);
    std::optional<PlacedCurve> taken = document_.exchange(kFirstSheet, gone, std::nullopt);
    ASSERT_TRUE(taken);
    taken->curve = curveTo({7, 0});
    document_.exchange(kFirstSheet, gone, std::move(taken));
    EXPECT_EQ(*document_.snapshot(kFirstSheet, gone), curveTo({7, 0}));
}

} // namespace
} // namespace kriva::ui
