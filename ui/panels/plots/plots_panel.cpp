#include "ui/panels/plots/plots_panel.h"

#include "ui/base/look/icons.h"
#include "ui/base/look/plain_label.h"
#include "ui/figures/caption_text.h"
#include "ui/panels/result_text.h"

#include <QEvent>
#include <QHBoxLayout>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr int kDigits = 6;
constexpr std::size_t kMostValues = 16; ///< more than anyone reads

/// "B<sub>0</sub>", "Run 0"
[[nodiscard]] QString nameOf(const PlotLine& line) {
    const QString index = QString::fromStdString(line.index).toHtmlEscaped();
    QString letter = QString::fromStdString(line.letter).toHtmlEscaped();
    if (!index.isEmpty())
        letter = QStringLiteral("<i>%1</i><sub>%2</sub>").arg(letter, index);
    return QStringLiteral("%1 %2").arg(captionText(line.caption), letter).trimmed();
}

/// "t = 0.5: B0 = 0.125; B1 = 0.375"
[[nodiscard]] QString valuesAt(const Plot& plot, double x) {
    QStringList values;
    for (const PlotLine& line : plot.lines)
        if (const auto y = valueAt(line, x); y && static_cast<std::size_t>(values.size()) < kMostValues)
            values.append(QStringLiteral("%1 = %2").arg(nameOf(line), valueText(*y, kDigits)));
    return QStringLiteral("<i>%1</i> = %2: %3")
        .arg(QString::fromStdString(plot.x.variable), valueText(x, kDigits), values.join(QStringLiteral("; ")));
}

/// "x′ = 2; y′ = 1"
[[nodiscard]] QString placeText(const Plot& plot, Point at) {
    return QStringLiteral("<i>%1</i> = %2; <i>%3</i> = %4")
        .arg(QString::fromStdString(plot.x.variable), valueText(at.x, kDigits), QString::fromStdString(plot.y.variable),
             valueText(at.y, kDigits));
}

} // namespace

PlotsPanel::PlotsPanel(ShownSheet& sheet, QWidget* parent)
    : QWidget(parent)
    , choice_(new KeptChoice(this))
    , export_(new QToolButton(this))
    , layout_(new QVBoxLayout(this))
    , work_(sheet, [this](const Curve* curve, WorkBudget& budget) -> CoalescingWorker::Take {
        return [this, made = curve ? plotsOf(*curve, budget) : std::nullopt] {
            take(made.value_or(std::vector<PlotGroup>()));
        };
    }) {
    work_.setWatched(false);
    export_->setIcon(icon(IconName::Export));
    export_->setAutoRaise(true);
    auto* row = new QHBoxLayout;
    row->addWidget(choice_, 1);
    row->addWidget(export_);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(2);
    layout_->addLayout(row);
    connect(choice_, &QComboBox::currentIndexChanged, this, &PlotsPanel::showGroup);
    connect(export_, &QToolButton::clicked, this, [this] {
        std::vector<Plot> shown;
        for (const Row& plot : rows_)
            shown.push_back(plot.view->shownPlot());
        Q_EMIT exportRequested(shown);
    });
    retranslateUi();
}

void PlotsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

void PlotsPanel::setWatched(bool isWatched) {
    work_.setWatched(isWatched);
}

void PlotsPanel::retranslateUi() {
    choice_->setAccessibleName(tr("Plot"));
    export_->setToolTip(tr("Export the plot"));
    export_->setAccessibleName(export_->toolTip());
    showNames();
    showGroup();
}

void PlotsPanel::take(std::vector<PlotGroup> groups) {
    groups_ = std::move(groups);
    showNames();
    showGroup();
}

void PlotsPanel::showNames() {
    QStringList names;
    for (const PlotGroup& group : groups_)
        names.append(captionText(group.caption));
    choice_->setNames(names);
    export_->setEnabled(!groups_.empty());
}

void PlotsPanel::showGroup() {
    const auto chosen = static_cast<std::size_t>(choice_->currentIndex());
    const std::vector<Plot> plots = chosen < groups_.size() ? groups_[chosen].plots : std::vector<Plot>();
    makeRows(plots.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QString caption = captionText(plots[i].caption);
        rows_[i].title->setText(caption);
        rows_[i].title->setVisible(plots.size() > 1); // one alone has the name of the choice
        rows_[i].view->setAccessibleName(caption);
        rows_[i].view->setPlot(plots[i]);
    }
    showValues();
}

void PlotsPanel::makeRows(std::size_t count) {
    for (; rows_.size() > count; rows_.pop_back()) {
        delete rows_.back().title;
        delete rows_.back().view;
        delete rows_.back().values;
    }
    while (rows_.size() < count) {
        const Row row{new PlainLabel(this), new PlotView(this), new PlainLabel(this)};
        row.values->setWordWrap(true);
        row.values->setTextInteractionFlags(Qt::TextSelectableByMouse);
        row.values->setMargin(2);
        row.values->setAlignment(Qt::AlignTop);
        layout_->addWidget(row.title);
        layout_->addWidget(row.view, 1);
        layout_->addWidget(row.values);
        connect(row.view, &PlotView::crosshairMoved, this, [this](std::optional<double> x) {
            for (const Row& other : rows_)
                other.view->setCrosshair(x);
            showValues();
        });
        connect(row.view, &PlotView::pointedAtMoved, this, &PlotsPanel::showValues);
        connect(row.view, &PlotView::partChanged, this, [this](const std::optional<Box>& part) {
            for (const Row& other : rows_)
                other.view->setPart(part);
        });
        rows_.push_back(row);
    }
}

void PlotsPanel::showValues() {
    for (const Row& row : rows_) {
        const Plot& plot = row.view->plot();
        const std::optional<double> x = row.view->crosshair() ? row.view->crosshair() : plot.at;
        QString text = QStringLiteral(" ");
        if (plot.isToScale && row.view->pointedAt())
            text = placeText(plot, *row.view->pointedAt());
        else if (!plot.isToScale && x)
            text = valuesAt(plot, *x);
        row.values->setText(text);
        // A line more makes room once and for all, or the plot would jump about under the pointer.
        row.values->setMinimumHeight(
            std::max(row.values->minimumHeight(), row.values->heightForWidth(row.values->width())));
    }
}

} // namespace kriva::ui
