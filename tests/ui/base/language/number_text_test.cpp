#include "ui/base/language/number_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kriva::ui {
namespace {

QLocale localeOf(const char* name) {
    return QLocale(QString::fromLatin1(name));
}

TEST(NumberText, pointAndCommaMeanTheSame) {
    EXPECT_EQ(parseNumber(u"1.5"), 1.5);
    EXPECT_EQ(parseNumber(u"1,5"), 1.5);
    EXPECT_EQ(parseNumber(u"-2,25"), -2.25);
    EXPECT_EQ(parseNumber(u".5"), 0.5);
    EXPECT_EQ(parseNumber(u",5"), 0.5);
    EXPECT_EQ(parseNumber(u"5,"), 5.0);
}

TEST(NumberText, signsExponentsAndBlanksAroundAreRead) {
    EXPECT_EQ(parseNumber(u"1e-7"), 1e-7);
    EXPECT_EQ(parseNumber(u"1E\u22127"), 1e-7);
    EXPECT_EQ(parseNumber(u"2e+3"), 2000.0);
    EXPECT_EQ(parseNumber(u"\u22122,25"), -2.25);
    EXPECT_EQ(parseNumber(u"+4"), 4.0);
    EXPECT_EQ(parseNumber(u" 7 \n"), 7.0);
}

TEST(NumberText, whatIsNoSingleNumberIsRefused) {
    for (const char16_t* text : {u"",    u" ",     u"1.234,5", u"1,234.5", u"1 234",  u"1\u00a0234", u"1'234", u"nan",
                                 u"inf", u"1e999", u"-1e999",  u"+-1",     u"--1",    u"++1",        u"-",     u".",
                                 u"e5",  u"1e",    u"0x10",    u"1d",      u"\u0661", u"5%",         u"1 2"})
        EXPECT_FALSE(parseNumber(text)) << QString::fromUtf16(text).toStdString();
}

TEST(NumberText, negativeZeroKeepsItsSign) {
    EXPECT_TRUE(std::signbit(parseNumber(u"-0").value()));
    EXPECT_EQ(formatNumber(-0.0, localeOf("en")), u"-0");
}

TEST(NumberText, numbersShowTheDecimalSignOfTheLanguage) {
    EXPECT_EQ(formatNumber(0.5, localeOf("en")), u"0.5");
    for (const char* language : {"bg", "sl", "uk"})
        EXPECT_EQ(formatNumber(1234567.25, localeOf(language)), u"1234567,25") << language;
    EXPECT_EQ(formatNumber(-1234.5, 2, localeOf("sl")), u"-1234,50");
}

TEST(NumberText, powersOfTenAppearOnlyWherePlainDigitsGetLong) {
    EXPECT_EQ(formatNumber(1e5, localeOf("en")), u"100000");
    EXPECT_EQ(formatNumber(1e-5, localeOf("en")), u"0.00001");
    EXPECT_EQ(formatNumber(1e-7, localeOf("en")), u"1e-7");
    EXPECT_EQ(formatNumber(-1.25e-30, localeOf("bg")), u"-1,25e-30");
    EXPECT_EQ(formatNumber(1e300, localeOf("en")), u"1e300");
}

TEST(NumberText, whatRoundsToZeroHasNoMinus) {
    EXPECT_EQ(formatNumber(-0.004, 2, localeOf("en")), u"0.00");
    EXPECT_EQ(formatNumber(-0.006, 2, localeOf("en")), u"-0.01");
    EXPECT_EQ(formatNumber(-0.4, 0, localeOf("en")), u"0");
}

TEST(NumberText, whatAPersonReadsIsRoundedAndHasTheMinusOfFormulas) {
    EXPECT_EQ(shownNumber(-1234.5678, 6), withMinus(formatNumber(-1234.57)));
    EXPECT_EQ(shownNumber(-1e-7, 6), u"\u22121E\u221207");
    EXPECT_EQ(shownNumber(0.25, 6), formatNumber(0.25));
}

TEST(NumberText, theLargestNumberFitsWithAllDecimals) {
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(formatNumber(-largest, 17, localeOf("en")).size(), 1 + 309 + 1 + 17);
}

TEST(NumberText, stepsAddAsAPersonAdds) {
    EXPECT_EQ(stepped(0.1, 0.2), 0.3);
    EXPECT_EQ(stepped(0.3, -0.1), 0.2);
    EXPECT_EQ(stepped(1.0, -0.9), 0.1);
    EXPECT_EQ(stepped(0.123, 0.05), 0.173);
    EXPECT_EQ(stepped(0, 0), 0);
    EXPECT_EQ(stepped(1e9, 1), 1000000001.0);
    EXPECT_EQ(stepped(1e300, 1e300), 2e300);
}

RC_GTEST_PROP(NumberText, everyDoubleIsReadBackBitForBitInEveryLanguage, ()) {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value));
    for (const char* language : {"en", "bg", "sl", "uk"}) {
        const auto back = parseNumber(formatNumber(value, localeOf(language)));
        RC_ASSERT(back.has_value());
        RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == bits);
    }
}

RC_GTEST_PROP(NumberText, stepsUpAndDownComeBack, ()) {
    const double value = static_cast<double>(*rc::gen::inRange(-100000, 100000)) / 1000;
    const double step = static_cast<double>(*rc::gen::inRange(1, 1000)) / 100;
    RC_ASSERT(stepped(stepped(value, step), -step) == value);
}

TEST(WithMinus, setsTheMinusOfFormulasInEveryLanguage) {
    for (const char* language : {"en", "bg", "sl", "uk"}) {
        const QLocale locale{QString::fromLatin1(language)};
        EXPECT_EQ(withMinus(formatNumber(-3, locale)), QStringLiteral("\u22123"));
        EXPECT_EQ(withMinus(formatNumber(3, locale)), QStringLiteral("3"));
        EXPECT_EQ(parseNumber(withMinus(formatNumber(-2.5e-7, locale))), -2.5e-7);
    }
}

} // namespace
} // namespace kriva::ui
