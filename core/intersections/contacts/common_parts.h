#pragma once

#include "core/intersections/contacts/segment_contacts.h"

namespace kriva {

/// The stretches along which two segments lie on each other, each as long as can be, found between the given contacts,
/// of which those at the ends of the segments must not miss. Stretches shorter than a place are none.
[[nodiscard]] std::vector<CommonPart> commonParts(const Arc& a, const Arc& b, std::vector<Contact> contacts,
                                                  const ContactScale& scale, WorkBudget& budget);

} // namespace kriva
