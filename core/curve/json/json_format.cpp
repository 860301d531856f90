#include "core/curve/json/json_format.h"

namespace kriva {

void requireFormat(const JsonObject& object, std::string_view format, int newest) {
    const JsonNode& name = object.require("format");
    if (name.text() != format)
        name.refuse(FileProblem::foreignFormat);
    const JsonNode& version = object.require("version");
    if (const int number = version.wholeNumber(1, static_cast<int>(limits::kNumber)); number > newest)
        version.refuse(FileProblem::unknownVersion, {static_cast<double>(number)});
}

} // namespace kriva
