#pragma once

#include <cstddef>
#include <cstdint>

/// The limits of the model, the same for files, the window and the command line.
namespace kriva::limits {

inline constexpr std::size_t kFileBytes = 64u << 20;
inline constexpr int kNesting = 64;             ///< of JSON
inline constexpr int kNumberCharacters = 1'000; ///< of a number in JSON
inline constexpr double kNumber = 1e9;          ///< largest absolute value of any number
inline constexpr std::size_t kPointsInCurve = 100'000;
inline constexpr std::size_t kCurvesInSheet = 1'000;
inline constexpr std::size_t kPointsInSheet = 1'000'000;
inline constexpr std::size_t kDerivedPointsInSheet = 2'000'000; ///< elevated points, or points of all pieces
inline constexpr std::size_t kControlPoints = 201; ///< where one polynomial runs through all, multiplicities counted
inline constexpr int kElevations = 10'000;
inline constexpr int kLevels = 16;
inline constexpr int kSplineDegreeLow = 2;
inline constexpr int kSplineDegreeHigh = 5;
inline constexpr int kFitDegreeLow = 1;
inline constexpr int kFitDegreeHigh = 9;
inline constexpr std::size_t kReportedSegments = 20'000;
inline constexpr std::size_t kReportedSchemePoints = 2'000'000; ///< of de Casteljau, of all curves of a sheet
inline constexpr std::size_t kPasses = 1'000'000;               ///< in the crossings and overlaps of a sheet
inline constexpr std::uint64_t kSteps = 72'000'000;             ///< of the search for them
/// Of points in the interpolated runs of a sheet that is reported or drawn into a file: one takes some 4 microseconds.
inline constexpr std::size_t kInterpolatedPairs = 1'000'000;
/// Of the paths of combined curves, in the same: one takes some 15 microseconds.
inline constexpr std::size_t kPathPieces = 200'000;
inline constexpr int kXmlNesting = 256;
inline constexpr int kXmlElements = 1'000'000;
inline constexpr int kXmlAttributes = 1'000; ///< in one tag
inline constexpr int kSvgUseNesting = 32;    ///< of an SVG file, one `use` inside another
inline constexpr int kSvgUses = 10'000;      ///< of an SVG file, each time that one is drawn

} // namespace kriva::limits
