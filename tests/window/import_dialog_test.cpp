#include "tests/support/panel_test.h"
#include "ui/base/language/language.h"
#include "ui/figures/caption_text.h"
#include "ui/window/dialogs/import_dialog.h"

#include <QPushButton>

namespace kriva::ui {
namespace {

constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;
constexpr SheetIndex kElevation = kSheetOf<ElevationCurve>;

const Path kArch{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {3}, false};
const Path kLine{{{0, 0}, {1, 0}}, {1}, false};

class ImportDialogTest : public testing::Test {
  protected:
    ImportDialogTest() { dialog_.show(); }
    [[nodiscard]] const Drawing& shown() { return dialog_.findChild<FigurePreview*>()->drawing(); }
    [[nodiscard]] bool mayImport() {
        return dialog_.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
    }

    LanguageSwitch language_{Language::English}; // "1 point", "2 points"
    ImportDialog dialog_{{{"Arch", kArch}, {"", kLine}}, kSpline};
};

TEST_F(ImportDialogTest, offersEveryPathWithItsPoints) {
    const auto& list = test::named<QListWidget>(dialog_, "Curves");
    ASSERT_EQ(list.count(), 2);
    EXPECT_EQ(list.item(0)->text(), QStringLiteral("Arch: 4 points"));
    EXPECT_EQ(list.item(1)->text(), QStringLiteral("2: 2 points"));
    EXPECT_EQ(dialog_.curves(), (std::vector<Curve>{renamed(withPathAdded(emptyCurve(kSpline), kArch), "Arch"),
                                                    withPathAdded(emptyCurve(kSpline), kLine)}));
    EXPECT_TRUE(mayImport());
}

TEST_F(ImportDialogTest, showsThoseChosenAtTheirPlace) {
    test::type(test::named<NumberField>(dialog_, "Scale"), "2");
    test::type(test::named<NumberField>(dialog_, "Move by x"), "10");
    test::type(test::named<NumberField>(dialog_, "Move by y"), "-1");
    test::named<QListWidget>(dialog_, "Curves").item(1)->setCheckState(Qt::Unchecked);
    ASSERT_EQ(dialog_.curves().size(), 1U);
    const SplineCurve& arch = std::get<SplineCurve>(dialog_.curves()[0]);
    EXPECT_EQ(segmentsOf(arch).front(), (Points{{10, -1}, {12, 3}, {16, 3}, {18, -1}}));
    Document document;
    document.sheets[kSpline].curves = dialog_.curves();
    EXPECT_EQ(shown().figure, drawingOf(document, kSpline, textSource()).figure);
}

TEST_F(ImportDialogTest, tellsTheCurveThatIsTooLongByItsPlaceInTheList) {
    const Path tooMany{Points(300), {}, false};
    ImportDialog dialog({{"Arch", kArch}, {"", kLine}, {"<b>Leaf</b>", tooMany}}, kElevation);
    dialog.show();
    test::named<QListWidget>(dialog, "Curves").item(0)->setCheckState(Qt::Unchecked);
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text() ==
               QStringLiteral("curve 3, “<b>Leaf</b>”: this curve takes at most 201 points, and would have 300");
    }));
}

TEST_F(ImportDialogTest, importsNothingWhereNothingIsChosenOrItIsBeyondTheLimits) {
    auto& list = test::named<QListWidget>(dialog_, "Curves");
    list.item(0)->setCheckState(Qt::Unchecked);
    list.item(1)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(mayImport());
    ImportDialog tooLong({{"", {Points(300), {}, false}}}, kElevation);
    EXPECT_TRUE(tooLong.curves().empty());
    EXPECT_FALSE(tooLong.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    const auto labels = tooLong.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text() == QStringLiteral("curve 1: this curve takes at most 201 points, and would have 300");
    }));
}

} // namespace
} // namespace kriva::ui
