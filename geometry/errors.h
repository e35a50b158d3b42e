#pragma once

#include <stdexcept>

namespace gnomon {

/// A function was called although what its doc block requires does not hold: a mistake of the caller, not of the data.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace gnomon
