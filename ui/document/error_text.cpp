#include "ui/document/error_text.h"

#include "ui/base/language/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace kriva::ui {
namespace {

/// Names come from files, which may have them as long as they like.
QString shortened(const QString& text) {
    constexpr qsizetype kLongest = 200;
    constexpr qsizetype kKept = kLongest / 2 - 1; // at either end
    return text.size() <= kLongest ? text : text.first(kKept) + QChar(u'…') + text.last(kKept);
}

class Errors {
    Q_DECLARE_TR_FUNCTIONS(Errors)
  public:
    static QString reason(const FileError& error);
    /// What only files of XML have.
    static QString xmlReason(const FileError& error);
    static QString fault(const ReadError& error, const QString& path);
    static QString fault(const WriteError& error, const QString& path);
    static QString limitReason(const FileError& error);
    static QString place(const FileError& error);
    static QString lostRights(const QString& path) {
        return tr("%1: written, but the owner or the permissions of the file could not be kept").arg(path);
    }

  private:
    static QString number(const FileError& error, std::size_t i) {
        return i < error.numbers.size() ? formatNumber(error.numbers[i]) : QString();
    }
    static QString words(const FileError& error) {
        QStringList list;
        for (const std::string& word : error.words)
            list.append(shortened(QString::fromStdString(word)));
        return list.join(QLatin1String(", "));
    }
};

QString Errors::reason(const FileError& error) {
    switch (error.problem) {
    case FileProblem::notJson:
        return tr("this is no JSON");
    case FileProblem::nestedTooDeep:
        return tr("nested more than %1 deep").arg(number(error, 0));
    case FileProblem::numberTooLong:
        return tr("a number of more than %1 characters").arg(number(error, 0));
    case FileProblem::foreignFormat:
        return tr("this is no document of Kriva");
    case FileProblem::unknownVersion:
        return tr("version %1 needs a newer Kriva").arg(number(error, 0));
    case FileProblem::unknownKey:
        return tr("unknown key");
    case FileProblem::repeatedKey:
        return tr("the key stands here twice");
    case FileProblem::missingKey:
        return tr("the key “%1” is missing").arg(words(error));
    case FileProblem::expectedObject:
        return tr("expected an object");
    case FileProblem::expectedList:
        return tr("expected a list");
    case FileProblem::expectedText:
        return tr("expected a text");
    case FileProblem::expectedTrueOrFalse:
        return tr("expected true or false");
    case FileProblem::expectedNumber:
        return tr("expected a number");
    case FileProblem::expectedWholeNumber:
        return tr("expected a whole number from %1 to %2").arg(number(error, 0), number(error, 1));
    case FileProblem::numberOutOfRange:
        return tr("expected a number from %1 to %2").arg(number(error, 0), number(error, 1));
    case FileProblem::numberOutOfOpenRange:
        return tr("expected a number between %1 and %2").arg(number(error, 0), number(error, 1));
    case FileProblem::expectedTwoNumbers:
        return tr("expected two finite numbers");
    case FileProblem::expectedOneOf:
        return tr("expected one of: %1").arg(words(error));
    case FileProblem::expectedColor:
        return tr("expected a colour like #0072b2");
    case FileProblem::wrongCount:
        return tr("expected %n element(s)", nullptr, error.numbers.empty() ? 0 : static_cast<int>(error.numbers[0]));
    case FileProblem::tooMany:
        return tr("more than %1 is too many").arg(number(error, 0));
    case FileProblem::noSuchIndex:
        return tr("no such index");
    case FileProblem::tooLarge:
        return tr("the file is larger than %1 bytes").arg(number(error, 0));
    case FileProblem::noDocumentInside:
        return tr("this figure has no document of Kriva inside");
    default: {
        const QString limit = limitReason(error);
        return limit.isEmpty() ? xmlReason(error) : limit;
    }
    }
}

QString Errors::limitReason(const FileError& error) {
    switch (error.problem) {
    case FileProblem::tooManyCurves:
        return tr("a sheet takes at most %1 curves, and these are %2").arg(number(error, 0), number(error, 1));
    case FileProblem::tooManyPoints:
        return tr("a sheet takes at most %1 points").arg(number(error, 0));
    case FileProblem::tooManyDerivedPoints:
        return tr("a sheet takes at most %1 points of elevated curves and of pieces").arg(number(error, 0));
    case FileProblem::tooManyPointsInCurve:
        return tr("this curve takes at most %1 points, and would have %2").arg(number(error, 0), number(error, 1));
    case FileProblem::tooManyPointsInRun:
        return tr("interpolation takes at most %1 points in a monotone run, and one has %2")
            .arg(number(error, 0), number(error, 1));
    case FileProblem::tooManySegments:
        return tr("a report takes at most %1 segments of a sheet, and these are %2")
            .arg(number(error, 0), number(error, 1));
    case FileProblem::tooManySchemePoints:
        return tr("a report takes at most %1 points of de Casteljau schemes of a sheet, and these are %2")
            .arg(number(error, 0), number(error, 1));
    case FileProblem::tooManyPasses:
        return tr("more than %1 passes through crossings and overlaps are too many").arg(number(error, 0));
    case FileProblem::tooManyIntersections:
        return tr("the curves have too many intersections to work out");
    case FileProblem::tooManyPathPieces:
        return tr("a report or a figure takes at most %1 pieces of the curves of a sheet, and these are %2")
            .arg(number(error, 0), number(error, 1));
    case FileProblem::tooManyPairs:
        return tr("the interpolated runs have more than %1 pairs of points").arg(number(error, 0));
    case FileProblem::coordinatesOutOfRange:
        return tr("coordinates go from %1 to %2").arg(number(error, 0), number(error, 1));
    case FileProblem::tooManyUses:
        return tr("more than %1 uses of elements are too many").arg(number(error, 0));
    case FileProblem::usedTooDeep:
        return tr("uses of elements are nested more than %1 deep").arg(number(error, 0));
    default:
        return {};
    }
}

QString Errors::xmlReason(const FileError& error) {
    switch (error.problem) {
    case FileProblem::notXml:
        return tr("this is no XML");
    case FileProblem::secondRoot:
        return tr("there is something behind the end of the outermost element");
    case FileProblem::repeatedAttribute:
        return tr("the attribute “%1” stands here twice").arg(words(error));
    case FileProblem::unknownEntity:
        return tr("the entity “%1” is unknown").arg(words(error));
    case FileProblem::notInEncoding:
        return tr("this is no UTF-8, which the file says that it is");
    case FileProblem::unknownEncoding:
        return tr("the encoding “%1” cannot be read").arg(words(error));
    case FileProblem::noXmlCharacter:
        return tr("“%1” is no character of XML").arg(words(error));
    case FileProblem::internalSubset:
        return tr("the document type has declarations of its own");
    case FileProblem::tooManyElements:
        return tr("more than %1 elements are too many").arg(number(error, 0));
    case FileProblem::tooManyAttributes:
        return tr("more than %1 attributes are too many").arg(number(error, 0));
    case FileProblem::notPathData:
        return tr("this is no path data");
    case FileProblem::badAttribute:
        return tr("the attribute “%1” cannot be read").arg(words(error));
    case FileProblem::farAttribute:
        return tr("the attribute “%1” leads beyond the coordinates from %2 to %3")
            .arg(words(error), number(error, 0), number(error, 1));
    case FileProblem::noPaths:
        return tr("there is no path to import");
    default:
        return {};
    }
}

QString Errors::place(const FileError& error) {
    const QString name = shortened(QString::fromStdString(error.place));
    if (error.curve > 0 && name.isEmpty())
        return tr("curve %1").arg(error.curve);
    if (error.curve > 0)
        return tr("curve %1, “%2”").arg(QString::number(error.curve), name);
    if (error.line == 0)
        return QString::fromStdString(error.place);
    const QString line = tr("line %1, column %2").arg(error.line).arg(error.column);
    return error.isInFigure ? tr("%1, the document inside").arg(line) : line;
}

QString Errors::fault(const ReadError& error, const QString& path) {
    switch (error.fault) {
    case ReadFault::Missing:
        // Whoever reads a name that is no UTF-8 has this in place of what is none, and asks for another file.
        return (path.contains(QChar::ReplacementCharacter)
                    ? tr("%1: there is no file of this name, and one whose name is no UTF-8 cannot be opened")
                    : tr("%1: there is no such file"))
            .arg(path);
    case ReadFault::NotRegular:
        return tr("%1: this is no regular file").arg(path);
    case ReadFault::TooLarge:
        return tr("%1: the file is larger than %2 bytes").arg(path, QString::number(kLargestFile));
    case ReadFault::Denied:
        return tr("%1: reading is not permitted").arg(path);
    case ReadFault::Failed:
        return tr("%1: the file cannot be read (%2)").arg(path, qt_error_string(error.systemError));
    }
    return {};
}

QString Errors::fault(const WriteError& error, const QString& path) {
    switch (error.fault) {
    case WriteFault::NotRegular:
        return tr("%1: this is no regular file").arg(path);
    case WriteFault::NoFolder:
        return tr("%1: there is no such folder").arg(path);
    case WriteFault::Denied:
        return tr("%1: writing is not permitted").arg(path);
    case WriteFault::Full:
        return tr("%1: there is no space left").arg(path);
    case WriteFault::Failed:
        return tr("%1: the file cannot be written (%2)").arg(path, qt_error_string(error.systemError));
    }
    return {};
}

} // namespace

QString errorText(const FileError& error) {
    const QString place = Errors::place(error);
    return place.isEmpty() ? Errors::reason(error) : QStringLiteral("%1: %2").arg(place, Errors::reason(error));
}

QString reasonText(const FileError& error) {
    return Errors::reason(error);
}

QString errorText(const ReadError& error, const QString& path) {
    return Errors::fault(error, path);
}

QString errorText(const OpenError& error, const QString& path) {
    if (const FileError* refused = std::get_if<FileError>(&error))
        return QStringLiteral("%1: %2").arg(path, errorText(*refused));
    return errorText(std::get<ReadError>(error), path);
}

QString errorText(const WriteError& error, const QString& path) {
    return Errors::fault(error, path);
}

QString lostRightsText(const QString& path) {
    return Errors::lostRights(path);
}

} // namespace kriva::ui
