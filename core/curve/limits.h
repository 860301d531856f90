#pragma once

#include <cstddef>
#include <cstdint>

/// The limits of the model, the same for files, the window and the command line. Those of one sheet alone stand with
/// its curve.
namespace kriva::limits {

inline constexpr std::size_t kFileBytes = 64u << 20;
inline constexpr int kNesting = 64;             ///< of JSON
inline constexpr int kNumberCharacters = 1'000; ///< of a number in JSON
inline constexpr double kNumber = 1e9;          ///< largest absolute value of any number
inline constexpr std::size_t kPointsInCurve = 100'000;
inline constexpr std::size_t kCurvesInSheet = 1'000;
inline constexpr std::size_t kPointsInSheet = 1'000'000;
inline constexpr std::size_t kDerivedPointsInSheet = 2'000'000; ///< elevated points, or points of all pieces
inline constexpr std::size_t kControlPoints = 201;  ///< where one polynomial runs through all, multiplicities counted
inline constexpr std::uint64_t kSteps = 72'000'000; ///< of what the curves of a sheet have with each other
inline constexpr int kXmlNesting = 256;
inline constexpr int kXmlElements = 1'000'000;
inline constexpr int kXmlAttributes = 1'000; ///< in one tag
inline constexpr int kSvgUseNesting = 32;    ///< of an SVG file, one `use` inside another
inline constexpr int kSvgUses = 10'000;      ///< of an SVG file, each time that one is drawn

} // namespace kriva::limits
