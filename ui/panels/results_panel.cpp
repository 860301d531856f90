#include "ui/panels/results_panel.h"

#include "ui/panels/result_text.h"
#include "ui/sheets/sheet_editor.h"
#include "ui/sheets/sheet_relations.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr int kShownDigits = 10;
constexpr int kFullDigits = 17;

} // namespace

ResultsPanel::ResultsPanel(SheetEditor& editor, const SheetRelations& relations, QWidget* parent)
    : QTreeWidget(parent)
    , editor_(editor)
    , relations_(relations) {
    setObjectName(QStringLiteral("results"));
    setFrameShape(QFrame::NoFrame);
    setColumnCount(2);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    header()->setStretchLastSection(true);
    pending_.setSingleShot(true);
    pending_.setInterval(0);
    connect(&pending_, &QTimer::timeout, this, &ResultsPanel::showState);
    const auto later = [this] {
        if (!pending_.isActive())
            pending_.start();
    };
    connect(&relations, &SheetRelations::changed, this, later);
    connect(&editor.document(), &OpenDocument::replaced, this, later);
    connect(&editor.document(), &OpenDocument::viewChanged, this, later);
    connect(&editor.document(), &OpenDocument::curvesChanged, this, later);
    connect(&editor, &SheetEditor::shownCurveChanged, this, [this](Serial serial) {
        if (serial == editor_.activeSerial())
            pending_.start();
    });
    retranslateUi();
}

bool ResultsPanel::event(QEvent* event) {
    // Who copies here means these rows and not the points.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
        event->accept();
    return QTreeWidget::event(event);
}

void ResultsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QTreeWidget::changeEvent(event);
}

void ResultsPanel::retranslateUi() {
    setAccessibleName(tr("Results"));
    setHeaderLabels({tr("Name"), tr("Value")});
    showState();
}

void ResultsPanel::showState() {
    pending_.stop();
    const Curve* curve = editor_.shown(editor_.activeSerial());
    std::vector<Result> rows;
    if (curve && isIncomplete(*curve))
        rows.push_back({Caption::incomplete, {}, std::string()});
    else if (curve)
        rows = results(*curve);
    const std::vector<Result>& ofSheet = relations_.relations().results;
    rows.insert(rows.end(), ofSheet.begin(), ofSheet.end());
    while (topLevelItemCount() > static_cast<int>(rows.size()))
        delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < static_cast<int>(rows.size()))
        addTopLevelItem(new QTreeWidgetItem);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QTreeWidgetItem* item = topLevelItem(static_cast<int>(i));
        item->setText(0, resultName(rows[i]));
        item->setToolTip(0, resultName(rows[i]));
        item->setText(1, resultValue(rows[i], kShownDigits));
        item->setToolTip(1, resultValue(rows[i], kFullDigits));
    }
    showColumns();
}

void ResultsPanel::showColumns() {
    // A long name must not push the numbers out of sight.
    resizeColumnToContents(0);
    setColumnWidth(0, std::min(columnWidth(0), viewport()->width() * 11 / 20));
}

void ResultsPanel::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    showColumns();
}

void ResultsPanel::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        QTreeWidget::keyPressEvent(event);
}

void ResultsPanel::copy() const {
    QStringList lines;
    for (const QTreeWidgetItem* item : selectedItems())
        lines.append(item->text(0) + QLatin1Char('\t') + item->toolTip(1));
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace kriva::ui
