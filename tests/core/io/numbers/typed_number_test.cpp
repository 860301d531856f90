#include "core/io/numbers/typed_number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kriva {
namespace {

double valueOf(std::string_view text) {
    return readTypedNumber(text).value_or(TypedNumber{std::nan(""), 0}).value;
}

TEST(TypedNumber, pointAndCommaMeanTheSameAndAreTold) {
    for (const char* text : {"1.5", "1,5", "+1.5", " 1,5\t", "15e-1",
                             "\u00a0"
                             "1.5\u2003"})
        EXPECT_EQ(valueOf(text), 1.5) << text;
    EXPECT_EQ(readTypedNumber("1.5")->decimalSign, '.');
    EXPECT_EQ(readTypedNumber("1,")->decimalSign, ',');
    EXPECT_EQ(readTypedNumber("1e5")->decimalSign, 0);
}

TEST(TypedNumber, takesBothMinusSignsAndKeepsThatOfZero) {
    EXPECT_EQ(valueOf("\u22122,25"), -2.25);
    EXPECT_EQ(valueOf("1E\u22127"), 1e-7);
    EXPECT_TRUE(std::signbit(valueOf("-0")));
}

TEST(TypedNumber, refusesWhatIsNoSingleNumber) {
    for (const char* text : {"",
                             " ",
                             "1.234,5",
                             "1 234",
                             "1\u00a0"
                             "234",
                             "nan",
                             "inf",
                             "1e999",
                             "+-1",
                             "--1",
                             "-",
                             ".",
                             "e5",
                             "1e",
                             "0x10",
                             "1d",
                             "5%",
                             "\x80",
                             "1\xe2\x88",
                             "\u0661"})
        EXPECT_FALSE(readTypedNumber(text)) << text;
    EXPECT_FALSE(readTypedNumber(std::string_view("1\0", 2)));
}

TEST(TypedNumber, isOfBoundedLength) {
    EXPECT_EQ(valueOf("1." + std::string(4094, '0')), 1);
    EXPECT_FALSE(readTypedNumber("1." + std::string(4095, '0')));
}

TEST(TypedNumber, hasPowersOfTenOnlyWherePlainDigitsGetLong) {
    EXPECT_EQ(writeTypedNumber(-1234567.25, ","), "-1234567,25");
    EXPECT_EQ(writeTypedNumber(1e-5, "."), "0.00001");
    EXPECT_EQ(writeTypedNumber(1e-7, "."), "1e-7");
    EXPECT_EQ(writeTypedNumber(-1.25e-30, ","), "-1,25e-30");
    EXPECT_EQ(writeTypedNumber(1e20, "."), "1e20");
    EXPECT_EQ(writeTypedNumber(9007199254740993e100, "."), "9.007199254740992e115");
    EXPECT_EQ(writeTypedNumber(-0.0, "."), "-0");
}

} // namespace
} // namespace kriva
