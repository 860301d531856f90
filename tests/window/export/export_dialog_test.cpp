#include "core/io/open.h"
#include "tests/support/panel_test.h"
#include "ui/export/export_dialog.h"
#include "ui/figures/caption_text.h"

#include <QClipboard>
#include <QMimeData>
#include <QThreadPool>

namespace kriva::ui {
namespace {

/// The drawing of a dialog without a window, once it is worked out.
const Drawing& shownIn(const ExportDialog& dialog, QThreadPool& workers) {
    QApplication::processEvents();
    workers.waitForDone();
    QApplication::processEvents();
    return dialog.findChild<FigurePreview*>()->drawing();
}

class ExportDialogTest : public test::PanelTest {
  protected:
    ExportDialogTest()
        : PanelTest(test::kSpline)
        , dialog_(sheetToExport(document().value(), sheet_), {}, shell.window.workers()) {
        dialog_.show();
    }
    [[nodiscard]] const Drawing& shown() {
        test::settle();
        return dialog_.findChild<FigurePreview*>()->drawing();
    }
    void chooseFormat(FigureFormat format) {
        auto& box = test::named<QComboBox>(dialog_, "Format");
        box.setCurrentIndex(box.findData(static_cast<int>(format)));
    }
    [[nodiscard]] bool offers(const char* name) {
        for (const QWidget* widget : dialog_.findChildren<QWidget*>())
            if (widget->accessibleName() == QLatin1String(name))
                return widget->isVisibleTo(&dialog_);
        return false;
    }

    ExportDialog dialog_;
};

TEST_F(ExportDialogTest, showsTheFigureAsItsFileWillBe) {
    const Drawing usual = drawingOf(document().value(), sheet_, textSource());
    EXPECT_EQ(shown().figure, usual.figure);
    EXPECT_EQ(shown().page.width, usual.page.width);
    test::click(test::saying<QCheckBox>(dialog_, "Set the &width"));
    test::type(test::named<NumberField>(dialog_, "Width (mm)"), "80");
    test::type(test::named<NumberField>(dialog_, "Margin (mm)"), "3");
    EXPECT_EQ(shown().page.width, 80);
    EXPECT_EQ(shown().page.margin, 3);
    test::click(test::saying<QCheckBox>(dialog_, "Text&s in the figure"));
    for (const Layer& layer : shown().figure.layers)
        EXPECT_TRUE(layer.labels.empty());
    test::named<QComboBox>(dialog_, "Colours").setCurrentIndex(1);
    EXPECT_EQ(shown().theme, Theme::dark);
    const FigureFileOptions options = dialog_.options();
    EXPECT_EQ(options.drawing.width, 80);
    EXPECT_EQ(options.drawing.theme, Theme::dark);
    EXPECT_FALSE(options.drawing.hasLabels);
}

TEST_F(ExportDialogTest, takesAWidthOrAScale) {
    test::click(test::saying<QCheckBox>(dialog_, "Set the scale"));
    test::type(test::named<NumberField>(dialog_, "Scale (mm for a unit)"), "2.5");
    EXPECT_EQ(shown().page.mmPerUnit, 2.5);
    EXPECT_EQ(dialog_.options().drawing.mmPerUnit, 2.5);
    test::click(test::saying<QCheckBox>(dialog_, "Set the &width"));
    test::type(test::named<NumberField>(dialog_, "Width (mm)"), "80");
    EXPECT_EQ(shown().page.width, 80);
    EXPECT_EQ(dialog_.options().drawing.mmPerUnit, std::nullopt) << "one of them decides";
}

TEST_F(ExportDialogTest, hasTheLayersOfTheSheet) {
    auto& layers = test::named<QListWidget>(dialog_, "Layers");
    ASSERT_EQ(layers.count(), static_cast<int>(layersOf(sheet_).size()));
    for (int i = 0; i < layers.count(); ++i)
        layers.item(i)->setCheckState(layersOf(sheet_)[static_cast<std::size_t>(i)].name == "curve" ? Qt::Checked
                                                                                                    : Qt::Unchecked);
    ASSERT_EQ(shown().figure.layers.size(), 1U);
    EXPECT_EQ(shown().figure.layers[0].name, "curve");
    EXPECT_EQ(dialog_.options().drawing.layers, (std::vector<std::string>{"curve"}));
}

TEST_F(ExportDialogTest, offersNoFramesOfASpline) {
    EXPECT_FALSE(offers("Frames"));
}

TEST(ExportDialogOfAnimation, showsTheFramesSideBySide) {
    Document document;
    document.sheets[test::kElevation].curves = {
        withPointsAdded(emptyCurve(test::kElevation), Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}})};
    QThreadPool workers;
    ExportDialog dialog(sheetToExport(document, test::kElevation), {}, workers);
    dialog.show();
    const auto width = [&] { return boxOf(shownIn(dialog, workers).figure).width(); };
    EXPECT_EQ(width(), 4);
    test::type(test::named<QLineEdit>(dialog, "Frames"), "0; 2");
    EXPECT_GT(width(), 8);
    EXPECT_EQ(dialog.options().frames,
              (std::vector<FramePlace>{{FramePlace::Over::stage, 0}, {FramePlace::Over::stage, 2}}));
    EXPECT_FALSE(dialog.options().isAnimated);
    test::click(test::saying<QCheckBox>(dialog, "A&nimated"));
    EXPECT_TRUE(dialog.options().isAnimated);
    test::type(test::named<NumberField>(dialog, "Seconds of a frame"), "0.2");
    EXPECT_EQ(dialog.options().frameSeconds, 0.2);
}

