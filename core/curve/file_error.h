#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kriva {

enum class FileProblem {
    notJson,
    nestedTooDeep, ///< more than numbers[0]
    numberTooLong, ///< more than numbers[0] characters
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
    wrongCount,            ///< numbers[0] expected
    tooMany,               ///< more than numbers[0]
    tooManyPasses,         ///< in the crossings and overlaps of curves, more than numbers[0]
    tooManyIntersections,  ///< of curves, to be found at all
    tooManyPairs,          ///< of points in runs that are interpolated, more than numbers[0]
    tooManyPathPieces,     ///< of combined curves, for a report or a file: at most numbers[0], and they are numbers[1]
    tooManyCurves,         ///< in a sheet: at most numbers[0], and they are numbers[1]
    tooManyPoints,         ///< in a sheet, more than numbers[0]
    tooManyDerivedPoints,  ///< in a sheet, those of elevated curves and of pieces: more than numbers[0]
    tooManyPointsInCurve,  ///< at most numbers[0], and it has numbers[1]
    tooManyPointsInRun,    ///< of an interpolation: at most numbers[0], and one has numbers[1]
    tooManySegments,       ///< for a report: at most numbers[0] in a sheet, and they are numbers[1]
    tooManySchemePoints,   ///< of de Casteljau, for a report: at most numbers[0] in a sheet, and they are numbers[1]
    coordinatesOutOfRange, ///< numbers[0] to numbers[1]
    noSuchIndex,
    tooLarge,          ///< the file, more than numbers[0] bytes
    noDocumentInside,  ///< an SVG without a document of Kriva
    notXml,            ///< not well-formed
    secondRoot,        ///< something behind the outermost element of an XML file
    repeatedAttribute, ///< words: its name
    unknownEntity,     ///< words: its name
    notInEncoding,     ///< an XML file that says it is UTF-8
    unknownEncoding,   ///< of an XML file; words: its name
    noXmlCharacter,    ///< words: its code, "U+FFFE"
    internalSubset,    ///< an XML file that declares things of its own
    tooManyElements,   ///< of an XML file, more than numbers[0]
    tooManyAttributes, ///< of one tag, more than numbers[0]
    tooManyUses,       ///< of elements of an SVG file by others, more than numbers[0]
    usedTooDeep,       ///< one use inside another, more than numbers[0]
    notPathData,       ///< of an SVG path
    badAttribute,      ///< words: its name in an element of an SVG file
    farAttribute,      ///< words: the one that leads beyond coordinates from numbers[0] to numbers[1]
    noPaths,           ///< an SVG file that draws no lines
};

/// Why a file or an edit was refused, and where: a path into the document (`sheets.spline.curves[0].knots[3].at`), in
/// XML and where it is no JSON a line and a column counted from 1, or an imported curve; an edit has no place. Its
/// sentence is made where languages are known.
struct FileError {
    FileProblem problem = FileProblem::notJson;
    std::string place;
    std::vector<double> numbers;
    std::vector<std::string> words;
    int line = 0;
    int column = 0;
    bool isInFigure = false; ///< the place is one of the document inside a figure, whose element the line is that of
    int curve = 0;           ///< of those that are imported, from 1; `place` is its name then
    friend bool operator==(const FileError&, const FileError&) = default;
};

/// Goes on from the place of an object to its member, from that of a list to its element.
void appendKey(std::string& place, std::string_view key);
void appendPosition(std::string& place, std::size_t position);

/// A problem of a file as a whole.
[[nodiscard]] FileError errorOfFile(FileProblem problem, std::vector<double> numbers = {});

/// Why a curve of so many points has more than it may have; nothing where it has not.
[[nodiscard]] std::optional<FileError> pointCountError(std::size_t points, std::size_t most);

/// A problem at a byte of a text: its line and its column, which counts bytes.
[[nodiscard]] FileError errorAtByte(FileProblem problem, std::string_view text, std::size_t byte);

} // namespace kriva
