#pragma once

#include <string_view>

namespace gnomon {

/// How an extremal line or plane holds the light and the blocker.
///
/// After: [CF91] §3.1, [P93] §4.2.
enum class Contact {
  separating,  ///< light and blocker on opposite closed sides: bounds the occlusion ("minimum" in the papers)
  supporting,  ///< both on one closed side: bounds the umbra ("maximum" in the papers)
};

/// The contact's name as scripts read it.
constexpr std::string_view name(Contact contact) {
  return contact == Contact::separating ? "separating" : "supporting";
}

}  // namespace gnomon
