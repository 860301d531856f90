#include "ui/document/import_text.h"

#include "core/curve/limits.h"
#include "ui/base/language/number_text.h"
#include "ui/document/error_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

class TableErrors {
    Q_DECLARE_TR_FUNCTIONS(TableErrors)
  public:
    static QString reason(const TableError& error) {
        const QString cell = QString::fromStdString(error.cell);
        switch (error.problem) {
        case TableProblem::empty:
            return tr("there are no points");
        case TableProblem::tooManyPoints:
            return tr("more than %1 points are too many").arg(limits::kPointsInSheet);
        case TableProblem::tooManyPointsInCurve:
            return tr("a curve takes at most %1 points").arg(limits::kPointsInCurve);
        case TableProblem::notTwoNumbers:
            return tr("expected two numbers");
        case TableProblem::noNumber:
            return tr("“%1” is no number").arg(cell);
        case TableProblem::outOfRange:
            return tr("“%1” is not from %2 to %3")
                .arg(cell, formatNumber(-limits::kNumber), formatNumber(limits::kNumber));
        case TableProblem::mixedDecimals:
            return tr("“%1” has another decimal sign than the numbers before it").arg(cell);
        }
        return {};
    }
    static QString at(const TableError& error) { return tr("line %1, column %2").arg(error.line).arg(error.column); }
};

QString tableErrorText(const TableError& error) {
    const QString reason = TableErrors::reason(error);
    return error.line == 0 ? reason : QStringLiteral("%1: %2").arg(TableErrors::at(error), reason);
}

} // namespace

std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text) {
    auto read = readImportedText({text.constData(), static_cast<std::size_t>(text.size())});
    if (const FileError* error = std::get_if<FileError>(&read))
        return errorText(*error);
    if (const TableError* error = std::get_if<TableError>(&read))
        return tableErrorText(*error);
    return std::get<std::vector<ImportedPath>>(std::move(read));
}

} // namespace kriva::ui
