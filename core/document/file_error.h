#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kriva {

enum class FileProblem {
    notJson,
    nestedTooDeep, ///< more than numbers[0]
    foreignFormat,
    unknownVersion,
    unknownKey,
    repeatedKey,
    missingKey,
    expectedObject,
    expectedList,
    expectedText,
    expectedTrueOrFalse,
    expectedNumber,
    expectedWholeNumber,  ///< from numbers[0] to numbers[1]
    numberOutOfRange,     ///< numbers[0] to numbers[1]
    numberOutOfOpenRange, ///< between numbers[0] and numbers[1], both excluded
    expectedTwoNumbers,
    expectedOneOf, ///< words
    expectedColor,
    wrongCount,           ///< numbers[0] expected
    tooMany,              ///< more than numbers[0]
    tooManyPasses,        ///< in the crossings and overlaps of curves, more than numbers[0]
    tooManyIntersections, ///< of curves, to be found at all
    tooManyPairs,         ///< of points in runs that are interpolated, more than numbers[0]
    noSuchIndex,
    tooLarge,         ///< the file, more than numbers[0] bytes
    noDocumentInside, ///< an SVG without a document of Kriva
    notXml,
    internalSubset,    ///< an XML file that declares things of its own
    tooManyElements,   ///< of an XML file, more than numbers[0]
    tooManyAttributes, ///< of one tag, more than numbers[0]
    notPathData,       ///< of an SVG path
    badAttribute,      ///< words: its name in an element of an SVG file
    noPaths,           ///< an SVG file that draws no lines
};

/// Why a file was refused, and where: a path into the document (`sheets.spline.curves[0].knots[3].at`) or, where it
/// is no JSON or XML, a line and a column counted from 1. Its sentence is made where languages are known.
struct FileError {
    FileProblem problem = FileProblem::notJson;
    std::string place;
    std::vector<double> numbers;
    std::vector<std::string> words;
    int line = 0;
    int column = 0;
    friend bool operator==(const FileError&, const FileError&) = default;
};

/// Goes on from the place of an object to its member, from that of a list to its element.
void appendKey(std::string& place, std::string_view key);
void appendPosition(std::string& place, std::size_t position);

/// A problem of a file as a whole.
[[nodiscard]] FileError errorOfFile(FileProblem problem, std::vector<double> numbers = {});

/// A problem at a byte of a text: its line and its column, which counts bytes.
[[nodiscard]] FileError errorAtByte(FileProblem problem, std::string_view text, std::size_t byte);

} // namespace kriva
