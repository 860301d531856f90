#include "ui/panels/guide/guide_panel.h"

#include "ui/base/examples.h"
#include "ui/base/language/language.h"
#include "ui/base/look/theme.h"
#include "ui/figures/figure_ink.h"
#include "ui/panels/guide/formula_html.h"
#include "ui/panels/guide/guide_figure.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFile>
#include <QScrollBar>
#include <QTimer>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

constexpr int kPageMargin = 14;     // px around the page
constexpr int kIndent = 18;         // px, of lists
constexpr int kWidestPicture = 460; // px: beyond it a figure of a few lines looks lost
constexpr int kNarrowestPicture = 160;

[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double part) {
    const auto mix = [part](int x, int y) { return static_cast<int>(part * x + (1 - part) * y); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

} // namespace

GuidePanel::GuidePanel(const QString& sheet, QWidget* parent)
    : QTextBrowser(parent)
    , sheet_(sheet) {
    setObjectName(QStringLiteral("guide"));
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // or pages would be laid out twice, without it and with it
    document()->setDocumentMargin(kPageMargin);
    document()->setIndentWidth(kIndent);
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) { scrollToAnchor(link.fragment()); });
    retranslateUi();
}

void GuidePanel::setExample(const Example* example) {
    if (example_ == example)
        return;
    example_ = example;
    invalidate();
    verticalScrollBar()->setValue(0);
}

void GuidePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        invalidate();
    QTextBrowser::changeEvent(event);
}

void GuidePanel::paintEvent(QPaintEvent* event) {
    QTextBrowser::paintEvent(event);
    if (isStale_)
        QTimer::singleShot(0, this, &GuidePanel::write);
}

void GuidePanel::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (pictureWidth() != writtenWidth_)
        invalidate();
}

void GuidePanel::retranslateUi() {
    setAccessibleName(tr("Guide"));
    invalidate();
}

void GuidePanel::invalidate() {
    isStale_ = true;
    viewport()->update();
}

void GuidePanel::write() {
    if (!isStale_)
        return;
    isStale_ = false;
    pictures_.clear();
    writtenWidth_ = pictureWidth();
    const int length = verticalScrollBar()->maximum();
    const double place = length > 0 ? static_cast<double>(verticalScrollBar()->value()) / length : 0;
    document()->setDefaultStyleSheet(styleSheetOfPage());
    setHtml(note() + withFormulas(source()));
    moveCursor(QTextCursor::End); // lays out all of it, so that the scroll bar knows its end
    moveCursor(QTextCursor::Start);
    verticalScrollBar()->setValue(qRound(place * verticalScrollBar()->maximum()));
}

QString GuidePanel::source() const {
    const Language language = languageOf(QLocale().name()).value_or(Language::English);
    QFile file(u":/guide/%1/%2.html"_s.arg(languageCode(language), sheet_));
    [[maybe_unused]] const bool isThere = file.open(QIODevice::ReadOnly);
    Q_ASSERT(isThere); // it is part of the program
    return QString::fromUtf8(file.readAll());
}

QString GuidePanel::note() const {
    if (!example_)
        return {};
    return u"<table class=\"note\" width=\"100%\" cellpadding=\"8\"><tr><td><b>%1</b><br>%2</td></tr></table>"_s.arg(
        QCoreApplication::translate("Menus", example_->name),
        QCoreApplication::translate("Examples", example_->lookAt));
}

QString GuidePanel::styleSheetOfPage() const {
    const QPalette colors = palette();
    const QString accent = colors.color(QPalette::Link).name();
    const QString ink = colors.color(QPalette::Text).name();
    const QString pale = mixed(colors.color(QPalette::Text), colors.color(QPalette::Base), 0.62).name();
    const QString card = colors.color(QPalette::AlternateBase).name();
    const double size = font().pointSizeF();
    return uR"(
        h1 { font-size: %6pt; font-weight: 600; margin-top: 4px; margin-bottom: 6px; }
        h2 { font-size: %7pt; font-weight: 600; color: %1; margin-top: 18px; margin-bottom: 4px; }
        p { margin-top: 5px; margin-bottom: 5px; line-height: 125%; }
        li { margin-bottom: 3px; line-height: 120%; }
        .figure { margin-top: 8px; margin-bottom: 0px; line-height: 100%; }
        a { color: %1; text-decoration: none; }
        .lead { color: %3; }
        .caption { color: %3; font-size: %8pt; margin-top: 0px; margin-bottom: 10px; }
        .math { font-family: '%5'; font-size: %12pt; }
        .formula td, p.formula { font-family: '%5'; font-size: %9pt; }
        .formula { margin-top: 6px; margin-bottom: 6px; }
        .formula td { white-space: nowrap; vertical-align: middle; padding-left: 1px; padding-right: 1px; }
        .frac-0 { border-bottom-width: 1px; border-bottom-style: solid; border-bottom-color: %2; }
        td.sum-0, td.sum-2 { font-size: %10pt; }
        td.sum-1 { font-size: %6pt; }
        td.brace { font-size: %11pt; }
        .note { background-color: %4; margin-bottom: 8px; }
        .table { border-collapse: collapse; border-width: 1px; border-style: solid; border-color: %3; }
        .table td, .table th { padding: 3px 6px 3px 6px; }
    )"_s.arg(accent, ink, pale, card, labelFonts(1).text.family())
        .arg(1.7 * size)
        .arg(1.2 * size)
        .arg(0.92 * size)
        .arg(1.2 * size)
        .arg(0.85 * size)
        .arg(2.2 * size)
        .arg(1.1 * size);
}

int GuidePanel::pictureWidth() const {
    return std::clamp(viewport()->width() - 2 * kPageMargin, kNarrowestPicture, kWidestPicture);
}

QVariant GuidePanel::loadResource(int type, const QUrl& name) {
    // Where this gives nothing at all the document would look for a file of that name.
    if (type != QTextDocument::ImageResource || name.scheme() != u"figure")
        return QImage();
    // The document asks at every layout and at every painting.
    auto picture = pictures_.constFind(name.path());
    if (picture == pictures_.constEnd()) {
        const Theme theme = isDark(palette()) ? Theme::dark : Theme::light;
        picture = pictures_.insert(name.path(), guideFigure(name.path(), {writtenWidth_, devicePixelRatioF(), theme}));
    }
    return *picture;
}

} // namespace kriva::ui
