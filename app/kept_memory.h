#pragma once

namespace kriva {

/// Keeps memory that is freed for what is asked for next. A long curve is a new value at every move of the hand, tens
/// of megabytes with its figure; to give them back and to be given them anew takes the system as long as all the work.
/// To be called before anything large is there.
void keepFreedMemory();

} // namespace kriva
