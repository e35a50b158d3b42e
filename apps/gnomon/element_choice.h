#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "apps/gnomon/commands.h"

namespace gnomon {

/// Accepts an empty name, which asks for all elements, and the name of one of them.
///
/// Throws: UsageError that names the option, the name, and the names there are.
template <class Element>
void require_name(const std::string& option, const std::string& kind, const std::string& name,
                  const std::vector<Element>& elements) {
  const auto has_name = [&name](const Element& element) { return element.name == name; };
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
    if (name.empty() || light.name == name) chosen.push_back(&light);
  }
  return chosen;
}

}  // namespace gnomon
