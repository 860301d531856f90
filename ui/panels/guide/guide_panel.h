#pragma once

#include <QHash>
#include <QImage>
#include <QTextBrowser>

namespace kriva::ui {

struct Example;

/// The page of the guide about a tab, :/guide/LANGUAGE/SHEET.html in the present language, with pictures that are
/// painted for the panel's width and the window's theme. It shows the program's own pages and nothing else.
class GuidePanel : public QTextBrowser {
    Q_OBJECT
  public:
    explicit GuidePanel(const QString& sheet, QWidget* parent = nullptr);

    /// What to look at in the example that was opened stands above the page; nothing where it is null.
    void setExample(const Example* example);

  protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void doSetSource(const QUrl&, QTextDocument::ResourceType) override {} // a link leads nowhere but down the page
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void retranslateUi();
    /// The page is written anew when it is seen: most of the time another panel lies over it.
    void invalidate();
    void write();
    [[nodiscard]] QString source() const;
    [[nodiscard]] QString note() const;
    [[nodiscard]] QString styleSheetOfPage() const;
    [[nodiscard]] int pictureWidth() const;

    QString sheet_;
    const Example* example_ = nullptr;
    bool isStale_ = true;
    int writtenWidth_ = 0;            ///< of the pictures
    QHash<QString, QImage> pictures_; ///< of the page as it is written
};

} // namespace kriva::ui
