#pragma once

#include "apps/gnomon/command_line.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// Adds --linear-search.
void add_linear_search_option(CommandLine& app, CommonOptions& options);

/// The search that was asked for, or the usual one.
///
/// Throws: UsageError for a name that is none, or a number of parts that the search does not take.
LinearSearch linear_search(const CommonOptions& options);

/// The same for a scene that may be of the plane.
///
/// Throws: UsageError also if a search was asked for there.
LinearSearch linear_search(const CommonOptions& options, const Scene& scene);

}  // namespace gnomon
