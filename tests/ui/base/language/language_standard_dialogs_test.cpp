#include "ui/base/language/language.h"

#include <gtest/gtest.h>
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QErrorMessage>
#include <QFileDialog>
#include <QGroupBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPageSetupDialog>
#include <QPrintDialog>
#include <QPrinter>
#include <QProgressDialog>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTextEdit>
#include <QUndoGroup>
#include <QUndoStack>
#include <QUndoView>

#include <functional>
#include <memory>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

/// What stays as it is in every language: the button and the keys, units, formats, names of paper and of measures.
const QRegularExpression
    kNamesOfTheWorld(uR"(\b(OK|Ctrl|Alt|Shift|Left|Right|Up|HTML|PDF|in|mm|pt|DD|CC|Didot|Cicero|)"
                     uR"(ANSI|JIS|PRC \d+K|Letter|Legal|Ledger|Tabloid|Quarto|Super|Folio|Executive)\b)"_s);

/// Everything that a widget and those inside it say.
QStringList textsOf(const QObject* object) {
    QStringList texts;
    if (const auto* widget = qobject_cast<const QWidget*>(object))
        texts << widget->windowTitle() << widget->toolTip() << widget->statusTip() << widget->whatsThis()
              << widget->accessibleName() << widget->accessibleDescription();
    if (const auto* button = qobject_cast<const QAbstractButton*>(object))
        texts << button->text();
    if (const auto* label = qobject_cast<const QLabel*>(object))
        texts << label->text();
    if (const auto* group = qobject_cast<const QGroupBox*>(object))
        texts << group->title();
    if (const auto* action = qobject_cast<const QAction*>(object))
        texts << action->text() << action->toolTip() << action->shortcut().toString(QKeySequence::NativeText);
    if (const auto* tabs = qobject_cast<const QTabWidget*>(object)) {
        for (int i = 0; i < tabs->count(); ++i)
            texts << tabs->tabText(i);
    }
    if (const auto* box = qobject_cast<const QComboBox*>(object)) {
        for (int i = 0; i < box->count(); ++i)
            texts << box->itemText(i);
    }
    if (const auto* view = qobject_cast<const QAbstractItemView*>(object)) {
        const QAbstractItemModel* model = view->model();
        for (int column = 0; model && column < model->columnCount(view->rootIndex()); ++column)
            texts << model->headerData(column, Qt::Horizontal).toString();
    }
    for (const QObject* child : object->children())
        texts << textsOf(child);
    return texts;
}

using Maker = std::function<std::unique_ptr<QObject>()>;

std::unique_ptr<QObject> messageBox() {
    auto box = std::make_unique<QMessageBox>();
    constexpr auto kAll = QMessageBox::Ok | QMessageBox::Save | QMessageBox::SaveAll | QMessageBox::Open |
                          QMessageBox::Yes | QMessageBox::YesToAll | QMessageBox::No | QMessageBox::NoToAll |
                          QMessageBox::Abort | QMessageBox::Retry | QMessageBox::Ignore | QMessageBox::Close |
                          QMessageBox::Cancel | QMessageBox::Discard | QMessageBox::Help | QMessageBox::Apply |
                          QMessageBox::Reset | QMessageBox::RestoreDefaults;
    box->setStandardButtons(kAll);
    box->setDetailedText(u"-"_s);
    return box;
}

std::unique_ptr<QObject> fileDialog(QFileDialog::AcceptMode mode) {
    auto dialog = std::make_unique<QFileDialog>();
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(mode);
    // Paths are not words.
    for (auto* box : dialog->findChildren<QComboBox*>(u"lookInCombo"_s))
        box->clear();
    return dialog;
}

std::unique_ptr<QObject> colorDialog() {
    auto dialog = std::make_unique<QColorDialog>();
    dialog->setOptions(QColorDialog::DontUseNativeDialog | QColorDialog::ShowAlphaChannel);
    return dialog;
}

std::unique_ptr<QObject> inputDialog() {
    auto dialog = std::make_unique<QInputDialog>();
    dialog->adjustSize(); // it is empty until its size matters
    return dialog;
}

