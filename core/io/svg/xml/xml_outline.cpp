#include "core/io/svg/xml/xml_outline.h"

#include "core/curve/limits.h"
#include "core/io/svg/xml/xml_characters.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace kriva {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

bool isXmlBlank(char c) {
    return kBlanks.find(c) != std::string_view::npos;
}

/// Bytes of characters beyond ASCII are taken for letters.
bool isNameStart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool isNameCharacter(char c) {
    return isNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// Goes through a text from mark to mark. Each function that gives a bool gives false where there is a fault.
class XmlOutline {
  public:
    explicit XmlOutline(std::string_view xml)
        : xml_(xml) {}

    [[nodiscard]] std::optional<FileError> error() && {
        if (!declaration())
            return fault_;
        while (at_ < xml_.size())
            if (!(xml_[at_] == '<' ? markup() : text()))
                return fault_;
        if (!open_.empty() || !hasRoot_)
            refuse(FileProblem::notXml, at_);
        return fault_;
    }

  private:
    bool refuse(FileProblem problem, std::size_t byte, std::vector<double> numbers = {},
                std::vector<std::string> words = {}) {
        fault_ = errorAtByte(problem, xml_, byte);
        fault_->numbers = std::move(numbers);
        fault_->words = std::move(words);
        return false;
    }
    bool refuse(FileProblem problem) { return refuse(problem, at_); }

    [[nodiscard]] bool isNext(std::string_view text) const { return xml_.substr(at_).starts_with(text); }
    bool take(std::string_view text) {
        if (!isNext(text))
            return false;
        at_ += text.size();
        return true;
    }
    bool takeBlanks() {
        const std::size_t before = at_;
        at_ = std::min(xml_.find_first_not_of(kBlanks, at_), xml_.size());
        return at_ != before;
    }
    /// Empty where there is none.
    std::string_view takeName() {
        std::size_t end = at_;
        while (end < xml_.size() && (end == at_ ? isNameStart(xml_[end]) : isNameCharacter(xml_[end])))
            ++end;
        const std::string_view name = xml_.substr(at_, end - at_);
        at_ = end;
        return name;
    }
    bool skipPast(std::string_view end) {
        const std::size_t found = xml_.find(end, at_);
        if (found == std::string_view::npos)
            return refuse(FileProblem::notXml);
        at_ = found + end.size();
        return true;
    }

    bool declaration();
    bool text();
    bool reference();
    bool markup();
    bool comment();
    bool instruction();
    bool documentType();
    bool startTag();
    bool attributes();
    bool attribute();
    bool endTag();

    std::string_view xml_;
    std::size_t at_ = 0;
    std::vector<std::string_view> open_;       ///< names of the elements around
    std::vector<std::string_view> attributes_; ///< names of those of the tag that is read
    int elements_ = 0;
    bool hasRoot_ = false;
    bool hasDocumentType_ = false;
    std::optional<FileError> fault_;
};

bool XmlOutline::declaration() {
    take("\xEF\xBB\xBF");
    if ((fault_ = xmlCharacterError(xml_)))
        return false;
    if (isNext("<?xml") && at_ + 5 < xml_.size() && isXmlBlank(xml_[at_ + 5]))
        return skipPast("?>");
    return true;
}

bool XmlOutline::text() {
    if (open_.empty()) {
        takeBlanks();
        return at_ == xml_.size() || isNext("<") || refuse(hasRoot_ ? FileProblem::secondRoot : FileProblem::notXml);
    }
    for (; at_ < xml_.size() && xml_[at_] != '<'; ++at_) {
        if (xml_[at_] == '&' && !reference())
            return false;
        if (isNext("]]>"))
            return refuse(FileProblem::notXml);
    }
    return true;
}

/// Goes on to its last character.
bool XmlOutline::reference() {
    constexpr std::array<std::string_view, 5> kEntities{"lt", "gt", "amp", "quot", "apos"};
    const std::size_t start = at_++;
    if (const std::size_t size = characterReferenceSize(xml_.substr(start)); size > 0) {
        at_ = start + size - 1;
        return true;
    }
    const std::string_view name = takeName();
    if (name.empty() || !isNext(";"))
        return refuse(FileProblem::notXml, start);
    if (std::ranges::find(kEntities, name) == kEntities.end())
        return refuse(FileProblem::unknownEntity, start, {}, {std::string(name)});
    return true;
}

bool XmlOutline::markup() {
    if (isNext("<!--"))
        return comment();
    if (isNext("<?"))
        return instruction();
    if (isNext("<![CDATA["))
        return open_.empty() ? refuse(FileProblem::notXml) : skipPast("]]>");
    if (isNext("<!DOCTYPE"))
        return documentType();
    return isNext("</") ? endTag() : startTag();
}

bool XmlOutline::comment() {
    const std::size_t start = at_;
    take("<!--");
    return (skipPast("--") && take(">")) || refuse(FileProblem::notXml, start);
}

bool XmlOutline::instruction() {
    const std::size_t start = at_;
    take("<?");
    std::string target(takeName());
    std::ranges::transform(target, target.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 0x20) : c; });
    return target.empty() || target == "xml" ? refuse(FileProblem::notXml, start) : skipPast("?>");
}

