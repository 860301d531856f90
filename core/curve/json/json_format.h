#pragma once

#include "core/curve/json/json_node.h"

#include <concepts>
#include <string_view>
#include <variant>

namespace kriva {

/// What `read` makes of the root of a JSON text, or the first fault that it or parseJson finds.
template <std::invocable<const JsonNode&> Read>
[[nodiscard]] auto readJson(std::string_view text, Read read)
    -> std::variant<std::invoke_result_t<Read, const JsonNode&>, FileError> {
    std::variant<JsonTape, FileError> tape = parseJson(text);
    if (FileError* error = std::get_if<FileError>(&tape))
        return std::move(*error);
    try {
        return read(JsonNode(std::get<JsonTape>(tape)));
    } catch (Refused& refused) {
        return std::move(refused.error);
    }
}

/// Refuses an object whose "format" is another one or whose "version" is no whole number from 1 to `newest`.
void requireFormat(const JsonObject& object, std::string_view format, int newest);

} // namespace kriva
