#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "apps/gnomon/commands.h"

namespace gnomon {

/// True for every element if the name is empty, for the element of that name, and for the parts `NAME#0`, `NAME#1` of
/// one that is taken as several.
inline bool is_asked_for(const std::string& wanted, const std::string& name) {
  return wanted.empty() || name == wanted || (name.size() > wanted.size() + 1 && name.starts_with(wanted + '#'));
}

/// Accepts an empty name, which asks for all elements, and the name of one of them or of one that has parts.
///
/// Throws: UsageError that names the option, the name, and the names there are.
template <class Element>
void require_name(const std::string& option, const std::string& kind, const std::string& name,
                  const std::vector<Element>& elements) {
  const auto has_name = [&name](const Element& element) { return is_asked_for(name, element.name); };
  if (name.empty() || std::any_of(elements.begin(), elements.end(), has_name)) return;
  std::string known;
  for (const Element& element : elements) known += (known.empty() ? "'" : ", '") + element.name + "'";
  throw UsageError(option + ": the scene has no " + kind + " '" + name + "'; it has " +
                   (known.empty() ? "none" : known));
}

/// The lights of that name, or all of them if it is empty, in file order.
///
/// Throws: UsageError for a name that the scene does not have.
template <class SomeLight>
std::vector<const SomeLight*> chosen_lights(const std::vector<SomeLight>& lights, const std::string& name) {
  require_name("--light", "light", name, lights);
  std::vector<const SomeLight*> chosen;
  for (const SomeLight& light : lights) {
    if (is_asked_for(name, light.name)) chosen.push_back(&light);
  }
  return chosen;
}

}  // namespace gnomon
