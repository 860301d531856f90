#include "core/io/svg/svg_writer.h"
#include "tests/support/sheet_curves.h"
#include "ui/document/document_file.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QTemporaryDir>

namespace kriva::ui {
namespace {

Document arch() {
    Document document;
    document.title = "arch";
    document.sheets[test::kElevation].curves.emplace_back(ElevationCurve{"", {{-0.0, 0.1}, {1, 2}, {4, 0}}, 3, {}, {}});
    return document;
}

class DocumentFile : public testing::Test {
  protected:
    [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }

  private:
    QTemporaryDir folder_;
};

TEST_F(DocumentFile, comesBackAsItWasSaved) {
    EXPECT_FALSE(saveDocument(path("arch.kriva"), arch()));
    const auto loaded = loadDocument(path("arch.kriva"));
    ASSERT_TRUE(std::holds_alternative<LoadedFile>(loaded));
    EXPECT_EQ(std::get<LoadedFile>(loaded).document, arch());
    EXPECT_FALSE(std::get<LoadedFile>(loaded).drawn);
}

TEST_F(DocumentFile, opensAFigureWithItsDocumentInside) {
    const TextSource texts{[](Caption) { return "Word"; }, [](double, int) { return std::string(); }, "en"};
    EXPECT_FALSE(
        safeWrite(path("arch.svg"), QByteArray::fromStdString(writeSheetSvg(arch(), test::kElevation, texts))));
    const auto loaded = loadDocument(path("arch.svg"));
    ASSERT_TRUE(std::holds_alternative<LoadedFile>(loaded));
    EXPECT_EQ(std::get<LoadedFile>(loaded).document, arch());
    EXPECT_FALSE(std::get<LoadedFile>(loaded).drawn);
}

TEST_F(DocumentFile, saysWhyItCannotBeOpenedOrSaved) {
    const auto missing = loadDocument(path("none.kriva"));
    EXPECT_EQ(std::get<ReadError>(std::get<OpenError>(missing)).fault, ReadFault::Missing);
    EXPECT_FALSE(safeWrite(path("broken.kriva"), QByteArrayView("{")));
    const auto broken = loadDocument(path("broken.kriva"));
    EXPECT_EQ(std::get<FileError>(std::get<OpenError>(broken)).problem, FileProblem::notJson);
    EXPECT_EQ(saveDocument(path("none/arch.kriva"), arch()).value().fault, WriteFault::NoFolder);
}

} // namespace
} // namespace kriva::ui
