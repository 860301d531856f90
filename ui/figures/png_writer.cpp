#include "ui/figures/png_writer.h"

#include <QtGlobal>

namespace kriva::ui {
namespace {

/// Of zlib: higher levels look longer for repetitions, and find hardly more of them in a drawing.
constexpr int kCompression = 3;
constexpr int kBitsOfChannel = 8;

// The library must not come back from this, and a jump would leave destructors out. What is left to go wrong where
// files are made in memory is the memory itself, for whose lack Qt ends the program too.
[[noreturn]] void fail(png_structp /*png*/, png_const_charp message) {
    qFatal("PNG: %s", message);
}

void append(png_structp png, png_bytep data, std::size_t size) {
    static_cast<QByteArray*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
}

} // namespace

PngWriter::PngWriter(QSize size, Ground ground, int dotsPerMetre)
    : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr))
    , info_(png_create_info_struct(png_))
    , ground_(ground) {
    png_set_write_fn(png_, &bytes_, append, nullptr);
    png_set_compression_level(png_, kCompression);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(size.width()), static_cast<png_uint_32>(size.height()),
                 kBitsOfChannel, ground == Ground::paper ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(png_, info_, static_cast<png_uint_32>(dotsPerMetre), static_cast<png_uint_32>(dotsPerMetre),
                 PNG_RESOLUTION_METER);
    png_write_info(png_, info_);
    if (ground == Ground::paper)
        png_set_filler(png_, 0, PNG_FILLER_AFTER); // of the rows, which have four channels
}

PngWriter::~PngWriter() {
    png_destroy_write_struct(&png_, &info_);
}

void PngWriter::add(const QImage& picture, int top, int rows) {
    const auto format = ground_ == Ground::paper ? QImage::Format_RGBX8888 : QImage::Format_RGBA8888;
    for (int y = top; y < top + rows; ++y) {
        QImage row(picture.constScanLine(y), picture.width(), 1, picture.bytesPerLine(), picture.format());
        row.convertTo(format);
        png_write_row(png_, row.constScanLine(0));
    }
}

QByteArray PngWriter::finish() {
    png_write_end(png_, nullptr);
    return std::move(bytes_);
}

} // namespace kriva::ui
