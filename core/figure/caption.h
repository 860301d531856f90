#pragma once

#include <string_view>

namespace kriva {

/// Words that core puts on figures and beside numbers. They are told apart by their English ones, which ui translates;
/// core holds no sentence, and no other language.
class Caption {
  public:
    constexpr Caption() = default; ///< none
    /// English; empty for none.
    [[nodiscard]] constexpr const char* words() const { return words_; }
    friend constexpr bool operator==(Caption a, Caption b) { return std::string_view(a.words_) == b.words_; }
    friend constexpr auto operator<=>(Caption a, Caption b) { return std::string_view(a.words_) <=> b.words_; }

    // NOLINTBEGIN(readability-identifier-naming): they are used, and read, like the enumerators of a list
    static const Caption none;
    // What is said in more than one place; other captions stand beside what they name.
    static const Caption curve, controlPolygon, points, labels, construction, leftPolygon, rightPolygon, blossom, runs,
        joins, allRules, degree, length, bounds, gap, pointAtT, segmentLength, coefficients, crossingCount, crossing,
        tooManyToCount, bendingEnergy, runCoefficients, residual, maxError, largestKink, slopeVariation, incomplete,
        bernsteinPolynomials, weightsAtT, leftAndRight, hodograph, run, methods, interpolation, approximation;
    // NOLINTEND(readability-identifier-naming)

  private:
    constexpr explicit Caption(const char* words)
        : words_(words) {}
    friend constexpr Caption translatable(const char* context, const char* words);

    const char* words_ = "";
};

/// A caption of these English words, in the catalogues under `context`, which is "Caption": translations/update finds
/// both by the name of this function.
[[nodiscard]] constexpr Caption translatable([[maybe_unused]] const char* context, const char* words) {
    return Caption(words);
}

inline constexpr Caption Caption::none{};
inline constexpr Caption Caption::curve = translatable("Caption", "Curve");
inline constexpr Caption Caption::controlPolygon = translatable("Caption", "Control polygon");
inline constexpr Caption Caption::points = translatable("Caption", "Points");
inline constexpr Caption Caption::labels = translatable("Caption", "Labels");
inline constexpr Caption Caption::construction = translatable("Caption", "De Casteljau scheme");
inline constexpr Caption Caption::leftPolygon = translatable("Caption", "Left polygon");
inline constexpr Caption Caption::rightPolygon = translatable("Caption", "Right polygon");
inline constexpr Caption Caption::blossom = translatable("Caption", "Blossom");
inline constexpr Caption Caption::runs = translatable("Caption", "Monotone runs");
inline constexpr Caption Caption::joins = translatable("Caption", "Joins");
inline constexpr Caption Caption::allRules = translatable("Caption", "All rules");
inline constexpr Caption Caption::degree = translatable("Caption", "Degree");
inline constexpr Caption Caption::length = translatable("Caption", "Length");
inline constexpr Caption Caption::bounds = translatable("Caption", "Bounds");
inline constexpr Caption Caption::gap = translatable("Caption", "Gap between polygon and curve");
inline constexpr Caption Caption::pointAtT = translatable("Caption", "Point at t");
inline constexpr Caption Caption::segmentLength = translatable("Caption", "Length of segment");
inline constexpr Caption Caption::coefficients = translatable("Caption", "Coefficients of segment");
inline constexpr Caption Caption::crossingCount = translatable("Caption", "Crossings of the sheet");
inline constexpr Caption Caption::crossing = translatable("Caption", "Crossing");
inline constexpr Caption Caption::tooManyToCount = translatable("Caption", "too many to count");
inline constexpr Caption Caption::bendingEnergy = translatable("Caption", "Bending energy");
inline constexpr Caption Caption::runCoefficients = translatable("Caption", "Coefficients of run");
inline constexpr Caption Caption::residual = translatable("Caption", "Residual (root mean square)");
inline constexpr Caption Caption::maxError = translatable("Caption", "Largest residual of run");
inline constexpr Caption Caption::largestKink = translatable("Caption", "Largest kink");
inline constexpr Caption Caption::slopeVariation = translatable("Caption", "Slope variation");
inline constexpr Caption Caption::incomplete = translatable("Caption", "This curve needs more points");
inline constexpr Caption Caption::bernsteinPolynomials = translatable("Caption", "Bernstein polynomials");
inline constexpr Caption Caption::weightsAtT = translatable("Caption", "Weights at t");
inline constexpr Caption Caption::leftAndRight = translatable("Caption", "Left and right polygon");
inline constexpr Caption Caption::hodograph = translatable("Caption", "Hodograph");
inline constexpr Caption Caption::run = translatable("Caption", "Run");
inline constexpr Caption Caption::methods = translatable("Caption", "Comparison of methods");
inline constexpr Caption Caption::interpolation = translatable("Caption", "Interpolation");
inline constexpr Caption Caption::approximation = translatable("Caption", "Approximation");

} // namespace kriva
