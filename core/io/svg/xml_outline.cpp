#include "core/io/svg/xml_outline.h"

#include "core/document/limits.h"

namespace kriva {
namespace {

class Outline {
  public:
    explicit Outline(std::string_view xml)
        : xml_(xml) {}

    [[nodiscard]] std::optional<FileError> limitError();

  private:
    [[nodiscard]] std::optional<FileError> refused(FileProblem problem, double limit) const {
        FileError error = errorAtByte(problem, xml_, start_);
        error.numbers = {limit};
        return error;
    }
    [[nodiscard]] bool startsWith(std::string_view text) const { return xml_.substr(start_).starts_with(text); }
    void skipPast(std::string_view end) {
        const std::size_t found = xml_.find(end, start_);
        at_ = found == std::string_view::npos ? xml_.size() : found + end.size();
    }
    /// Reads on to the end of the tag at start_; visits what stands outside of quotes.
    template <class Visit>
    void readTag(Visit visit);
    [[nodiscard]] std::optional<FileError> documentType();
    [[nodiscard]] std::optional<FileError> element();

    std::string_view xml_;
    std::size_t start_ = 0; ///< of the tag that is looked at
    std::size_t at_ = 0;
    int depth_ = 0;
    int elements_ = 0;
};

template <class Visit>
void Outline::readTag(Visit visit) {
    char quote = 0;
    for (at_ = start_ + 1; at_ < xml_.size(); ++at_) {
        const char c = xml_[at_];
        if (quote != 0)
            quote = c == quote ? 0 : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            break;
        else
            visit(c);
    }
}

std::optional<FileError> Outline::documentType() {
    bool hasSubset = false;
    readTag([&](char c) { hasSubset = hasSubset || c == '['; });
    if (hasSubset)
        return refused(FileProblem::internalSubset, 0);
    return {};
}

std::optional<FileError> Outline::element() {
    int attributes = 0;
    char last = 0;
    readTag([&](char c) {
        attributes += c == '=' ? 1 : 0;
        last = c;
    });
    if (attributes > limits::kXmlAttributes)
        return refused(FileProblem::tooManyAttributes, limits::kXmlAttributes);
    if (++elements_ > limits::kXmlElements)
        return refused(FileProblem::tooManyElements, limits::kXmlElements);
    if (depth_ + 1 > limits::kXmlNesting)
        return refused(FileProblem::nestedTooDeep, limits::kXmlNesting);
    if (last != '/')
        ++depth_;
    return {};
}

std::optional<FileError> Outline::limitError() {
    for (start_ = xml_.find('<'); start_ != std::string_view::npos; start_ = xml_.find('<', at_)) {
        std::optional<FileError> error;
        if (startsWith("<!--"))
            skipPast("-->");
        else if (startsWith("<![CDATA["))
            skipPast("]]>");
        else if (startsWith("<?"))
            skipPast("?>");
        else if (startsWith("<!"))
            error = documentType();
        else if (startsWith("</")) {
            skipPast(">");
            --depth_;
        } else
            error = element();
        if (error)
            return error;
    }
    return {};
}

} // namespace

std::optional<FileError> xmlLimitError(std::string_view xml) {
    return Outline(xml).limitError();
}

} // namespace kriva
