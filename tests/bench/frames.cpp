#include "app/kept_memory.h"
#include "core/io/json/document_json.h"
#include "tests/support/test_window.h"

#include <QElapsedTimer>
#include <QFile>

#include <algorithm>
#include <cstdio>
#include <functional>

// Opens one document in the real window and tells for how long the window is dead at most while somebody works with it:
//
//   frames DOCUMENT
//
// Wall time from an event to the end of the loop's next turn, in milliseconds; what is worked out beside the window
// goes on meanwhile.
namespace kriva {
namespace {

[[nodiscard]] double turn(const std::function<void()>& act) {
    QElapsedTimer clock;
    clock.start();
    act();
    QApplication::processEvents();
    return static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

/// The longest of the turns until nothing more arrives.
[[nodiscard]] double longestTurn(ui::MainWindow& window, const std::function<void()>& act) {
    constexpr int kTurns = 400; // of 10 ms, for what is worked out beside the window
    double longest = turn(act);
    for (int i = 0; i < kTurns && window.workers().activeThreadCount() > 0; ++i) {
        window.workers().waitForDone(10);
        longest = std::max(longest, turn([] {}));
    }
    for (int i = 0; i < 3; ++i)
        longest = std::max(longest, turn([] {}));
    return longest;
}

void tell(const char* what, double milliseconds) {
    std::printf(" %s %7.1f", what, milliseconds);
}

int work(const Document& document) {
    test::TestWindow shell;
    ui::SheetTab& tab = shell.shown(document.active);
    ui::CanvasView& canvas = tab.canvas();
    tell("open", longestTurn(shell.window, [&] { shell.window.session().show(document); }));
    double zoom = 0;
    for (int i = 0; i < 5; ++i)
        zoom = std::max(zoom, longestTurn(shell.window, [&] { canvas.zoomIn(); }));
    tell("zoom", zoom);
    canvas.fitAll();
    tell("select", longestTurn(shell.window, [&] { QTest::keyClick(&canvas, Qt::Key_A, Qt::ControlModifier); }));
    double nudge = 0;
    for (int i = 0; i < 3; ++i)
        nudge = std::max(nudge, longestTurn(shell.window, [&] { QTest::keyClick(&canvas, Qt::Key_Right); }));
    tell("nudge", nudge);
    tell("undo", longestTurn(shell.window, [&] { shell.window.document().history(document.active).undo(); }));
    double tabs = 0;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        tabs = std::max(tabs, longestTurn(shell.window, [&] { shell.window.document().setActiveSheet(sheet); }));
    tell("tabs", tabs);
    std::puts("");
    return 0;
}

} // namespace
} // namespace kriva

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    kriva::keepFreedMemory();
    const QApplication application(argc, argv);
    QFile file(argc == 2 ? QString::fromLocal8Bit(argv[1]) : QString());
    if (!file.open(QIODevice::ReadOnly))
        return 2;
    const auto read = kriva::readDocument(file.readAll().toStdString());
    const auto* document = std::get_if<kriva::Document>(&read);
    return document ? kriva::work(*document) : 3;
}
