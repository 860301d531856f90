#pragma once

#include "core/document/report.h"
#include "core/io/json/document_json.h"

#include <gtest/gtest.h>

namespace kriva::test {

/// A document with one curve, written as JSON, in one sheet.
inline std::string documentWith(std::string_view sheet, std::string_view curve) {
    return std::string(R"({"format":"kriva","version":1,"sheets":{")")
        .append(sheet)
        .append(R"(":{"curves":[)")
        .append(curve)
        .append("]}}}");
}

/// Why a document is refused; fails where it is not.
inline FileError refusalOf(std::string_view text) {
    const auto read = readDocument(text);
    if (const FileError* error = std::get_if<FileError>(&read))
        return *error;
    ADD_FAILURE() << "not refused: " << text.substr(0, 1000);
    return {};
}

/// The document; fails where it is refused.
inline Document documentOf(std::string_view text) {
    const auto read = readDocument(text);
    if (const Document* document = std::get_if<Document>(&read))
        return *document;
    ADD_FAILURE() << "refused at " << std::get<FileError>(read).place << ": " << text.substr(0, 1000);
    return {};
}

/// The one curve of a document with one curve of that kind.
template <class C>
C curveOf(std::string_view curve) {
    const Document document = documentOf(documentWith(C::kSheet, curve));
    const std::optional<SheetIndex> sheet = sheetNamed(C::kSheet);
    const std::vector<Curve>& curves = document.sheets[*sheet].curves;
    return curves.empty() ? C{} : std::get<C>(curves.front());
}

/// A document that holds one curve.
template <class C>
Document documentOfCurve(C curve) {
    Document document;
    document.sheets[*sheetNamed(C::kSheet)].curves.emplace_back(std::move(curve));
    return document;
}

/// The report of a document with one curve.
template <class C>
std::string reportOf(C curve) {
    return std::get<std::string>(reportJson(documentOfCurve(std::move(curve)), "test.kriva"));
}

} // namespace kriva::test