std::unique_ptr<QObject> undoView() {
    auto group = std::make_unique<QWidget>();
    auto* undo = new QUndoGroup(group.get());
    group->addAction(undo->createUndoAction(group.get()));
    group->addAction(undo->createRedoAction(group.get()));
    auto* view = new QUndoView(undo, group.get());
    auto* stack = new QUndoStack(undo);
    undo->setActiveStack(stack);
    new QLabel(view->model()->index(0, 0).data().toString(), group.get());
    return group;
}

/// The menu of a widget that makes it anew for each use.
template <typename Widget>
std::unique_ptr<QObject> contextMenuOf() {
    auto widget = std::make_unique<Widget>();
    widget->createStandardContextMenu()->setParent(widget.get());
    return widget;
}

template <typename Dialog>
std::unique_ptr<QObject> printerDialog() {
    static QPrinter printer;
    return std::make_unique<Dialog>(&printer);
}

const std::array<std::pair<const char*, Maker>, 13> kDialogs = {{
    {"message box", messageBox},
    {"open file", [] { return fileDialog(QFileDialog::AcceptOpen); }},
    {"save file", [] { return fileDialog(QFileDialog::AcceptSave); }},
    {"colour", colorDialog},
    {"input", inputDialog},
    {"progress", [] { return std::make_unique<QProgressDialog>(); }},
    {"error message", [] { return std::make_unique<QErrorMessage>(); }},
    {"dock", [] { return std::make_unique<QDockWidget>(); }},
    {"undo", undoView},
    {"menu of a line", contextMenuOf<QLineEdit>},
    {"menu of a text", contextMenuOf<QTextEdit>},
    {"print", printerDialog<QPrintDialog>},
    {"page setup", printerDialog<QPageSetupDialog>},
}};

bool hasWords(QString text) {
    static const QRegularExpression words(uR"([A-Za-z]{2,})"_s);
    return text.remove(u'&').remove(kNamesOfTheWorld).contains(words);
}

class StandardDialogs : public ::testing::TestWithParam<Language> {
  protected:
    ~StandardDialogs() override { QLocale::setDefault(QLocale(QLocale::English)); }
};

TEST_P(StandardDialogs, sayNothingInEnglish) {
    LanguageSwitch languages(Language::English);
    for (const auto& [name, make] : kDialogs) {
        languages.setLanguage(Language::English);
        const QStringList english = textsOf(make().get());
        languages.setLanguage(GetParam());
        const QStringList texts = textsOf(make().get());
        ASSERT_EQ(texts.size(), english.size()) << name;
        EXPECT_FALSE(english.filter(QRegularExpression(u"[A-Za-z]{2,}"_s)).isEmpty()) << name << " says nothing";
        for (qsizetype i = 0; i < texts.size(); ++i)
            EXPECT_FALSE(texts[i] == english[i] && hasWords(texts[i])) << name << ": " << texts[i].toStdString();
    }
}

TEST_P(StandardDialogs, haveTranslatedMenusWhereQtMakesThemOnTheSpot) {
    const LanguageSwitch languages(GetParam());
    const std::array<std::pair<const char*, const char*>, 6> sources = {{{"QScrollBar", "Scroll here"},
                                                                         {"QAbstractSpinBox", "&Step up"},
                                                                         {"QAbstractFileIconProvider", "Folder"},
                                                                         {"QMessageBox", "About Qt"},
                                                                         {"QShortcut", "Space"},
                                                                         {"CloseButton", "Close Tab"}}};
    for (const auto& [context, source] : sources)
        EXPECT_NE(QCoreApplication::translate(context, source), QString::fromLatin1(source)) << context;
}

INSTANTIATE_TEST_SUITE_P(Languages, StandardDialogs,
                         ::testing::Values(Language::Bulgarian, Language::Slovenian, Language::Ukrainian),
                         [](const auto& language) { return languageCode(language.param).toStdString(); });

} // namespace
} // namespace kriva::ui