TEST_F(ExportDialogTest, offersWhatTheFormatHas) {
    EXPECT_TRUE(offers("Decimals"));
    EXPECT_FALSE(offers("Dots per inch"));
    chooseFormat(FigureFormat::png);
    EXPECT_FALSE(offers("Decimals"));
    EXPECT_TRUE(offers("Dots per inch"));
    test::click(test::saying<QCheckBox>(dialog_, "&Transparent"));
    EXPECT_FALSE(shown().hasPaper);
    chooseFormat(FigureFormat::pdf);
    EXPECT_TRUE(shown().hasPaper);
    chooseFormat(FigureFormat::csv);
    EXPECT_FALSE(offers("Width (mm)"));
    EXPECT_EQ(dialog_.options().format, FigureFormat::csv);
}

TEST_F(ExportDialogTest, beginsWithWhatWasChosenTheLastTime) {
    FigureFileOptions options;
    options.format = FigureFormat::png;
    options.drawing = {.width = 77, .margin = 2, .layers = {{"curve", "knots"}}, .hasLabels = false};
    options.dpi = 150;
    options.isTransparent = true;
    const ExportDialog again(sheetToExport(document().value(), sheet_), options, shell.window.workers());
    const FigureFileOptions kept = again.options();
    EXPECT_EQ(kept.format, FigureFormat::png);
    EXPECT_EQ(kept.drawing.width, 77);
    EXPECT_EQ(kept.drawing.margin, 2);
    EXPECT_EQ(kept.drawing.layers, options.drawing.layers);
    EXPECT_FALSE(kept.drawing.hasLabels);
    EXPECT_EQ(kept.dpi, 150);
    EXPECT_TRUE(kept.isTransparent);
}

TEST(ExportDialogOfPlots, hasWhatPlotsHave) {
    Plot plot;
    plot.lines = {{graphPath(std::vector<double>{0, 1}, 0, 1), Role::plotLine, 0, Caption::none, "B", "1"}};
    FigureFileOptions options;
    options.drawing.margin = 2;
    QThreadPool workers;
    ExportDialog dialog(plotsToExport({plot, plot}), options, workers);
    dialog.show();
    const auto offers = [&](const char* text) {
        const auto boxes = dialog.findChildren<QCheckBox*>();
        return std::ranges::any_of(
            boxes, [&](const QCheckBox* box) { return box->isVisible() && box->text() == QLatin1String(text); });
    };
    EXPECT_TRUE(offers("Set the &width"));
    EXPECT_FALSE(offers("Set the scale"));
    EXPECT_FALSE(offers("The document &goes along, to open the file again"));
    EXPECT_EQ(test::named<QComboBox>(dialog, "Format").count(), 4) << "it has no points";
    test::click(test::saying<QCheckBox>(dialog, "Set the &width"));
    test::type(test::named<NumberField>(dialog, "Width (mm)"), "84");
    EXPECT_EQ(shownIn(dialog, workers).page.width, 84);
    EXPECT_EQ(shownIn(dialog, workers).page.height, 104) << "two of 80 by 50 and the margin";
    auto& layers = test::named<QListWidget>(dialog, "Layers");
    ASSERT_EQ(layers.item(0)->text(), QStringLiteral("Grid"));
    layers.item(0)->setCheckState(Qt::Unchecked);
    EXPECT_NE(shownIn(dialog, workers).figure.layers.front().name, "plot-grid");
    EXPECT_EQ(dialog.options().drawing.layers->size(), 6U);
    test::click(test::saying<QCheckBox>(dialog, "Text&s in the figure"));
    for (const Layer& layer : shownIn(dialog, workers).figure.layers)
        EXPECT_TRUE(layer.labels.empty());
}

class FigureExportTest : public test::PanelTest {
  protected:
    FigureExportTest()
        : PanelTest(test::kElevation) {}
    void trigger(const char* action) { shell.window.findChild<QAction*>(QLatin1String(action))->trigger(); }
};

TEST_F(FigureExportTest, copiesThreeFormatsAtOnce) {
    trigger("copyFigure");
    const QMimeData& clip = *QGuiApplication::clipboard()->mimeData();
    EXPECT_TRUE(clip.data(QStringLiteral("image/svg+xml")).contains("<svg"));
    EXPECT_TRUE(clip.data(QStringLiteral("application/pdf")).startsWith("%PDF"));
    EXPECT_TRUE(clip.data(QStringLiteral("image/png")).startsWith("\x89PNG"));
    EXPECT_EQ(steps(), QStringList());
}

TEST_F(FigureExportTest, copiesTikzToBePutIntoADocument) {
    trigger("copyTikz");
    const QString text = QGuiApplication::clipboard()->text();
    EXPECT_TRUE(text.contains(QStringLiteral("\\begin{tikzpicture}")));
    EXPECT_FALSE(text.contains(QStringLiteral("\\documentclass")));
}

TEST_F(ExportDialogTest, remembersItsOptionsInTheDocumentWithoutModifyingIt) {
    FigureFileOptions options;
    options.drawing.width = 77;
    options.hasOutlines = true;
    document().setExported(sheet_, options);
    EXPECT_FALSE(document().isModified());
    shell.window.findChild<QAction*>(QStringLiteral("copyFigure"))->trigger();
    const QByteArray svg = QGuiApplication::clipboard()->mimeData()->data(QStringLiteral("image/svg+xml"));
    EXPECT_TRUE(svg.contains("width=\"77mm\""));
    EXPECT_FALSE(svg.contains("<text"));
    const auto read = readAnyDocument(svg.toStdString());
    EXPECT_EQ(std::get<Document>(read).sheets[sheet_].view.exported, options);
}

} // namespace
} // namespace kriva::ui