bool XmlOutline::documentType() {
    const std::size_t start = at_;
    if (std::exchange(hasDocumentType_, true) || hasRoot_)
        return refuse(FileProblem::notXml);
    char quote = 0;
    for (; at_ < xml_.size(); ++at_) {
        const char c = xml_[at_];
        if (quote != 0)
            quote = c == quote ? 0 : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '[')
            return refuse(FileProblem::internalSubset, start);
        else if (c == '>')
            return take(">");
    }
    return refuse(FileProblem::notXml, start);
}

bool XmlOutline::startTag() {
    const std::size_t start = at_;
    take("<");
    const std::string_view name = takeName();
    if (name.empty())
        return refuse(FileProblem::notXml, start);
    if (open_.empty() && std::exchange(hasRoot_, true))
        return refuse(FileProblem::secondRoot, start);
    if (++elements_ > limits::kXmlElements)
        return refuse(FileProblem::tooManyElements, start, {limits::kXmlElements});
    if (open_.size() == limits::kXmlNesting)
        return refuse(FileProblem::nestedTooDeep, start, {limits::kXmlNesting});
    if (!attributes())
        return false;
    if (attributes_.size() > limits::kXmlAttributes)
        return refuse(FileProblem::tooManyAttributes, start, {limits::kXmlAttributes});
    std::ranges::sort(attributes_);
    if (const auto twice = std::ranges::adjacent_find(attributes_); twice != attributes_.end())
        return refuse(FileProblem::repeatedAttribute, start, {}, {std::string(*twice)});
    if (take("/>"))
        return true;
    open_.push_back(name);
    return take(">") || refuse(FileProblem::notXml);
}

/// Goes on to the end of the tag.
bool XmlOutline::attributes() {
    attributes_.clear();
    while (takeBlanks() && at_ < xml_.size() && !isNext(">") && !isNext("/")) {
        if (!attribute())
            return false;
        if (attributes_.size() > limits::kXmlAttributes)
            return true;
    }
    return true;
}

bool XmlOutline::attribute() {
    attributes_.push_back(takeName());
    takeBlanks();
    if (attributes_.back().empty() || !take("="))
        return refuse(FileProblem::notXml);
    takeBlanks();
    const char quote = at_ < xml_.size() ? xml_[at_] : '\0';
    if (quote != '"' && quote != '\'')
        return refuse(FileProblem::notXml);
    for (++at_; at_ < xml_.size() && xml_[at_] != quote; ++at_) {
        if (xml_[at_] == '&' && !reference())
            return false;
        if (xml_[at_] == '<')
            return refuse(FileProblem::notXml);
    }
    return take({&quote, 1}) || refuse(FileProblem::notXml);
}

bool XmlOutline::endTag() {
    const std::size_t start = at_;
    take("</");
    const std::string_view name = takeName();
    takeBlanks();
    if (open_.empty() || name != open_.back() || !take(">"))
        return refuse(FileProblem::notXml, start);
    open_.pop_back();
    return true;
}

} // namespace

std::optional<FileError> xmlError(std::string_view xml) {
    return XmlOutline(xml).error();
}

} // namespace kriva
