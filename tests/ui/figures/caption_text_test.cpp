#include "ui/figures/caption_text.h"

#include <gtest/gtest.h>
#include <QLocale>

namespace kriva::ui {
namespace {

TEST(TextSource, numbersHaveTheMinusOfFormulasAndTheDecimalSignOfTheLanguage) {
    for (const auto& [language, text] : {std::pair{"en", "\u22122.50"}, {"bg", "\u22122,50"}, {"sl", "\u22122,50"}}) {
        QLocale::setDefault(QLocale(QString::fromLatin1(language)));
        EXPECT_EQ(textSource().number(-2.5, 2), text) << language;
    }
    QLocale::setDefault(QLocale::c());
}

} // namespace
} // namespace kriva::ui
