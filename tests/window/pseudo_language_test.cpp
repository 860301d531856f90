#include "tests/support/test_window.h"
#include "tests/support/visible_texts.h"
#include "ui/window/dialogs/about_dialog.h"

#include <gtest/gtest.h>
#include <QRegularExpression>
#include <QTranslator>

namespace kriva::ui {
namespace {

using test::TestWindow;
using test::visibleTexts;

const QString kMark = QStringLiteral("⟦");

/// Marks every text that goes through translation: what is shown without the mark slipped past it.
class MarkingTranslator : public QTranslator {
  public:
    [[nodiscard]] QString translate(const char*, const char* source, const char*, int) const override {
        return kMark + QString::fromUtf8(source) + QStringLiteral("⟧");
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

/// What is the same in every language: numbers and signs, letters of formulas, names, keys of documents.
bool isOfNoLanguage(const QString& line) {
    const QString text = line.section(QLatin1String(": "), 1);
    static const QRegularExpression signs(QStringLiteral("^[\\s\\d.,;:()eE×%–−+-]*$|^(C|G)[012]$|^\\d+–\\d+$"));
    // Letters of formulas, each by itself: "x", "bᵢ₋₁", "1 − i/N"
    static const QRegularExpression letters(
        QStringLiteral("^(?:(?<![A-Za-z])[A-Za-z](?![A-Za-z])′?[₀-₉ᵢⱼₙ₊₋]*|[\\d\\s−+/])+$"));
    static const QStringList names{QStringLiteral("English"), QStringLiteral("Български"),
                                   QStringLiteral("Slovenščina"), QStringLiteral("Українська")};
    // "t = 0.5: B0 = 0.125; B1 = 0.375", as a plot tells its values
    static const QRegularExpression values(
        QStringLiteral("^<i>\\w</i> = [\\d.,e−+-]+: (<i>\\w+</i><sub>\\d+</sub> = [\\d.,e−+-]+(; )?)*$"));
    // "t = 0.5", and where curves cross: "0: c₂(0.25) = 0: c₅(0.5) = (5; 2)"
    static const QRegularExpression equation(
        QStringLiteral("^[A-Za-z] = [\\d.]+$|^((\\d+: )?c[₀-₉]+\\([\\d.]+\\) = )+\\([\\d.; −-]+\\)$"));
    return equation.match(text).hasMatch() || signs.match(text).hasMatch() || letters.match(text).hasMatch() ||
           values.match(text).hasMatch() || names.contains(text);
}

TEST(PseudoLanguage, everyVisibleTextIsTranslated) {
    MarkingTranslator translator;
    TestWindow window;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        SheetTab& tab = window.shown(sheet);
        test::seeAllPanels(tab);
        SheetEditor& editor = tab.editor();
        editor.addPoint({2.5, 1.25});
        editor.placePoint(0, {0.125, -1});
        editor.newCurve();
    }
    AboutDialog about;
    about.show();
    QApplication::installTranslator(&translator);
    QApplication::sendPostedEvents();
    QApplication::processEvents();
    const QStringList texts = visibleTexts(window.window) + visibleTexts(about);
    EXPECT_GT(texts.size(), 200);
    for (const QString& text : texts)
        EXPECT_TRUE(text.contains(kMark) || isOfNoLanguage(text)) << text.toStdString();
    QApplication::removeTranslator(&translator);
}

} // namespace
} // namespace kriva::ui
