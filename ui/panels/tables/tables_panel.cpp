#include "ui/panels/tables/tables_panel.h"

#include "core/io/tables/table_writer.h"
#include "ui/base/look/plain_label.h"
#include "ui/figures/caption_text.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include <utility>

namespace kriva::ui {

TablesPanel::TablesPanel(ShownSheet& sheet, Tables tables, QWidget* parent)
    : QWidget(parent)
    , choice_(new KeptChoice(this))
    , view_(new QTableView(this))
    , sum_(new PlainLabel(this))
    , latex_(new QToolButton(this))
    , csv_(new QToolButton(this))
    , pointedOut_(sheet)
    , work_(sheet,
            [this, tables = std::move(tables)](const Curve* curve, WorkBudget& budget) -> CoalescingWorker::Take {
                return [this, made = curve ? tables(*curve, budget) : std::nullopt] {
                    take(made.value_or(std::vector<Table>()));
                };
            }) {
    work_.setWatched(false);
    view_->setModel(&model_);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAlternatingRowColors(true);
    view_->setWordWrap(false);
    view_->verticalHeader()->hide();
    view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->horizontalHeader()->setResizeContentsPrecision(0); // as wide as what is seen needs
    auto* row = new QHBoxLayout;
    row->addWidget(choice_, 1);
    row->addWidget(latex_);
    row->addWidget(csv_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(view_, 1);
    layout->addWidget(sum_);
    sum_->setObjectName(QStringLiteral("sum"));
    sum_->setWordWrap(true);
    sum_->setMargin(4);
    sum_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        followChoice();
        pointedOut_.choose(chosenPlaces());
    });
    connect(choice_, &QComboBox::currentIndexChanged, this, &TablesPanel::showTable);
    connect(latex_, &QToolButton::clicked, this, &TablesPanel::copyLatex);
    connect(csv_, &QToolButton::clicked, this, &TablesPanel::copyDelimited);
    retranslateUi();
}

void TablesPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

void TablesPanel::setWatched(bool isWatched) {
    work_.setWatched(isWatched);
    pointedOut_.choose(isWatched ? chosenPlaces() : Points());
}

void TablesPanel::retranslateUi() {
    choice_->setAccessibleName(tr("Table"));
    view_->setAccessibleName(tr("Numbers of the table"));
    latex_->setText(tr("LaTeX"));
    latex_->setToolTip(tr("Copy the table as LaTeX"));
    latex_->setAccessibleName(latex_->toolTip());
    csv_->setText(tr("CSV"));
    csv_->setToolTip(tr("Copy the table for a spreadsheet"));
    csv_->setAccessibleName(csv_->toolTip());
    showNames();
    model_.retranslate();
    view_->resizeColumnsToContents();
    followChoice();
}

void TablesPanel::take(std::vector<Table> tables) {
    tables_ = std::move(tables);
    showNames();
    showTable();
    chooseAsked();
    asked_.reset();
}

void TablesPanel::explain(Point point) {
    asked_ = point;
    chooseAsked();
}

void TablesPanel::chooseAsked() {
    const auto onView = static_cast<std::size_t>(choice_->currentIndex());
    if (!asked_ || (onView < tables_.size() && chooseIn(onView, *asked_)))
        return;
    for (std::size_t table = 0; table < tables_.size(); ++table)
        if (chooseIn(table, *asked_))
            return;
}

bool TablesPanel::chooseIn(std::size_t table, Point point) {
    const std::optional<CellIndex> cell = cellOf(tables_[table], point);
    if (!cell)
        return false;
    asked_.reset();
    choice_->setCurrentIndex(static_cast<int>(table));
    view_->setCurrentIndex(model_.index(static_cast<int>(cell->row), static_cast<int>(cell->column)));
    return true;
}

void TablesPanel::showNames() {
    QStringList names;
    for (const Table& table : tables_)
        names.append(captionText(table.caption));
    choice_->setNames(names);
    latex_->setEnabled(!tables_.empty());
    csv_->setEnabled(!tables_.empty());
}

void TablesPanel::showTable() {
    const auto chosen = static_cast<std::size_t>(choice_->currentIndex());
    const Table before = model_.table();
    model_.setTable(chosen < tables_.size() ? tables_[chosen] : Table());
    if (model_.table().caption != before.caption || model_.table().columns != before.columns)
        view_->resizeColumnsToContents();
    else
        widenColumns();
    followChoice();
    pointedOut_.follow(chosenPlaces());
}

/// Where numbers grew longer. None becomes narrower, or they would jump about in a drag.
void TablesPanel::widenColumns() {
    QHeaderView& header = *view_->horizontalHeader();
    for (int column = 0; column < model_.columnCount(); ++column) {
        const int before = header.sectionSize(column);
        view_->resizeColumnToContents(column);
        if (header.sectionSize(column) < before)
            header.resizeSection(column, before);
    }
}

void TablesPanel::followChoice() {
    const QModelIndexList chosen = view_->selectionModel()->selectedIndexes();
    const QString text = chosen.isEmpty() ? QString() : model_.sumText(chosen.last().row());
    sum_->setText(text);
    sum_->setVisible(!text.isEmpty());
}

Points TablesPanel::chosenPlaces() const {
    Points places;
    for (const QModelIndex& cell : view_->selectionModel()->selectedIndexes())
        if (const std::optional<Point> place = model_.place(cell))
            places.push_back(*place);
    return places;
}

void TablesPanel::copyLatex() const {
    QGuiApplication::clipboard()->setText(QString::fromStdString(writeLatex(model_.table(), textSource())));
}

void TablesPanel::copyDelimited() const {
    QGuiApplication::clipboard()->setText(QString::fromStdString(writeDelimited(model_.table(), textSource())));
}

} // namespace kriva::ui
