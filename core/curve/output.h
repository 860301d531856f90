#pragma once

namespace kriva {

/// What is made of a whole sheet and may be refused where it would take too long. A later one takes what an earlier
/// one takes.
enum class Output {
    figure,     ///< a file of it
    report,     ///< for people
    reportJson, ///< with every number
};

} // namespace kriva
