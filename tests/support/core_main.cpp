#include <gtest/gtest.h>

#include <clocale>

// In the locale of the environment, as the program itself runs: a comma for the decimal point must change nothing.
int main(int argc, char** argv) {
    std::setlocale(LC_ALL, "");
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
