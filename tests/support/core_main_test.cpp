#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>

// Without this, the runs under other locales would pass where the locale is missing.
TEST(Locale, isTheOneThatTheEnvironmentNames) {
    const char* asked = std::getenv("LC_ALL");
    if (asked != nullptr) {
        EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), asked);
    }
}
