#include "ui/figures/frame_text.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

std::optional<std::vector<double>> stagesOf(const char* text) {
    const auto places = readFramePlaces(QString::fromUtf8(text));
    if (!places)
        return {};
    std::vector<double> numbers;
    for (const FramePlace& place : *places) {
        EXPECT_EQ(place.over, FramePlace::Over::stage);
        numbers.push_back(place.at);
    }
    return numbers;
}

TEST(FrameText, readsStages) {
    const std::vector<double> expected{0, 5, 10};
    for (const char* text : {"0,5,10", "0, 5, 10", " 0;5 ; 10 ", "0 5 10"})
        EXPECT_EQ(stagesOf(text), expected) << text;
    EXPECT_EQ(stagesOf("0..3, 8"), (std::vector<double>{0, 1, 2, 3, 8}));
    EXPECT_EQ(stagesOf("7"), std::vector<double>{7});
    EXPECT_EQ(stagesOf(""), std::vector<double>());
}

TEST(FrameText, readsValuesOfT) {
    const std::vector<FramePlace> expected{{FramePlace::Over::t, 0.25}, {FramePlace::Over::t, 0.5}};
    for (const char* text : {"t=0.25,0.5", "t = 0.25; 0.5", "t= 0,25 0,5", "t = 0,25; 0,5"})
        EXPECT_EQ(readFramePlaces(QString::fromUtf8(text)), expected) << text;
}

TEST(FrameText, refusesWhatNamesNoFrames) {
    for (const char* text : {"x", "1.5", "-1", "3..1", "1..2..3", "0..1000", "t=", "t=x", "u=1", "1e9"})
        EXPECT_EQ(readFramePlaces(QString::fromUtf8(text)), std::nullopt) << text;
}

TEST(FrameText, readsBackWhatItWrites) {
    for (const char* text : {"0..3", "t=0.25,0.5", "", "12"}) {
        const auto places = *readFramePlaces(QString::fromUtf8(text));
        EXPECT_EQ(readFramePlaces(framePlacesText(places)), places) << text;
    }
}

} // namespace
} // namespace kriva::ui
